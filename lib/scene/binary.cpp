// SPDX-License-Identifier: BSD-3-Clause
// Portable binary numbers.
#include "scene/binary.h"
#include <cmath>
#include "base/error.h"
#include "base/number.h"
#include "base/printable.h"

namespace scene {

void Binary::fail(const std::string& fact) const { base::fail(in_.name(), fact); }

std::vector<std::string> Binary::header() {
    std::vector<std::string> lines;
    for (std::string line; in_.line(line, 1 << 16);) {
        if (line.empty() || line == "\r") return lines;
        if (lines.size() < 1000) lines.push_back(line);
    }
    fail("the file ends within its header");
}

int Binary::byte() {
    const int c = in_.get();
    if (c < 0) fail("the file is cut short");
    return c;
}

uint64_t Binary::unsigned_integer(int bytes) {
    uint64_t v = 0;
    while (bytes-- > 0) v = v << 8 | uint64_t(byte());
    return v;
}

int64_t Binary::integer(int bytes) {
    uint64_t v = unsigned_integer(bytes);
    const int unused = 64 - 8 * bytes;
    if (unused && v >> (8 * bytes - 1)) v |= ~uint64_t(0) << (64 - unused);
    return int64_t(v);
}

// The mantissa is rounded toward zero when written: half a unit goes back.
double Binary::real() {
    const int64_t mantissa = integer(4);
    const int exponent = int(integer(1));
    if (mantissa == 0) return 0;
    return std::ldexp((double(mantissa) + (mantissa > 0 ? .5 : -.5)) / 0x7fffffff, exponent);
}

std::string Binary::text() {
    std::string s;
    for (int c; (c = byte()) != 0;) {
        s += char(c);
        if (s.size() > (1 << 16)) fail("a string is longer than 65536 characters");
    }
    return s;
}

double Binary::text_real() {
    const std::string s = text();
    double v;
    if (!base::parse_real(s, v)) fail("\"" + base::excerpt(s) + "\" is not a number");
    return v;
}

void Binary::skip(uint64_t bytes) {
    while (bytes-- > 0) byte();
}

}  // namespace scene
