// SPDX-License-Identifier: BSD-3-Clause
// See pixel_moments.h.
#include "render/pixel_moments.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "image/grey.h"

namespace render {
using namespace kernels;
using image::grey;

namespace {
constexpr double least_deviation = 20 / image::lumens_per_watt;  // in grey: 20 cd/m2, darker than any glare source
constexpr double least_share = .05;                              // of the mean: below it f is above .9975
constexpr double significance = 3;                               // standard errors of a significant covariance
constexpr double rounding = 1e-6;                                // of the squared mean
constexpr double sun_radiance = 5e5 / image::lumens_per_watt;    // in grey: no lamp is so bright
constexpr double few_hits = 16;                                  // hits that decide little
constexpr double glare_share = 1. / 16384;                       // of the picture's squared light
constexpr size_t samples_at_once = 1u << 18;                     // pairs

// Places in a pixel that decides glare, of a picture of so many pixels: where they are few, a pixel holds much of the
// light, and samples cost little.
uint32_t most_places(size_t pixels) {
    constexpr size_t enough = 1u << 20;  // of all pixels
    uint32_t n = 16;
    while (n < 256 && 2 * n * pixels <= enough) n *= 2;
    return n;
}

// Pixels whose variance is much of the squared light, which is what glare sums.
std::vector<bool> glaring_pixels(const FrameZero& zero) {
    double squares = 0;
    for (size_t i = 0; i < zero.spread.size(); i++)
        squares += std::pow(grey(&zero.mean[3 * i]), 2) + double(zero.spread[i]);
    std::vector<bool> out;
    for (const float v : zero.spread) out.push_back(double(v) > glare_share * squares);
    return out;
}

struct Covariance {
    double between = 0;  // of places: covariance of both samples
    double within = 0;   // of one place: variance of a sample's noise
    double mean = 0;
};

// Statistics of n pairs.  Divided by n, because the places are points of a net, whose mean has almost no error.
Covariance covariance(const double* a, const double* b, uint32_t n) {
    double sum_a = 0, sum_b = 0, products = 0, noise = 0;
    for (uint32_t k = 0; k < n; k++) {
        const double x = a[k], y = b[k];
        sum_a += x, sum_b += y, products += x * y, noise += (x - y) * (x - y) / 2;
    }
    return {products / n - sum_a / n * (sum_b / n), noise / n, (sum_a + sum_b) / (2 * n)};
}

// Variance of the light over places, and half the difference of the variances of both halves of them.
void estimate(const double* a, const double* b, uint32_t n, float* moments) {
    const Covariance all = covariance(a, b, n), first = covariance(a, b, n / 2),
                     second = covariance(a + n / 2, b + n / 2, n / 2);
    const double least = std::max(significance * all.within / std::sqrt(double(n)), rounding * all.mean * all.mean);
    if (!(all.between > least)) return;
    moments[image::moment_variance] = float(all.between);
    moments[image::moment_difference] = float((first.between - second.between) / 2);
}

// The sun is in few of the samples of a pixel (a curved surface mirrors it): k of them, each of luminance L, of n.
struct Glint {
    double k = 0, L = 0, n = 0;
    bool undecided() const { return L > sun_radiance && k < few_hits; }
};

// From the sum and the sum of squares of n samples: the mean weighted by light, and how many of that are in the sum.
Glint glint_of(double sum, double squares, double n) {
    if (!(sum > 0)) return {};
    return {sum * sum / squares, squares / sum, n};
}

// In frame 0's own samples of a pixel and the n pairs.
Glint glint_in(const FrameZero& zero, size_t pixel, const double* a, const double* b, uint32_t n) {
    const double mean = grey(&zero.mean[3 * pixel]), own = zero.samples;
    double sum = own * mean, squares = own * (double(zero.spread[pixel]) + mean * mean);
    for (uint32_t k = 0; k < n; k++)
        for (const double y : {a[k], b[k]}) sum += y, squares += y * y;
    return glint_of(sum, squares, own + 2 * n);
}

// Pixels in which the sun was met few times have an error of the square root of their number.  Their neighbours may
// hold as much as one sample more.
void add_glints(const std::vector<Glint>& glints, int nx, int ny, std::vector<float>& moments) {
    for (int y = 0; y < ny; y++)
        for (int x = 0; x < nx; x++) {
            const Glint& g = glints[size_t(y) * size_t(nx) + size_t(x)];
            if (!g.undecided()) continue;
            for (int v = std::max(0, y - 1); v <= std::min(ny - 1, y + 1); v++)
                for (int u = std::max(0, x - 1); u <= std::min(nx - 1, x + 1); u++) {
                    const double hits = u == x && v == y ? std::max(1.0, g.k) : 1,
                                 error = g.L * g.L * std::sqrt(hits) / g.n;
                    float& e = moments[image::moment_numbers * (size_t(v) * size_t(nx) + size_t(u)) +
                                       image::moment_difference];
                    if (double(std::fabs(e)) < error) e = float(error);
                }
        }
}

// With sources of luminance E on a fraction of the pixel, and light L that is 0 there:
//   Var(E + L) = Var E + Var L - 2 mean E mean L
void add_drawn(const FrameZero& zero, size_t i, float* moments) {
    const DrawnLight& d = zero.drawn[i];
    const double rest = std::max(0.0, grey(&zero.mean[3 * i]));
    if (!(d.sum > 0)) return;
    const double variance = d.squares - d.sum * d.sum - 2 * d.sum * rest;
    float& v = moments[image::moment_variance];
    v = float(std::max(0.0, double(v) + variance));
    moments[image::moment_right] = float(d.right / d.sum);
    moments[image::moment_up] = float(d.up / d.sum);
}
}  // namespace

std::vector<uint32_t> places_of_pixels(const FrameZero& zero, int nx, int ny, uint32_t fewer) {
    const uint32_t most = std::max(4u, most_places(zero.spread.size()) / fewer), least = std::max(4u, most / 16);
    const std::vector<bool> glares = glaring_pixels(zero);
    std::vector<uint32_t> places(zero.spread.size(), 0);
    for (int y = 0; y < ny; y++)
        for (int x = 0; x < nx; x++) {
            const size_t i = size_t(y) * size_t(nx) + size_t(x);
            const double deviation = std::sqrt(double(zero.spread[i]));
            if (deviation < least_deviation || deviation < least_share * grey(&zero.mean[3 * i])) continue;
            // Around it, too: the samples may have missed a small bright thing there.
            for (int v = std::max(0, y - 1); v <= std::min(ny - 1, y + 1); v++)
                for (int u = std::max(0, x - 1); u <= std::min(nx - 1, x + 1); u++) {
                    const size_t near = size_t(v) * size_t(nx) + size_t(u);
                    places[near] = glares[near] ? most : least;
                }
        }
    return places;
}

image::Moments moments_of(const FrameZero& zero, int nx, int ny, const std::vector<uint32_t>& places,
                          const PairsOf& pairs_of) {
    std::vector<float> out(image::moment_numbers * zero.spread.size(), 0.0f);
    std::vector<Glint> glints(zero.spread.size());
    std::map<uint32_t, std::vector<uint32_t>> alike;  // pixels by number of places
    for (uint32_t i = 0; i < places.size(); i++)
        if (places[i] > 0) alike[places[i]].push_back(i);
    for (const auto& [n, pixels] : alike) {
        const size_t step = samples_at_once / n;
        for (size_t first = 0; first < pixels.size(); first += step) {
            const std::vector<uint32_t> some(pixels.begin() + long(first),
                                             pixels.begin() + long(std::min(pixels.size(), first + step)));
            const Pairs of = pairs_of(some, n);
            for (size_t k = 0; k < some.size(); k++) {
                const double *a = &of.a[n * k], *b = &of.b[n * k];
                estimate(a, b, n, &out[image::moment_numbers * some[k]]);
                glints[some[k]] = glint_in(zero, some[k], a, b, n);
            }
        }
    }
    add_glints(glints, nx, ny, out);
    for (size_t i = 0; i < zero.drawn.size(); i++) add_drawn(zero, i, &out[image::moment_numbers * i]);
    image::clean_moments(out);
    return std::make_shared<const std::vector<float>>(std::move(out));
}

namespace {
std::vector<double> greys(const std::vector<float>& rgb) {
    std::vector<double> out;
    for (size_t i = 0; i < rgb.size(); i += 3) out.push_back(grey(&rgb[i]));
    return out;
}
}  // namespace

image::Moments pixel_moments(device::Device& device, const ViewPlan& plan, const FrameZero& zero) {
    const auto nx = int(plan.sampling.params.nx), ny = int(plan.sampling.params.ny);
    return moments_of(zero, nx, ny, places_of_pixels(zero, nx, ny),
                      [&](const std::vector<uint32_t>& pixels, uint32_t n) {
                          return Pairs{greys(run_places(device, plan.sampling, pixels, n, 0)),
                                       greys(run_places(device, plan.sampling, pixels, n, 1))};
                      });
}

}  // namespace render
