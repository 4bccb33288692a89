// SPDX-License-Identifier: BSD-3-Clause
// See value.h.
#include "base/value.h"

#include <fmt/core.h>

#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstdlib>

#include "base/error.h"

namespace base {
namespace {

constexpr double most_whole = 9007199254740992.0;  // up to here a double holds every whole number

// The number that fills the whole text; false if there is none.
bool whole_text(const std::string& text, double& value) {
    const char* begin = text.c_str();
    char* end = nullptr;
    value = std::strtod(begin, &end);
    return end != begin && !*end && !std::isspace((unsigned char)*begin);
}

bool only_digits(const std::string& text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
}

}  // namespace

double to_real(const std::string& text, const std::string& where) {
    double value = 0;
    if (!whole_text(text, value)) fail(where, '"' + text + "\" is not a number");
    if (!std::isfinite(value)) fail(where, '"' + text + "\" is not a finite number");
    return value;
}

double parse_fraction(const std::string& text, const std::string& where) {
    const bool percent = text.size() > 1 && text.back() == '%';
    return percent ? to_real(text.substr(0, text.size() - 1), where) / 100 : to_real(text, where);
}

long to_int(const std::string& text, const std::string& where) {
    const char* begin = text.c_str();
    char* end = nullptr;
    errno = 0;
    const long value = std::strtol(begin, &end, 10);
    if (end != begin && !*end && !std::isspace((unsigned char)*begin) && errno != ERANGE) return value;

    double real = 0;
    if (!whole_text(text, real) || !(std::fabs(real) <= most_whole) || real != std::floor(real))
        fail(where, '"' + text + (only_digits(text) ? "\" is too large" : "\" is not an integer"));
    return long(real);
}

std::string number_text(double value) {
    std::string text = fmt::format("{}", value + 0.0);  // -0 is 0
    const size_t e = text.find('e');
    if (e != std::string::npos && e + 2 < text.size() && text[e + 2] == '0') text.erase(e + 2, 1);
    return text;
}

}  // namespace base
