// SPDX-License-Identifier: BSD-3-Clause
// Text that open_file() reads in place of a file until the file changes on disk (ptrace -control), so that a user can
// try a number without saving it.
#pragma once
#include <cstdint>
#include <string>
#include "base/file_stamp.h"

namespace base {

// Throws Error (place: the path) where there is no such file.
void set_overlay(const std::string& path, std::string text);
void remove_overlay(const std::string& path);

// Number of the text that stands for a file, another one for each text; 0: none does.
uint64_t overlay_number(const FileStamp& file);
// The descriptor of an open file, or one of the text that stands for it, in exchange.
int overlaid(int descriptor);

}  // namespace base
