// SPDX-License-Identifier: BSD-3-Clause
// Labels of pictures: names of views and skies, which file names use as well, and ranges of frames.
#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "base/printable.h"
#include "image/header.h"

namespace image {

const std::string& plain_name(const std::string& name, const std::string& where) {
    const bool odd =
        std::any_of(name.begin(), name.end(), [](unsigned char c) { return c <= ' ' || c == '/' || c == 0x7f; });
    if (name.empty() || odd || name[0] == '.' || name.size() > 100)
        base::fail(where, "\"" + base::excerpt(name) + "\" cannot be part of a file's name");
    return name;
}

std::string label(const Header& h) {
    return h.view_name + (h.view_name.empty() || h.sky_name.empty() ? "" : "_") + h.sky_name;
}

std::string to_text(const Ranges& ranges) {
    std::string text;
    for (const auto& r : ranges) text += fmt::format("{}{}:{}", text.empty() ? "" : ",", r.first, r.second);
    return text;
}

bool needs_floats(const Header& h) { return lacks_frame0(h) || !h.grids.empty(); }

bool lacks_frame0(const Header& h) {
    return !h.ranges.empty() &&
           std::none_of(h.ranges.begin(), h.ranges.end(), [](const auto& r) { return r.first == 0; });
}

}  // namespace image
