// SPDX-License-Identifier: BSD-3-Clause
// Which files this process has read, for rules of make (ptrace -M): whoever opens one by name says so.
#pragma once
#include <string>
#include <vector>

namespace base {

void note_file_read(const std::string& path);

// Each once, in the order in which they were first read.
std::vector<std::string> files_read();

// "target: file file", and an empty rule for each file, so that make does not stop where one has been removed.
std::string make_rule(const std::string& target, const std::vector<std::string>& files);

}  // namespace base
