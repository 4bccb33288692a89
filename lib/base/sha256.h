// SPDX-License-Identifier: BSD-3-Clause
// SHA-256 (FIPS 180-4) of a file, as sha256sum prints it, so that others can check that they have the same file.  It is
// written here because a library of cryptography would be one more dependency of every tool, for this one function.
#pragma once
#include <string>
#include "base/overlay.h"

namespace base {

std::string sha256(const std::string& bytes);  // 64 hexadecimal digits
// Hashes the file, or the text that stands for it (overlay.h).  Throws Error where it cannot be read.
std::string sha256_of_file(const std::string& path, const Overlays& overlays = {});

}  // namespace base
