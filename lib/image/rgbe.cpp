// SPDX-License-Identifier: BSD-3-Clause
// See rgbe.h.  New run-length: 2 2 hi lo, then each component of the line by itself: code > 128 repeats the next
// byte code - 128 times, code 1..128 is that many literal bytes.  Old: pixel 1 1 1 n repeats the pixel before
// n << 8k times, k counting such pixels in a row.
#include "image/rgbe.h"

#include <array>
#include <cmath>
#include <cstring>

#include "base/error.h"

namespace image {
namespace {

constexpr float largest = 1.7e38f;  // below 2^127: the exponent byte ends there

[[noreturn]] void cut(const std::string& place) { base::fail(place, "input ends inside the picture"); }

void read_old_row(Input& in, int width, uint8_t* row, const std::string& place) {
    int shift = 0;
    for (int x = 0; x < width;) {
        uint8_t* pixel = row + 4 * size_t(x);
        if (in.read(pixel, 4) != 4) cut(place);
        if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
            shift = 0;
            ++x;
            continue;
        }
        const int64_t count = shift < 32 ? int64_t(pixel[3]) << shift : int64_t(1) << 40;
        if (x == 0) base::fail(place, "a run without a pixel before it");
        if (count > width - x) base::fail(place, "a run is longer than the scanline");
        for (int64_t i = 0; i < count; ++i, ++x) std::memcpy(row + 4 * size_t(x), row + 4 * size_t(x) - 4, 4);
        shift += 8;
    }
}

void read_component(Input& in, int width, uint8_t* to, const std::string& place) {
    uint8_t literal[128];
    for (int x = 0; x < width;) {
        const int code = in.get();
        if (code < 0) cut(place);
        const int count = code > 128 ? code - 128 : code;
        if (count == 0) base::fail(place, "a run of no length");
        if (count > width - x) base::fail(place, "a run is longer than the scanline");
        if (code > 128) {
            const int value = in.get();
            if (value < 0) cut(place);
            for (int i = 0; i < count; ++i) to[4 * size_t(x++)] = uint8_t(value);
        } else {
            if (in.read(literal, size_t(count)) != size_t(count)) cut(place);
            for (int i = 0; i < count; ++i) to[4 * size_t(x++)] = literal[i];
        }
    }
}

}  // namespace

void read_rgbe_row(Input& in, int width, uint8_t* row, const std::string& place) {
    uint8_t start[4];
    if (!in.look(start, 4)) cut(place);
    if (start[0] != 2 || start[1] != 2 || start[2] >= 128) {
        read_old_row(in, width, row, place);
        return;
    }
    in.read(start, 4);
    const int length = start[2] << 8 | start[3];
    if (length != width)
        base::fail(place,
                   "scanline length " + std::to_string(length) + " does not match width " + std::to_string(width));
    for (int c = 0; c < 4; ++c) read_component(in, width, row + c, place);
}

void append_rgbe_row(std::string& out, const uint8_t* row, int width) {
    if (width < 17 || width > 32767) {
        out.append(reinterpret_cast<const char*>(row), 4 * size_t(width));
        return;
    }
    out += {2, 2, char(width >> 8), char(width & 255)};
    for (int c = 0; c < 4; ++c) {
        const auto at = [&](int x) { return row[4 * size_t(x) + c]; };
        const auto run_at = [&](int x) {
            int n = 1;
            while (x + n < width && n < 127 && at(x + n) == at(x)) ++n;
            return n;
        };
        for (int x = 0; x < width;) {
            int literal_end = x, run = 0;
            while (literal_end < width && literal_end - x < 128 && (run = run_at(literal_end)) < 4) ++literal_end;
            if (literal_end > x) {
                out += char(literal_end - x);
                for (; x < literal_end; ++x) out += char(at(x));
            } else {
                out += char(128 + run);
                out += char(at(x));
                x += run;
            }
        }
    }
}

void rgbe_to_float(const uint8_t* row, int width, float* rgb) {
    static const std::array<float, 256> scale = [] {
        std::array<float, 256> s{};
        for (int e = 1; e < 256; ++e) s[size_t(e)] = float(std::ldexp(1.0, e - 136));
        return s;
    }();
    for (int x = 0; x < width; ++x, row += 4, rgb += 3) {
        const float s = scale[row[3]];  // 0 for E = 0
        rgb[0] = (row[0] + 0.5f) * s;
        rgb[1] = (row[1] + 0.5f) * s;
        rgb[2] = (row[2] + 0.5f) * s;
    }
}

void float_to_rgbe(const float* rgb, int width, uint8_t* row) {
    for (int x = 0; x < width; ++x, row += 4, rgb += 3) {
        const float v = std::fmax(rgb[0], std::fmax(rgb[1], rgb[2]));  // fmax steps over NaN
        if (!(v > 1e-32f)) {
            std::memset(row, 0, 4);
            continue;
        }
        int e = 0;
        std::frexp(std::fmin(v, largest), &e);  // v = m 2^e, 0.5 <= m < 1
        const float scale = std::ldexp(1.f, 8 - e);
        for (int c = 0; c < 3; ++c) row[c] = rgb[c] > 0 ? uint8_t(std::fmin(rgb[c], largest) * scale) : 0;
        row[3] = uint8_t(e + 128);
    }
}

}  // namespace image
