// SPDX-License-Identifier: BSD-3-Clause
// The page's files, embedded in the program (page.cpp.in).
#pragma once
#include <cstddef>
#include <string_view>

namespace live {

struct PageFile {
    std::string_view path, type, text;
};
extern const PageFile page_files[];
extern const size_t page_file_count;

}  // namespace live
