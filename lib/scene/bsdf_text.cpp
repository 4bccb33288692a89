// SPDX-License-Identifier: BSD-3-Clause
// See bsdf_text.h.
#include "scene/bsdf_text.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fmt/core.h>
#include "base/error.h"

namespace scene {

std::string trimmed(const char* text) {
    std::string s = text;
    const char* space = " \t\r\n";
    s.erase(0, s.find_first_not_of(space));
    s.erase(s.find_last_not_of(space) + 1);
    return s;
}

bool same_but_case(const std::string& a, const char* b) {
    if (a.size() != std::strlen(b)) return false;
    for (size_t i = 0; i < a.size(); i++)
        if (std::tolower(static_cast<unsigned char>(a[i])) != std::tolower(static_cast<unsigned char>(b[i])))
            return false;
    return true;
}

char BsdfNumbers::peek() {
    while (at_ < end_ && (std::isspace(static_cast<unsigned char>(*at_)) || *at_ == ',')) at_++;
    return at_ < end_ ? *at_ : '\0';
}

double BsdfNumbers::number() {
    if (!peek()) base::fail(place_, "scattering data end too early");
    if (*at_ == '+') at_++;
    double v = 0;
    const auto r = std::from_chars(at_, end_, v);
    if (r.ec == std::errc::result_out_of_range) v = 0;
    else if (r.ec != std::errc() || !std::isfinite(v))
        base::fail(place_,
                   fmt::format("\"{}\" is not a number", std::string(at_, std::min<size_t>(size_t(end_ - at_), 12))));
    at_ = r.ptr;
    return v;
}

float BsdfNumbers::value() {
    const double v = number();
    if (v > 1e30) base::fail(place_, "a BSDF value is above 1e30");
    return v > 0 ? float(v) : 0.0f;
}

}  // namespace scene
