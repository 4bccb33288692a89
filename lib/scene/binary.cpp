// SPDX-License-Identifier: BSD-3-Clause
// Portable binary numbers.
#include "scene/binary.h"
#include <algorithm>
#include <array>
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

// Nearly always a whole number or string lies in the buffer.
uint64_t Binary::unsigned_integer(int bytes) {
    uint64_t v = 0;
    const std::string_view near = in_.buffered();
    if (near.size() < size_t(bytes)) {
        while (bytes-- > 0) v = v << 8 | uint64_t(byte());
        return v;
    }
    for (int i = 0; i < bytes; i++) v = v << 8 | static_cast<unsigned char>(near[size_t(i)]);
    in_.consume(size_t(bytes));
    return v;
}

int64_t Binary::integer(int bytes) {
    uint64_t v = unsigned_integer(bytes);
    const int unused = 64 - 8 * bytes;
    if (unused && v >> (8 * bytes - 1)) v |= ~uint64_t(0) << (64 - unused);
    return int64_t(v);
}

// 2^e for e from -128 to 127: a product with it is exact, as ldexp() is, at a tenth of the time.
static double power_of_two(int e) {
    static const auto powers = [] {
        std::array<double, 256> p;
        for (int i = 0; i < 256; i++) p[size_t(i)] = std::ldexp(1., i - 128);
        return p;
    }();
    return powers[size_t(e + 128)];
}

// The mantissa is rounded toward zero when written: half a unit goes back.
double Binary::real() {
    const int64_t mantissa = integer(4);
    const int exponent = int(integer(1));
    if (mantissa == 0) return 0;
    return (double(mantissa) + (mantissa > 0 ? .5 : -.5)) / 0x7fffffff * power_of_two(exponent);
}

std::string Binary::text() {
    const std::string_view near = in_.buffered();
    const size_t end = near.find('\0');
    std::string s(near.substr(0, end == near.npos ? 0 : end));
    if (end != near.npos) {
        in_.consume(end + 1);
        return s;
    }
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
    while (bytes > 0) {
        const uint64_t near = std::min<uint64_t>(bytes, in_.buffered().size());
        in_.consume(near);
        bytes -= near;
        if (bytes > 0) byte(), bytes--;
    }
}

}  // namespace scene
