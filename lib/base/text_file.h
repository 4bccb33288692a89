// SPDX-License-Identifier: BSD-3-Clause
// Small text files read whole: options, rad input files, tolerances.
#pragma once
#include <string>
#include <string_view>

namespace base {

// What some editors put before text in UTF-8.  It means nothing and is passed over.
constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

// Throws Error if the file cannot be read, or is longer than `limit` bytes (/dev/zero has no end).
std::string read_text_file(const std::string& path, size_t limit = size_t(1) << 20);

// A file that a scene names must be an ordinary one: a FIFO or a device would hold us up for ever.  Throws Error (place
// = who) for what exists and is not one; a file that does not exist is reported by whoever opens it.
void require_ordinary_file(const std::string& path, const std::string& who);

}  // namespace base
