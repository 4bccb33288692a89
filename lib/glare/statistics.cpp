// SPDX-License-Identifier: BSD-3-Clause
// Moments and percentiles of sets of pixels, and PGSV of a mask (statistics.h).
#include "glare/statistics.h"
#include <algorithm>
#include <cmath>
#include <limits>
#include "base/error.h"
#include "glare/zones.h"
#include "image/stream.h"

namespace glare {
namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

double percentile(const std::vector<double>& sorted, double p) {
    const double at = sorted.size() * p;
    const long last = long(sorted.size()) - 1;
    return (sorted[std::clamp(long(at), 0L, last)] + sorted[std::clamp(long(at - 1), 0L, last)]) / 2;
}

}  // namespace

PixelStatistics statistics_of(const std::vector<uint32_t>& pixels, const std::function<double(size_t)>& lum_at,
                              const Geometry& g) {
    PixelStatistics s;
    s.pixels = long(pixels.size());
    std::vector<double> sorted;
    double flux = 0, sum = 0, squares = 0;
    for (uint32_t p : pixels) {
        const double L = lum_at(p), w = std::max(g.omega[p], 0.0);
        s.omega += w, flux += w * L, sum += L, squares += L * L;
        s.eye_lux += g.omega_cos[p] * L;
        sorted.push_back(L);
    }
    s.mean = flux / s.omega;
    if (pixels.empty()) {
        s.median = s.deviation = s.p75 = s.p95 = s.lowest = s.highest = nan_value;
        return s;
    }
    std::sort(sorted.begin(), sorted.end());
    const size_t n = sorted.size();
    s.median = n % 2 ? sorted[n / 2] : (sorted[n / 2 - 1] + sorted[n / 2]) / 2;
    s.variance = squares / n - sum / n * (sum / n);
    s.deviation = std::sqrt(std::max(s.variance, 0.0));
    s.p75 = percentile(sorted, 0.75);
    s.p95 = percentile(sorted, 0.95);
    s.lowest = sorted.front();
    s.highest = sorted.back();
    return s;
}

std::vector<uint32_t> band_pixels(const Geometry& g, double half_rad) {
    std::vector<uint32_t> out;
    const int middle = (g.height - 1) / 2;
    const double limit = std::cos(half_rad);
    for (int x = 0; x < g.width; ++x) {
        const Vec3 centre = g.direction(x, middle);
        for (int y = 0; y < g.height; ++y) {
            const size_t i = g.index(x, y);
            if (g.valid(i) && (y == middle || dot(centre, g.direction(x, y)) >= limit)) out.push_back(uint32_t(i));
        }
    }
    return out;
}

std::vector<uint32_t> zone_pixels(const Geometry& g, const Zones& zones, int zone) {
    const ZoneBorders borders(g, zones);
    std::vector<uint32_t> out;
    for (size_t i = 0; i < g.omega.size(); ++i)
        if (g.valid(i) && borders.zone_of(i) == zone) out.push_back(uint32_t(i));
    return out;
}

std::vector<uint32_t> mask_pixels(const std::string& file, const Geometry& g) {
    image::Picture mask = image::read_file(file);
    if (mask.width != g.width || mask.height != g.height)
        throw MaskSize(file, g.width, g.height, mask.width, mask.height);
    const Luminance lum = make_luminance(mask);
    std::vector<uint32_t> out;
    for (size_t i = 0; i < lum.size(); ++i)
        if (g.valid(i) && lum.at(i) > 0.1) out.push_back(uint32_t(i));
    return out;
}

double median(std::vector<float>& v) {
    if (v.empty()) return nan_value;
    if (const auto nan = std::find_if(v.begin(), v.end(), [](float x) { return std::isnan(x); }); nan != v.end())
        return *nan;  // with its sign
    const size_t half = v.size() / 2;
    std::nth_element(v.begin(), v.begin() + half, v.end());
    const double upper = v[half];
    return v.size() % 2 ? upper : (upper + *std::max_element(v.begin(), v.begin() + half)) / 2;
}

// Tokura, Iwata and Shukuya 1996: contrast and saturation forms; lg is the decimal logarithm.
Pgsv pgsv(const PixelStatistics& m, double mean_lum, double ev, bool has_task, double task_lum) {
    constexpr double pi = 3.14159265359;
    const double background = (2 * pi * mean_lum - m.mean * m.omega) / (2 * pi - m.omega);
    const double lg_omega = std::log10(m.omega);
    Pgsv out;
    out.contrast = 3.2 * std::log10(m.mean) - 0.64 * lg_omega + (0.79 * lg_omega - 0.61) * std::log10(background) - 8.2;
    out.saturation = 3.3 - 3.87 / (1 + std::pow(ev / pi / 1250, 1.7));
    out.value = !has_task || task_lum == 0 || background == 0 ? -99
                : m.mean / background > ev / (pi * task_lum)  ? out.contrast
                                                              : out.saturation;
    return out;
}

}  // namespace glare
