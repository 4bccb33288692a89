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

// Groups have a slash, which a file's name has not.
static std::string of_file(std::string state) {
    std::replace(state.begin(), state.end(), '/', '-');
    return state;
}

const std::string& state_name(const std::string& name, const std::string& where) {
    plain_name(of_file(name), where);
    return name;
}

std::string label(const Header& h) {
    std::string label;
    for (const std::string& name :
         {h.view_name, of_file(h.state), h.sky_name, h.action ? h.action->name : std::string()})
        if (!name.empty()) label += (label.empty() ? "" : "_") + name;
    return label;
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
