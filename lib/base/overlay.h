// SPDX-License-Identifier: BSD-3-Clause
// Text that stands for a file, wherever open_file() opens it, until the file changes on disk (ptrace -control): a
// number that is tried need not be saved.
#pragma once
#include <string>

namespace base {

// Throws Error (place: the path) where there is no such file.
void set_overlay(const std::string& path, std::string text);
void remove_overlay(const std::string& path);

// The descriptor of an open file, or one of the text that stands for it, in exchange.
int overlaid(int descriptor);

}  // namespace base
