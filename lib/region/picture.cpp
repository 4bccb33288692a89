// SPDX-License-Identifier: BSD-3-Clause
// Rectangles and freehand polygons of the picture (even-odd, signed distance in pixels), and mask pictures.
// A mask stretches over the whole picture whatever its size; in set operations a point is in where its mask pixel is
// at least 1/2, alone a mask keeps its grey.
#include "region/picture.h"
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <fmt/format.h>
#include <png.h>
#include "base/descriptor.h"
#include "base/error.h"
#include "base/file_status.h"
#include "base/open_file.h"
#include "base/split.h"
#include "image/stream.h"

namespace region {
namespace {

Field picture_polygon(std::vector<std::pair<double, double>> corners) {
    const auto value = [c = std::move(corners)](const Point& p) {
        double nearest = INFINITY;
        bool in = false;
        for (size_t i = 0, j = c.size() - 1; i < c.size(); j = i++) {
            auto [ax, ay] = c[i];
            auto [bx, by] = c[j];
            double ex = bx - ax, ey = by - ay, wx = p.x - ax, wy = p.y - ay, e2 = ex * ex + ey * ey;
            double t = e2 > 0 ? std::clamp((wx * ex + wy * ey) / e2, 0.0, 1.0) : 0;
            double dx = wx - t * ex, dy = wy - t * ey;
            nearest = std::min(nearest, dx * dx + dy * dy);
            if ((ay > p.y) != (by > p.y) && p.x < ax + (p.y - ay) / (by - ay) * (bx - ax)) in = !in;
        }
        nearest = std::sqrt(nearest);
        return in ? nearest : -nearest;
    };
    return {value, true};
}

// Of each pixel the distance to the nearest one of the other kind, in chessboard steps, by two passes over the mask;
// below 0 outside.
std::vector<int> steps_in(const MaskPicture& m) {
    const int w = m.width, h = m.height;
    std::vector<int> steps(m.values.size(), w + h);
    const auto relax = [&](int x, int y, int dx, int dy) {
        int X = x + dx, Y = y + dy;
        if (X < 0 || Y < 0 || X >= w || Y >= h) return;
        size_t here = size_t(y) * size_t(w) + size_t(x), there = size_t(Y) * size_t(w) + size_t(X);
        bool same = (m.values[here] >= .5f) == (m.values[there] >= .5f);
        steps[here] = same ? std::min(steps[here], steps[there] + 1) : 1;
    };
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) relax(x, y, -1, 0), relax(x, y, -1, -1), relax(x, y, 0, -1), relax(x, y, 1, -1);
    for (int y = h - 1; y >= 0; --y)
        for (int x = w - 1; x >= 0; --x) relax(x, y, 1, 0), relax(x, y, 1, 1), relax(x, y, 0, 1), relax(x, y, -1, 1);
    for (size_t i = 0; i < steps.size(); ++i)
        if (m.values[i] < .5f) steps[i] = -steps[i];
    return steps;
}

Field mask_field(const MaskPicture& m, const Space& space) {
    const double sx = double(m.width) / space.nx, sy = double(m.height) / space.ny;
    const auto value = [w = m.width, h = m.height, sx, sy, steps = steps_in(m)](const Point& p) {
        int x = std::clamp(int(std::floor(p.x * sx)), 0, w - 1),
            y = std::clamp(h - 1 - int(std::floor(p.y * sy)), 0, h - 1);
        int n = steps[size_t(y) * size_t(w) + size_t(x)];
        double sure = std::max(std::abs(n) - 1, 0) / std::max(sx, sy) + 0.05 / std::max(1.0, std::max(sx, sy));
        return n > 0 ? sure : -sure;
    };
    return {value, true};
}

// Reports an error of a mask at the line that names it.
template <class Read>
auto read_named(Read&& read, const Shape& s) {
    try {
        return read(s.text);
    } catch (const base::Error& e) {
        const bool named = e.where == s.place;  // as errors of base::open_file() are
        throw base::Error(e.kind, s.place, "mask " + (named ? s.text + ": " + e.message : e.text));
    }
}

// libpng takes and clears the memory that a chunk asks for, up to 2 GB, before it reads it.
void require_whole_chunks(int fd, uint64_t size, const Shape& s) {
    uint64_t at = 8;
    unsigned char head[8];
    while (at + 8 <= size && base::read_at(fd, head, 8, at) == 8 && std::memcmp(head + 4, "IEND", 4) != 0) {
        at += 8;
        const uint64_t left = size - at;
        const uint64_t asked = 4 + (uint64_t(head[0]) << 24 | head[1] << 16 | head[2] << 8 | head[3]);
        if (asked > left)
            base::fail(s.place,
                       fmt::format("mask {}: a chunk of {} bytes, where {} are left", s.text, asked - 4, left));
        at += asked;
    }
}

MaskPicture read_png(const Shape& s) {
    png_image png;
    std::memset(&png, 0, sizeof png);
    png.version = PNG_IMAGE_VERSION;
    const int fd = read_named([&](const std::string& path) { return base::open_file(path, s.place); }, s);
    const std::unique_ptr<FILE, int (*)(FILE*)> file(fdopen(fd, "rb"), std::fclose);
    if (!file) base::fail_system(s.place, fmt::format("mask {}: cannot be read", s.text));
    const base::FileStatus info = base::status_of(fd);
    if (!info.is_ordinary()) base::fail(s.place, fmt::format("mask {} is a folder", s.text));
    require_whole_chunks(fd, info.stamp.size, s);
    if (!png_image_begin_read_from_stdio(&png, file.get()))
        base::fail(s.place, fmt::format("mask {}: {}", s.text, png.message));
    if (uint64_t(png.width) * png.height > (1u << 28)) {
        png_image_free(&png);
        base::fail(s.place, fmt::format("mask {}: {} x {} pixels are too many", s.text, png.width, png.height));
    }
    // deflate makes at most 1032 bytes of one, and a pixel is a bit at least
    if (uint64_t(png.width) * png.height / 8 / 1032 > info.stamp.size) {
        png_image_free(&png);
        base::fail(s.place, fmt::format("mask {} is too short for its {} x {} pixels", s.text, png.width, png.height));
    }
    MaskPicture m{int(png.width), int(png.height), {}};
    png.format = PNG_FORMAT_GA;  // 8 bits as stored; what is transparent is not in the mask
    std::vector<png_byte> bytes(PNG_IMAGE_SIZE(png));
    if (!png_image_finish_read(&png, nullptr, bytes.data(), 0, nullptr))
        base::fail(s.place, fmt::format("mask {}: {}", s.text, png.message));
    m.values.resize(bytes.size() / 2);
    for (size_t i = 0; i < m.values.size(); ++i) m.values[i] = bytes[2 * i] / 255.f * (bytes[2 * i + 1] / 255.f);
    return m;
}

MaskPicture read_exr_channel(const Shape& s) {
    image::MaskSet set = read_named([&](const std::string& path) { return image::read_masks(path, s.place); }, s);
    std::vector<std::string> names;
    for (image::Mask& mask : set.masks) {
        if (mask.name == s.channel) return {set.width, set.height, std::move(mask.coverage)};
        names.push_back(mask.name);
    }
    base::fail(s.place,
               fmt::format("mask {} has no channel \"{}\"{}", s.text, s.channel, near_matches(s.channel, names)));
}

}  // namespace

