// SPDX-License-Identifier: BSD-3-Clause
// A "!command" line taken apart as /bin/sh would: quotes, backslashes, comments, file name patterns, pipes.
// The first command may take a file as its input.  A line that needs more of a shell (variables, lists ...) is only
// marked as such.
#pragma once
#include <string>
#include <vector>

namespace scene {

struct Stage {
    std::vector<std::string> words;
    std::string input;          // "< file"
    size_t begin = 0, end = 0;  // its text within the line
};
struct CommandLine {
    std::vector<Stage> stages;  // "a | b | c"
    char needs_shell = 0;       // the first character that only a shell understands; 0 = none
};
// A backslash takes the meaning from the character after it.  Letters, digits and dots have none to lose: there it
// stands in a path that was written on Windows.
bool in_a_path(char after_backslash);
CommandLine split_command(const std::string& line, const std::string& place);

}  // namespace scene
