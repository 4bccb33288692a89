// SPDX-License-Identifier: BSD-3-Clause
// Do two files hold the same bytes?
#pragma once
#include <string>

namespace base {

// Remembers answers until a file changes.  A file that cannot be read is like none.
bool same_content(const std::string& a, const std::string& b);

}  // namespace base
