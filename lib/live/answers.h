// SPDX-License-Identifier: BSD-3-Clause
// Answers of the server, apart from how they are sent: functions of the question and of what there is to show.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include "live/files.h"
#include "live/live.h"
#include "live/sources.h"

namespace live {

struct Answer {
    unsigned status = 200;
    std::string type = "application/json";
    std::string body;
    std::string tag = {};  // of a file
};
Answer plain(unsigned status, const std::string& text);

// The value of an argument of the question; empty if it is not there.
using Arguments = std::function<std::string(const char* name)>;

// The file that the question names; null: there is none.
const TextFile* named(const Files& files, const Arguments& arguments);

// GET /next.  Nothing: there is no news yet.
std::optional<Answer> answer_next(Live& live, const Arguments& arguments);
// GET /sources.  Nothing: they are not known yet.
std::optional<Answer> answer_sources(Asked& sources, const Arguments& arguments);
// GET /report, likewise.
std::optional<Answer> answer_report(Asked& report, const Arguments& arguments);
// GET /plan, likewise.
std::optional<Answer> answer_plan(Asked& plan, const Arguments& arguments);
// The other questions of GET.
Answer answer_query(const Live& live, const Files& files, const std::string& path, const Arguments& arguments);
// PUT /file: the new text, and the tag of the text that it was made from.
Answer answer_put(Live& live, const Files& files, const Arguments& arguments, const std::string& text,
                  const std::string& tag);

}  // namespace live
