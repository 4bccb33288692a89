// SPDX-License-Identifier: BSD-3-Clause
// The kinds of trials of break_files, each of which knows what a tool may answer (files.cpp).
#pragma once
#include <optional>

#include "campaign.h"

namespace breaking {

// Runs one tool in the folder; the words after its name.
Result run_tool(const Settings& settings, const std::string& folder, const std::string& tool,
                std::vector<std::string> words, std::vector<std::string> environment = {});

// Numbers as written, among them those that a comma, a letter or a second point makes none; what strtod reads of all of
// them, or nothing.
std::string spelled_number(Dice& dice, double value);
std::optional<double> number_in(const std::string& text);

Verdict try_regions(const Settings& settings, Dice& dice, const std::string& folder);  // file_regions.cpp
Verdict try_special(const Settings& settings, Dice& dice, const std::string& folder);  // files.cpp
Verdict try_windows(const Settings& settings, Dice& dice, const std::string& folder);  // file_windows.cpp
Verdict try_header(const Settings& settings, Dice& dice, const std::string& folder);   // file_numbers.cpp
Verdict try_clock(const Settings& settings, Dice& dice, const std::string& folder);    // file_numbers.cpp

}  // namespace breaking
