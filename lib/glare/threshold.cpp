// SPDX-License-Identifier: BSD-3-Clause
// Threshold, task area, field cut and filling, in loops over the valid pixels (threshold.h).
#include "glare/threshold.h"
#include <algorithm>
#include <cmath>
#include <cstring>
#include "base/error.h"
#include "base/wide.h"
#include "glare/position_index.h"

namespace glare {
namespace {

// Fits of the total and the binocular field of view, degrees; c = 180 - tau is 0 straight down.
bool outside_total_field(double sigma, double tau, double elevation) {
    if (elevation > 0) {
        const double limit = 7.7458218 + 5.7407915e-4 * tau - 2.1746318e-4 * tau * tau + 8.5572726e-6 * tau * tau * tau;
        return sigma > limit * limit;
    }
    const double c = 180 - tau;
    return tau > 135 &&
           -sigma < 1 / (-0.014699242 - 1.5541106e-5 * c + 4.6898068e-6 * c * c - 5.1539687e-8 * c * c * c);
}

bool outside_both_eyes(double sigma, double tau, double elevation) {
    if (elevation > 0) return sigma > 60;
    const double c = 180 - tau;
    const double limit = c > 73 ? 60
                                : (68.227109 - 2.9524084 * c + 0.046674262 * c * c) /
                                      (1 - 0.042317294 * c + 7.5698419e-4 * c * c - 6.5364285e-7 * c * c * c);
    return sigma > limit;
}

WIDE_LOOP void compare(const float* values, size_t n, float limit, char* above) {
    for (size_t i = 0; i < n; ++i) above[i] = values[i] > limit;
}

}  // namespace

double inside_cosine(double opening) { return opening / 2 >= evalglare_pi ? -2 : std::cos(opening / 2); }

double task_luminance(const Luminance& lum, const Geometry& g, const Circle& task, bool as_they_are) {
    if (task.x < 0 || task.y < 0 || task.x >= g.width || task.y >= g.height)
        base::fail("-t", "the task position " + std::to_string(task.x) + " " + std::to_string(task.y) +
                             " is outside the picture of " + std::to_string(g.width) + " x " +
                             std::to_string(g.height) + " pixels");
    const Vec3 centre = g.direction(task.x, task.y);
    const double limit = inside_cosine(float(task.opening));
    double flux = 0, omega = 0;
    for (size_t i = 0; i < lum.size(); ++i) {
        if (g.omega[i] == 0 || !g.inside(dot(centre, g.direction(i)), limit)) continue;
        omega += std::fabs(g.omega[i]);
        if (g.valid(i) || as_they_are) flux += std::fabs(g.omega[i]) * lum.at(i);
    }
    return flux / omega;
}

float source_threshold(const Settings& s, bool has_task, double reference) {
    const float factor = float(s.threshold ? *s.threshold : has_task ? 5 : 2000);
    return factor > 100 ? factor : factor * float(reference);
}

double radius_in_pixels(const Geometry& g, double opening) {
    const int x = g.width / 2, y = g.height / 2;
    const double s = 2 * std::acos(std::clamp(dot(g.direction(x, y), g.direction(x + 10, y + 10)), -1.0, 1.0));
    return opening / (s / 10);
}

std::vector<Run> bright_runs(const Luminance& lum, const Geometry& g, double above) {
    std::vector<Run> runs;
    const float limit = grey_limit(above);
    std::vector<char> bright(size_t(g.width));
    for (int r = 0; r < g.height; ++r) {
        const size_t row = size_t(r) * g.width;
        const Span all = g.extent(r);
        compare(lum.grey + row + all.begin, size_t(all.end - all.begin), limit, bright.data() + all.begin);
        for (size_t s = g.row_spans[r]; s < g.row_spans[r + 1]; ++s) {
            const char *const first = bright.data(), *const end = first + g.spans[s].end;
            const auto next = [&](const char* from, char wanted) {
                const auto* const at = std::memchr(from, wanted, size_t(end - from));
                return at ? static_cast<const char*>(at) : end;
            };
            for (const char* at = next(first + g.spans[s].begin, 1); at < end;) {
                const char* const dark = next(at, 0);
                runs.push_back({uint32_t(row + size_t(at - first)), uint32_t(dark - at), 0});
                at = next(dark, 1);
            }
        }
    }
    return runs;
}

std::vector<float> cut_field(const Luminance& lum, const Geometry& g, int type) {
    std::vector<float> out(lum.grey, lum.grey + lum.size());
    for (size_t i = 0; i < lum.size(); ++i) {
        if (!g.valid(i)) continue;
        const Vec3 d = g.seen_direction(i);
        const EyeAngles a = eye_angles(g, d);
        const double tau = float(a.tau_deg);
        if (type == 3) out[i] = float(out[i] / position_index(g, d, PositionModel::guth));
        if (type == 1 ? outside_total_field(a.sigma_deg, tau, a.elevation_deg)
                      : outside_both_eyes(a.sigma_deg, tau, a.elevation_deg))
            out[i] = 0;
    }
    return out;
}

std::vector<float> fill_rows(const Luminance& lum, const Geometry& g, const Fill& fill) {
    const int w = lum.width, h = lum.height;
    if (fill.y_max < 1 || fill.y_max > h || fill.y_min < 0 || fill.y_min + 1 >= h)
        base::fail("-I", "rows " + std::to_string(fill.y_max) + " and " + std::to_string(fill.y_min) +
                             " do not lie in a picture of " + std::to_string(h) + " rows");
    std::vector<float> out(lum.grey, lum.grey + lum.size());
    for (int y = fill.y_min; y >= 1; --y)
        for (int x = 0; x < w; ++x) out[g.index(x, y)] = out[g.index(x, y + 1)];
    for (int y = fill.y_max; y < h; ++y)
        for (int x = 0; x < w; ++x)
            if (g.valid(g.index(x, y))) out[g.index(x, y)] = out[g.index(x, y - 1)];
    return out;
}

double black_corner_percent(const Luminance& lum) {
    const int cx = lum.width / 2, cy = lum.height / 2;
    const long radius = (cx + cy) / 2;
    long corner = 0, black = 0;
    for (int y = 0; y < lum.height; ++y)
        for (int x = 0; x < lum.width; ++x) {
            const long right = x - cx, up = y - cy;
            if (right * right + up * up <= radius * radius) continue;
            ++corner;
            black += lum.at(x, y) < 7;
        }
    return corner ? 100.0 * black / corner : 0;
}

}  // namespace glare
