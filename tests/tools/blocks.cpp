// SPDX-License-Identifier: BSD-3-Clause
// Two renderings of one small view, compared in standard errors (tests/golden/suite).
//   blocks gather WIDTH HEIGHT RAYS < floats     means over 8 x 8 pixels of what rtrace -ff gave for RAYS rays a pixel
//   blocks compare TABLE < frames                those means against ptrace's frames; one line: 10 numbers, see below
// A block's standard error comes from the scatter within its pixels, so that detail inside a block does not count as
// noise: from ray to ray in the reference, from batch to batch of four frames (a stratum of the sequence) in ours.
// Every error has .1 % of the value in it: RADIANCE 6.0a reflects .00085 too much where there is a Fresnel term, its
// suns of eight degrees are .03 % dark, and our function files run in single precision.
//
// The line: blocks; how many are beyond 3 errors in any channel; the largest deviation; the rms of all; per channel how
// much brighter ours is as a whole, in per cent; the largest of these in errors; and what such a test can see: one
// standard error of the whole and of a block (the median), in per cent.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/run.h"
#include "image/stream.h"
#include "render/options.h"

namespace {

constexpr int side = 8, batch = 4;
constexpr double common_error = 1e-3;

// of the mean
struct Estimate {
    double mean = 0, variance = 0;
};
using Colour = std::array<Estimate, 3>;

struct Blocks {
    int columns, rows;
    std::vector<Colour> of;
    Blocks(int width, int height) : columns(width / side), rows(height / side), of(size_t(columns) * rows) {}

