// SPDX-License-Identifier: BSD-3-Clause
// Answers of the server, apart from how they are sent: functions of the question and of what there is to show.
#pragma once
#include <optional>
#include <string>
#include "live/live.h"
#include "live/sources.h"

namespace live {

// GET /next.  Nothing: there is no news yet.
std::optional<Answer> answer_next(const Live& live, const Arguments& arguments);
// GET /sources, /report and /plan, whose option of vcmetrics this is.  Nothing: they are not known yet.
std::optional<Answer> answer_asked(Asked& asked, const std::string& option, const Arguments& arguments);
// GET /what: what ptrace says of a place of the newest picture.  Nothing: it has been asked, or is to be.
std::optional<Answer> answer_what(const State& s, const Arguments& arguments);
bool is_to_be_asked(const State& s, const Arguments& arguments);
// The other questions of GET.
Answer answer_query(const State& s, const std::string& path, const Arguments& arguments);

}  // namespace live
