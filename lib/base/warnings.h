// SPDX-License-Identifier: BSD-3-Clause
// The receiving end of base::warn(): where a tool's run() (or a test) takes the warnings from.
#pragma once
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace base {

// Called with "place: fact" for the first warning of each cause; an empty function silences (option -w-).
void set_warning_sink(std::function<void(const std::string&)> sink);

// False once a tool silenced them by an empty sink.
bool warnings_are_shown();

// All causes so far with their counts; forgets them.
std::vector<std::pair<std::string, long>> take_warnings();

}  // namespace base
