// SPDX-License-Identifier: BSD-3-Clause
// Makes and compares streams for the shell tests, so that they need no renderer.
//   mkstream frames first last [width height seed view]   frames like ptrace's, pixels from (seed, frame, pixel) alone
//   mkstream numbers first last                           8 x 8; every pixel of frame 0 is 10, of frame k is k
//   mkstream action name bands unit factor                the frames of stdin as those of an action: luminance times it
//   mkstream last frame                                   the frames of stdin, each with LASTFRAME=
//   mkstream show file                                    a line for each picture: size, FRAMES, RANGE, mean of red
//   mkstream differ a b                                   largest difference of two pictures, relative to the pixel
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>

#include "base/error.h"
#include "base/run.h"
#include "image/header.h"
#include "image/stream.h"

namespace {

// A frame may hold negative values; frame 0 a sun.  Integer hash: splitmix64 (Steele, Lea, Flood 2014).
float value(uint64_t seed, int64_t k, uint64_t i) {
    uint64_t z = seed * 0x9e3779b97f4a7c15u + uint64_t(k) * 0xbf58476d1ce4e5b9u + (i + 1) * 0x94d049bb133111ebu;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    const double u = double((z ^ (z >> 31)) >> 11) / 9007199254740992.0;
    if (k == 0) return i % 1000 == 7 ? 1e6f : float(5 * u);
    return float(3 * u - 1);
}

int frames(int argc, char** argv) {
    const auto number = [&](int i, long otherwise) { return argc > i ? std::atol(argv[i]) : otherwise; };
    image::Picture p;
    p.width = int(number(4, 16));
    p.height = int(number(5, 16));
    p.rgb.resize(3 * size_t(p.width) * p.height);
    p.header.seed = uint64_t(number(6, 1));
    view::View v;
    v.type = 'a';
    v.vh = v.vv = 180;
    if (argc > 7) view::parse_line(v, argv[7]);
    p.header.view = v;
    p.header.lines = {base::command_line({argv, argv + argc})};
    for (int64_t k = number(2, 0); k <= number(3, 0); ++k) {
        p.header.frame = k;
        for (size_t i = 0; i < p.rgb.size(); ++i) p.rgb[i] = value(*p.header.seed, k, i);
        image::write_picture_stdout(p, image::Format::flt);
    }
    return 0;
}

int numbers(int argc, char** argv) {
    if (argc < 4) return 1;
    image::Picture p;
    p.width = p.height = 8;
    p.header.seed = 1;
    for (int64_t k = std::atol(argv[2]); k <= std::atol(argv[3]); ++k) {
        p.header.frame = k;
        p.rgb.assign(192, k == 0 ? 10.f : float(k));
        image::write_picture_stdout(p, image::Format::flt);
    }
    return 0;
}

int action(int argc, char** argv) {
    if (argc < 6) return 1;
    image::StreamReader in("-");
    for (image::Picture p; in.next(p);) {
        p.header.action = image::Action{argv[2], std::atoi(argv[3]), argv[4]};
        for (size_t i = 0; i < p.rgb.size(); i += 3)
            std::fill_n(&p.rgb[i], 3, float(std::atof(argv[5]) * image::luminance(&p.rgb[i]) / image::lumens_per_watt));
        image::write_picture_stdout(p, image::Format::flt);
    }
    return 0;
}

int last(int argc, char** argv) {
    image::StreamReader in("-");
    for (image::Picture p; argc > 2 && in.next(p);) {
        p.header.last_frame = std::atol(argv[2]);
        image::write_picture_stdout(p, image::Format::flt);
    }
    return 0;
}

int show(int argc, char** argv) {
    image::StreamReader in(argc > 2 ? argv[2] : "-");
    for (image::Picture p; in.next(p);) {
        double red = 0;
        for (size_t i = 0; i < p.rgb.size(); i += 3) red += p.rgb[i];
        fmt::print("{}x{} FRAMES={} RANGE={} {:.6g}\n", p.width, p.height, p.header.frames.value_or(-1),
                   image::to_text(p.header.ranges), red / (p.width * double(p.height)));
    }
    return 0;
}

int differ(int argc, char** argv) {
    if (argc < 4) return 1;
    const image::Picture a = image::read_file(argv[2]), b = image::read_file(argv[3]);
    if (a.rgb.size() != b.rgb.size()) base::fail(argv[3], "has another size");
    double worst = 0;
    for (size_t i = 0; i < a.rgb.size(); ++i)
        worst = std::max(worst, std::fabs(double(a.rgb[i]) - b.rgb[i]) / std::max(1.0, std::fabs(double(a.rgb[i]))));
    fmt::print("{:.3g}\n", worst);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    return base::run("mkstream", [&] {
        const std::string what = argc > 1 ? argv[1] : "";
        if (what == "frames") return frames(argc, argv);
        if (what == "numbers") return numbers(argc, argv);
        if (what == "action") return action(argc, argv);
        if (what == "last") return last(argc, argv);
        if (what == "show") return show(argc, argv);
        if (what == "differ") return differ(argc, argv);
        base::fail(what, "is not one of frames numbers action last show differ");
    });
}
