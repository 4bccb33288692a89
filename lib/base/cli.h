// SPDX-License-Identifier: BSD-3-Clause
// CLI11 with our habits: words as options (-every, one dash or two), a repeated option's last value wins,
// errors are our one line with status 1, -help and -version go to stdout with status 0.
// Declare options to CLI11 as "--every"; the help text and messages show one dash.
#pragma once
#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

namespace base {

// Nothing: go on.  A status: help or version was printed, main() ends with it.
std::optional<int> parse_cli(CLI::App& app, int argc, char** argv, const std::string& version);
std::optional<int> parse_cli(CLI::App& app, std::vector<std::string> words, const std::string& version);

}  // namespace base
