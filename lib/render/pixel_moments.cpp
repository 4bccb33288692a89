// SPDX-License-Identifier: BSD-3-Clause
// See pixel_moments.h.
#include "render/pixel_moments.h"

#include <algorithm>
#include <cmath>

#include "image/grey.h"
#include "image/picture.h"

namespace render {
using namespace kernels;
using image::grey;

namespace {
constexpr double clear = 3;                             // standard errors of a significant covariance
constexpr double rounding = 1e-6;                       // of the squared mean
constexpr double sunny = 5e5 / image::lumens_per_watt;  // in grey: no lamp is so bright
constexpr double few = 16;                              // hits that decide little

struct Covariance {
    double between = 0;  // of places: covariance of both samples
    double within = 0;   // of one place: variance of a sample's noise
    double mean = 0;
};

// Statistics of n pairs.  Divided by n, because the places are points of a net, whose mean has almost no error.
Covariance covariance(const float* a, const float* b, uint32_t n) {
    double sum_a = 0, sum_b = 0, products = 0, noise = 0;
    for (uint32_t k = 0; k < n; k++) {
        const double x = grey(a + 3 * k), y = grey(b + 3 * k);
        sum_a += x, sum_b += y, products += x * y, noise += (x - y) * (x - y) / 2;
    }
    return {products / n - sum_a / n * (sum_b / n), noise / n, (sum_a + sum_b) / (2 * n)};
}

// Variance of the light over places, and half the difference of the variances of both halves of them.
void estimate(const float* a, const float* b, uint32_t n, float* moments) {
    const Covariance all = covariance(a, b, n), first = covariance(a, b, n / 2),
                     second = covariance(a + 3 * (n / 2), b + 3 * (n / 2), n / 2);
    const double least = std::max(clear * all.within / std::sqrt(double(n)), rounding * all.mean * all.mean);
    if (!(all.between > least)) return;
    moments[image::moment_variance] = float(all.between);
    moments[image::moment_difference] = float((first.between - second.between) / 2);
}

// With sources of luminance E on a fraction of the pixel, and light L that is 0 there:
//   Var(E + L) = Var E + Var L - 2 mean E mean L
void add_drawn(const DrawnLight& d, const float* mean, float* moments) {
    const double rest = std::max(0.0, grey(mean));
    if (!(d.sum > 0)) return;
    const double variance = d.squares - d.sum * d.sum - 2 * d.sum * rest;
    float& v = moments[image::moment_variance];
    v = float(std::max(0.0, double(v) + variance));
    moments[image::moment_right] = float(d.right / d.sum);
    moments[image::moment_up] = float(d.up / d.sum);
}
}  // namespace

PixelMoments::PixelMoments(const Probes& probes, int nx, int ny)
    : probes_(probes),
      nx_(nx),
      ny_(ny),
      moments_(image::moment_numbers * probes.variance.size(), 0.0f),
      glints_(probes.variance.size()) {}

// From the sum and the sum of squares of n samples: the mean weighted by light, and how many of that are in the sum.
PixelMoments::Glint PixelMoments::glint_of(double sum, double squares, double n) {
    if (!(sum > 0)) return {};
    return {sum * sum / squares, squares / sum, n};
}

void PixelMoments::add_places(uint32_t pixel, const float* a, const float* b, uint32_t n) {
    if (b) estimate(a, b, n, of(pixel));
    const double mean = grey(&probes_.mean[3 * size_t(pixel)]), own = probes_.count;
    double sum = own * mean, squares = own * mean * mean + (own - 1) * double(probes_.variance[pixel]);
    for (const float* samples : {a, b})
        for (uint32_t k = 0; samples && k < n; k++) {
            const double y = grey(samples + 3 * k);
            sum += y, squares += y * y;
        }
    glints_[pixel] = glint_of(sum, squares, own + (b ? 2 : 1) * n);
}

// Pixels in which the sun was met few times have an error of the square root of their number.  Their neighbours may
// hold as much as one sample more.
void PixelMoments::add_glints() {
    for (int y = 0; y < ny_; y++)
        for (int x = 0; x < nx_; x++) {
            const Glint& g = glints_[size_t(y) * size_t(nx_) + size_t(x)];
            if (!(g.L > sunny && g.k < few)) continue;
            for (int v = std::max(0, y - 1); v <= std::min(ny_ - 1, y + 1); v++)
                for (int u = std::max(0, x - 1); u <= std::min(nx_ - 1, x + 1); u++) {
                    const double hits = u == x && v == y ? std::max(1.0, g.k) : 1,
                                 error = g.L * g.L * std::sqrt(hits) / g.n;
                    float& e = of(uint32_t(v) * uint32_t(nx_) + uint32_t(u))[image::moment_difference];
                    if (double(std::fabs(e)) < error) e = float(error);
                }
        }
}

image::Moments PixelMoments::finish(const std::vector<float>& mean, const std::vector<DrawnLight>& drawn) {
    add_glints();
    for (uint32_t i = 0; i < drawn.size(); i++) add_drawn(drawn[i], &mean[3 * size_t(i)], of(i));
    image::clean_moments(moments_);
    return std::make_shared<const std::vector<float>>(std::move(moments_));
}

}  // namespace render
