// SPDX-License-Identifier: BSD-3-Clause
// Names of views and skies, which streams of several pictures carry and files are called by.
#include <algorithm>

#include "base/error.h"
#include "base/printable.h"
#include "image/header.h"

namespace image {

void require_plain_name(const std::string& name, const std::string& where) {
    const bool odd =
        std::any_of(name.begin(), name.end(), [](unsigned char c) { return c <= ' ' || c == '/' || c == 0x7f; });
    if (name.empty() || odd || name[0] == '.' || name.size() > 100)
        base::fail(where, "\"" + base::excerpt(name) + "\" cannot be part of a file's name");
}

std::string label(const Header& h) {
    return h.view_name + (h.view_name.empty() || h.sky_name.empty() ? "" : "_") + h.sky_name;
}

}  // namespace image
