// SPDX-License-Identifier: BSD-3-Clause
// SHA-256 (FIPS 180-4) of a file, as sha256sum prints it: by this others know that their file is the same.
#pragma once
#include <string>

namespace base {

std::string sha256(const std::string& bytes);  // 64 hexadecimal digits
// Of the file, or of the text that stands for it (overlay.h).  Throws Error where it cannot be read.
std::string sha256_of_file(const std::string& path);

}  // namespace base
