// SPDX-License-Identifier: BSD-3-Clause
// RADIANCE pictures to a FILE or stdout.  Pixels are radiance times the header's exposure, for viewers.
#include <fmt/format.h>

#include <functional>

#include "base/run.h"
#include "image/header.h"
#include "image/rgbe.h"
#include "image/stream.h"
#include "image/stream_parts.h"

namespace image {
namespace {

using Sink = std::function<void(const void*, size_t)>;

void write_xyz_row(const float* rgb, int width, std::vector<float>& xyz) {
    static const Matrix3 m = xyz_from_radiance_rgb();
    for (int x = 0; x < width; ++x)
        for (int c = 0; c < 3; ++c)
            xyz[3 * size_t(x) + c] = float(lumens_per_watt * (m[3 * c] * rgb[3 * x] + m[3 * c + 1] * rgb[3 * x + 1] +
                                                              m[3 * c + 2] * rgb[3 * x + 2]));
}

std::string float_lines(size_t channels) {
    return fmt::format("NCOMP={}\nBigEndian={}\nFORMAT=float\n", channels, int(host_is_big_endian()));
}

std::string resolution_line(const Picture& p) { return fmt::format("-Y {} +X {}\n", p.height, p.width); }

// A picture of its own, in radiance without exposure.
void write_moments(const Sink& sink, const Picture& p) {
    std::string head;
    for (const std::string& line : header_lines({})) head += line + "\n";
    head += "LAYER=moments\n" + float_lines(moment_numbers) + "\n" + resolution_line(p);
    sink(head.data(), head.size());
    sink(p.moments->data(), p.moments->size() * sizeof(float));
}

void write_pixels(const Sink& sink, const Picture& p, Format format) {
    std::string head;
    for (const std::string& line : header_lines(p.header)) head += line + "\n";
    switch (format) {
    case Format::flt: head += float_lines(3); break;
    case Format::rgbe: head += "FORMAT=32-bit_rle_rgbe\n"; break;
    case Format::xyze: head += "FORMAT=32-bit_rle_xyze\n"; break;
    }
    const double exposure = p.header.exposure;
    if (exposure != 1) head += fmt::format("EXPOSURE={}\n", exposure);
    if (format == Format::flt && p.moments) head += "LAYERS=moments\n";
    head += "\n" + resolution_line(p);
    sink(head.data(), head.size());
    if (format == Format::flt && exposure == 1) {
        sink(p.rgb.data(), p.rgb.size() * sizeof(float));
        return;
    }
    std::string out;
    std::vector<uint8_t> row(4 * size_t(p.width));
    std::vector<float> exposed(3 * size_t(p.width)), xyz(format == Format::xyze ? exposed.size() : 0);
    for (int y = 0; y < p.height; ++y) {
        for (size_t i = 0; i < exposed.size(); ++i) exposed[i] = float(p.at(0, y)[i] * exposure);
        if (format == Format::flt) {
            sink(exposed.data(), exposed.size() * sizeof(float));
            continue;
        }
        if (format == Format::xyze) write_xyz_row(exposed.data(), p.width, xyz);
        float_to_rgbe(format == Format::xyze ? xyz.data() : exposed.data(), p.width, row.data());
        append_rgbe_row(out, row.data(), p.width);
        if (out.size() < 1 << 16 && y + 1 < p.height) continue;
        sink(out.data(), out.size());
        out.clear();
    }
}

void write_to(const Sink& sink, const Picture& p, Format format) {
    write_pixels(sink, p, format);
    if (format == Format::flt && p.moments) write_moments(sink, p);
}

}  // namespace

void write_picture_stdout(const Picture& picture, Format format) {
    write_to(base::write_stdout, picture, format);
    base::flush_stdout();
}

std::string picture_bytes(const Picture& picture, Format format) {
    std::string bytes;
    write_to([&](const void* data, size_t n) { bytes.append(static_cast<const char*>(data), n); }, picture, format);
    return bytes;
}

}  // namespace image