Field make_picture_shape(const Shape& s, const Space& space) {
    double sx = s.frame == Frame::fraction ? space.nx : 1, sy = s.frame == Frame::fraction ? space.ny : 1;
    std::vector<double> n = s.numbers;
    for (size_t i = 0; i < n.size(); i += 2) n[i] *= sx, n[i + 1] *= sy;
    if (s.kind == Kind::rect) {
        if (n[0] == n[2] || n[1] == n[3]) base::fail(s.place, "the rectangle has no area");
        n = {n[0], n[1], n[2], n[1], n[2], n[3], n[0], n[3]};
    }
    std::vector<std::pair<double, double>> corners;
    for (size_t i = 0; i < n.size(); i += 2) corners.emplace_back(n[i], n[i + 1]);
    return picture_polygon(std::move(corners));
}

Field make_mask_field(const Shape& s, const Space& space) { return mask_field(read_mask_picture(s), space); }

MaskPicture read_mask_picture(const Shape& s) {
    MaskPicture m;
    if (base::ends_with(s.text, ".png") || base::ends_with(s.text, ".PNG")) {
        m = read_png(s);
    } else if (!s.channel.empty()) {
        m = read_exr_channel(s);
    } else {  // a picture: its grey value, equal-energy white being 1
        const image::Picture p = read_named(
            [&](const std::string& path) { return image::read_file(path, image::Pixels::radiance, s.place); }, s);
        m = {p.width, p.height, std::vector<float>(p.rgb.size() / 3)};
        const float weights[3] = {float(image::luminance_weights[0]), float(image::luminance_weights[1]),
                                  float(image::luminance_weights[2])};
        for (size_t i = 0; i < m.values.size(); ++i)
            m.values[i] = weights[0] * p.rgb[3 * i] + weights[1] * p.rgb[3 * i + 1] + weights[2] * p.rgb[3 * i + 2];
    }
    if (m.values.empty()) base::fail(s.place, fmt::format("mask {} has no pixels", s.text));
    for (float& v : m.values) v = v > 0 ? std::min(v, 1.f) : 0.f;  // NaN is out
    return m;
}

// The weights of source pixels in each target pixel along one side: overlap lengths.
std::vector<float> resample(const MaskPicture& m, int nx, int ny) {
    if (m.width == nx && m.height == ny) return m.values;
    auto shrink = [](const std::vector<float>& in, int n, int lines, int step_in, int line_in, int to, int step_out,
                     int line_out, std::vector<float>& out) {
        for (int line = 0; line < lines; ++line)
            for (int k = 0; k < to; ++k) {
                double a = double(k) * n / to, b = double(k + 1) * n / to, sum = 0;
                for (int i = int(a); i < n && i < b; ++i)
                    sum += (std::min<double>(i + 1, b) - std::max<double>(i, a)) *
                           in[size_t(i) * step_in + size_t(line) * line_in];
                out[size_t(k) * step_out + size_t(line) * line_out] = float(sum / (b - a));
            }
    };
    std::vector<float> wide(size_t(nx) * m.height), out(size_t(nx) * ny);
    shrink(m.values, m.width, m.height, 1, m.width, nx, 1, nx, wide);
    shrink(wide, m.height, nx, nx, 1, ny, nx, 1, out);
    return out;
}

}  // namespace region
