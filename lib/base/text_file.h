// SPDX-License-Identifier: BSD-3-Clause
// Small text files read whole: options, rad input files, tolerances.
#pragma once
#include <string>
#include <string_view>
#include "base/open_file.h"

namespace base {

// Some editors put it before text in UTF-8.  It means nothing and is passed over.
constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

// Throws Error if the file cannot be read, or is longer than `limit` bytes (/dev/zero has no end).  by: as for
// open_file().
std::string read_text_file(const std::string& path, size_t limit = size_t(1) << 20, const Opener& by = {});

}  // namespace base