    // A pixel's mean, known to a variance.
    void add(size_t pixel, int channel, double mean, double variance) {
        const size_t width = size_t(columns) * side, x = pixel % width, y = pixel / width;
        Estimate& e = of[y / side * columns + x / side][channel];
        e.mean += mean / (side * side);
        e.variance += variance / (side * side * side * side);
    }
};

// Mean and variance of the mean of numbers that come one by one (Welford 1962).
class Scatter {
public:
    void add(double v) {
        const double d = v - mean_;
        mean_ += d / ++n_;
        squares_ += d * (v - mean_);
    }
    double mean() const { return mean_; }
    double variance() const { return n_ > 1 ? squares_ / (n_ - 1) / n_ : 0; }
    int count() const { return n_; }

private:
    int n_ = 0;
    double mean_ = 0, squares_ = 0;
};

int gather(int width, int height, int rays) {
    if (width < side || height < side || width % side || height % side || rays < 2)
        base::fail("", "usage: blocks gather WIDTH HEIGHT RAYS, the sizes multiples of 8");
    Blocks blocks(width, height);
    std::vector<float> values(3 * size_t(rays));
    for (size_t pixel = 0; pixel < size_t(width) * height; ++pixel) {
        if (std::fread(values.data(), sizeof(float), values.size(), stdin) != values.size())
            base::fail("stdin", "ends early");
        for (int c = 0; c < 3; ++c) {
            Scatter s;
            for (int k = 0; k < rays; ++k) s.add(values[3 * size_t(k) + c]);
            blocks.add(pixel, c, s.mean(), s.variance());
        }
    }
    fmt::print("R\tse\tG\tse\tB\tse\n");
    for (const Colour& block : blocks.of)
        for (int c = 0; c < 3; ++c)
            fmt::print("{:.5g}\t{:.2g}{}", block[c].mean, std::sqrt(block[c].variance), c < 2 ? '\t' : '\n');
    return 0;
}

Blocks read_table(const std::string& path, int width, int height) {
    std::ifstream in(path);
    std::string line;
    if (!std::getline(in, line)) base::fail(path, "cannot be read");
    Blocks blocks(width, height);
    for (Colour& block : blocks.of) {
        if (!std::getline(in, line))
            base::fail(path, fmt::format("has too few lines for {} x {} pixels", width, height));
        std::istringstream words(line);
        for (Estimate& e : block) {
            double error;
            if (!(words >> e.mean >> error)) base::fail(path, fmt::format("\"{}\" is not a block", line));
            e.variance = error * error;
        }
    }
    if (std::getline(in, line)) base::fail(path, fmt::format("has too many lines for {} x {} pixels", width, height));
    return blocks;
}

// ptrace's frames: frame 0 stands for the direct class of m frames, and later ones refine it
// (docs/decisions/0002-frame-zero.md), so only frames beyond m show the whole scatter.
Blocks read_frames() {
    image::StreamReader in("-");
    image::Picture frame;
    std::vector<double> first, sum, part;
    std::vector<Scatter> scatter;
    int frames = -1, whole_from = 0;
    for (; in.next(frame); ++frames) {
        if (frames < 0) {
            whole_from = int(frame.header.direct_frames.value_or(image::direct_samples)) + 1;
            first.assign(frame.rgb.begin(), frame.rgb.end());
            sum.assign(first.size(), 0), part.assign(first.size(), 0), scatter.resize(first.size());
            continue;
        }
        const int k = frames + 1;
        for (size_t i = 0; i < sum.size(); ++i) {
            sum[i] += frame.rgb[i];
            if (k < whole_from) continue;
            part[i] += frame.rgb[i] / batch;
            if ((k - whole_from) % batch == batch - 1) scatter[i].add(part[i]), part[i] = 0;
        }
    }
    if (scatter.empty() || scatter[0].count() < 2) base::fail("stdin", "has too few frames for a scatter");
    Blocks blocks(frame.width, frame.height);
    for (size_t i = 0; i < sum.size(); ++i) {
        const double whole = double(batch) * scatter[i].count() / frames;  // the mean is one of all frames
        blocks.add(i / 3, int(i % 3), first[i] + sum[i] / frames, scatter[i].variance() * whole);
    }
    return blocks;
}

struct Deviation {
    double in_errors, error;
};
Deviation deviation(const Estimate& ours, const Estimate& theirs) {
    const double floor = common_error * std::fabs(theirs.mean);
    const double error = std::sqrt(ours.variance + theirs.variance + floor * floor);
    return {error > 0 ? (ours.mean - theirs.mean) / error : ours.mean == theirs.mean ? 0 : INFINITY, error};
}

// The factor by which a channel of ours is brighter than theirs, every block having the say that its error allows
// (least squares: a lamp in view, known to a few per cent, does not drown the rest).
Estimate factor(const Blocks& ours, const Blocks& theirs, int channel) {
    double product = 0, square = 0;
    for (size_t i = 0; i < ours.of.size(); ++i) {
        const Estimate &a = ours.of[i][channel], &b = theirs.of[i][channel];
        const double error = deviation(a, b).error;
        if (error <= 0) continue;
        product += a.mean * b.mean / (error * error);
        square += b.mean * b.mean / (error * error);
    }
    return square > 0 ? Estimate{product / square, 1 / square + common_error * common_error} : Estimate{1, 0};
}

int compare(const std::string& table) {
    const Blocks ours = read_frames();
    const Blocks theirs = read_table(table, ours.columns * side, ours.rows * side);
    int beyond = 0;
    double largest = 0, squares = 0;
    std::vector<double> relative;
    for (size_t i = 0; i < ours.of.size(); ++i) {
        double worst = 0;
        for (int c = 0; c < 3; ++c) {
            const Deviation d = deviation(ours.of[i][c], theirs.of[i][c]);
            worst = std::max(worst, std::fabs(d.in_errors));
            squares += d.in_errors * d.in_errors;
            if (theirs.of[i][c].mean > 0) relative.push_back(100 * d.error / theirs.of[i][c].mean);
            if (std::fabs(d.in_errors) > 3)
                fmt::print(stderr, "column {} row {} {}: {:.4g}, reference {:.4g}, {:+.1f} errors\n", i % ours.columns,
                           i / ours.columns, "RGB"[c], ours.of[i][c].mean, theirs.of[i][c].mean, d.in_errors);
        }
        beyond += worst > 3;
        largest = std::max(largest, worst);
    }
    if (relative.empty()) base::fail(table, "is black");
    fmt::print("{}\t{}\t{:.2f}\t{:.2f}", ours.of.size(), beyond, largest, std::sqrt(squares / (3. * ours.of.size())));
    double in_errors = 0, error = 0;
    for (int c = 0; c < 3; ++c) {
        const Estimate f = factor(ours, theirs, c);
        const double one_error = std::sqrt(f.variance);
        fmt::print("\t{:+.3f}", 100 * (f.mean - 1));
        in_errors = std::max(in_errors, one_error > 0 ? std::fabs(f.mean - 1) / one_error : 0);
        error = std::max(error, 100 * one_error);
    }
    std::nth_element(relative.begin(), relative.begin() + relative.size() / 2, relative.end());
    fmt::print("\t{:.2f}\t{:.3f}\t{:.2f}\n", in_errors, error, relative[relative.size() / 2]);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    return base::run("blocks", [&] {
        const std::string verb = argc > 1 ? argv[1] : "";
        if (verb == "gather" && argc == 5) return gather(std::atoi(argv[2]), std::atoi(argv[3]), std::atoi(argv[4]));
        if (verb == "compare" && argc == 3) return compare(argv[2]);
        base::fail("", "usage: blocks gather WIDTH HEIGHT RAYS | blocks compare TABLE");
    });
}
