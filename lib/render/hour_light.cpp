// SPDX-License-Identifier: BSD-3-Clause
// See hour_light.h.
#include "render/hour_light.h"

#include <algorithm>
#include <cmath>

#include "base/wide.h"
#include "image/grey.h"

namespace render {
using namespace kernels;

WIDEST_LOOP void add_scaled(float* to, const float* from, float by, size_t n) {
    for (size_t i = 0; i < n; i++) to[i] += by * from[i];
}

HourValues hour_by_hour(const HourValues& block, size_t hours) {
    constexpr size_t line = 16;  // values of a cache line
    const size_t n = block.size() / hours;
    HourValues out(block.size());
    for (size_t first = 0; first < n; first += line)
        for (size_t h = 0; h < hours; h++)
            for (size_t i = first; i < std::min(n, first + line); i++) out[h * n + i] = block[i * hours + h];
    return out;
}

std::vector<float> values_of_hour(const HourValues& by_hour, size_t hours, size_t hour) {
    const auto n = long(by_hour.size() / hours);
    return {by_hour.begin() + long(hour) * n, by_hour.begin() + long(hour + 1) * n};
}

HourLight::HourLight(const std::vector<HourSky>& hours, size_t first, size_t count, bool drawn)
    : begin_(first), first_(&hours[first]), sky_(&hours[first], count), drawn_(drawn) {}

void HourLight::add_sky(const device::SkyShare& sky, float* to) const {
    float radiance[most_hours_together];
    const bool disc = (sky.kind & SKY_MIRRORED) != 0 || ((sky.kind & SKY_STRAIGHT) != 0 && !drawn_);
    sky_.radiance(sky.dir, disc && !first_->tinted, radiance);
    if (first_->tinted) return add_tinted(sky, disc, radiance, to);
    for (size_t c = 0; c < 3; c++) add_scaled(to + c * hours(), radiance, sky.rgb[c], hours());
}

// radiance: without the sun's disc.
void HourLight::add_tinted(const device::SkyShare& sky, bool disc, const float* radiance, float* to) const {
    float with_disc[most_hours_together];
    if (disc) sky_.radiance(sky.dir, true, with_disc);
    for (size_t h = 0; h < hours(); h++) {
        const HourSky::Tint& tint = first_[h].tint;
        const std::array<float, 3>& of = sky.dir[2] < 0 ? tint.ground : tint.sky;
        const float sun = disc ? with_disc[h] - radiance[h] : 0;
        for (size_t c = 0; c < 3; c++) to[c * hours() + h] += sky.rgb[c] * (radiance[h] * of[c] + sun * tint.sun[c]);
    }
}

void HourLight::add_suns(const PathFactors& f, size_t list, float by, float* to) const {
    const Factor *begin = f.suns.data() + f.suns_at[list], *end = f.suns.data() + f.suns_at[list + 1];
    begin = std::lower_bound(begin, end, begin_, [](const Factor& s, size_t hour) { return s.of < hour; });
    for (; begin < end && begin->of < begin_ + hours(); begin++) {
        const size_t hour = begin->of - begin_;
        float rgb[3];
        unpack(*begin, rgb);
        for (size_t c = 0; c < 3; c++) {
            const float tint = first_[hour].tint.sun[c];
            to[c * hours() + hour] += by * sky_.sun_irradiance(hour) * rgb[c] * tint;
        }
    }
}

void HourLight::add_own(const PathFactors& f, size_t path, float* to) const {
    add_suns(f, 2 * path, 1, to);
    if ((f.sky[path].kind & SKY_PATH) != 0) add_sky(f.sky[path], to);
}

void HourLight::add_suffix(const PathFactors& f, size_t path, float* to) const {
    add_suns(f, 2 * path + 1, 1, to);
    if ((f.sky[path].kind & SKY_SUFFIX) != 0) add_sky(f.sky[path], to);
}

namespace {

// Adds to n values the same ones of rows of a matrix, each times its factor.
WIDEST_LOOP void add_rows(float* to, const float* from, size_t row, const std::vector<uint32_t>& which, const float* by,
                          size_t n) {
    typedef float Wide __attribute__((vector_size(64), aligned(4), may_alias));
    constexpr size_t wide = 16;
    size_t at = 0;
    for (; at + 2 * wide <= n; at += 2 * wide) {  // two sums at once, in registers
        Wide *a = reinterpret_cast<Wide*>(to + at), *b = reinterpret_cast<Wide*>(to + at + wide), sa = *a, sb = *b;
        for (size_t i = 0; i < which.size(); i++) {
            const float* values = from + which[i] * row + at;
            sa += by[i] * *reinterpret_cast<const Wide*>(values);
            sb += by[i] * *reinterpret_cast<const Wide*>(values + wide);
        }
        *a = sa, *b = sb;
    }
    for (size_t i = 0; i < which.size(); i++)
        for (size_t k = at; k < n; k++) to[k] += by[i] * from[which[i] * row + k];
}

// The path has neither found nor shares any light: its pixel may be none.
bool is_empty(const PathFactors& f, size_t path) {
    return f.sky[path].kind == SKY_NONE && f.suns_at[2 * path] == f.suns_at[2 * path + 2] &&
           (f.shares_at.empty() || f.shares_at[path] == f.shares_at[path + 1]);
}

// The shares of a path in suffix vertices.
class Shares {
public:
    // suffix: 3 rows of n hours of each suffix vertex of its square; to: 3 rows.
    void add(const PathFactors& f, size_t path, const std::vector<float>& suffix, size_t n, float* to) {
        which_.clear();
        for (auto& by : by_) by.clear();
        for (uint64_t i = f.shares_at[path]; i < f.shares_at[path + 1]; i++) {
            float rgb[3];
            unpack(f.shares[i], rgb);
            which_.push_back(f.shares[i].of);
            for (size_t c = 0; c < 3; c++) by_[c].push_back(rgb[c]);
        }
        for (size_t c = 0; c < 3; c++) add_rows(to + c * n, &suffix[c * n], 3 * n, which_, by_[c].data(), n);
    }

private:
    std::vector<uint32_t> which_;
    std::vector<float> by_[3];
};

}  // namespace

HourValues light_frame(const PathFactors& f, size_t pixels, const HourLight& by) {
    const size_t n = by.hours(), row = 3 * n, paths = f.sky.size();
    const bool reuse = !f.shares_at.empty();
    const size_t together = reuse ? REUSE_SQUARE : 1;
    const float weight = 1 / float(f.samples);
    HourValues out(pixels * row, 0.0f);
    for (size_t i = 0; i < f.rest.size(); i++) {
        float* to = &out[(i / 3 / f.samples * 3 + i % 3) * n];
        for (size_t h = 0; h < n; h++) to[h] += weight * f.rest[i];
    }
    std::vector<float> own(row), suffix(together * row);
    Shares shares;
    const HourValues gathered = f.gathered ? light_frame(*f.gathered, paths, by) : HourValues();
    for (size_t first = 0; first < paths; first += together) {
        const size_t end = std::min(paths, first + together);
        if (reuse) std::fill(suffix.begin(), suffix.end(), 0.0f);
        for (size_t path = first; reuse && path < end; path++) {
            if (is_empty(f, path)) continue;
            float* to = &suffix[(path - first) * row];
            by.add_suffix(f, path, to);
            if (f.sky[path].kind == SKY_GATHERS)
                for (size_t c = 0; c < 3; c++)
                    add_scaled(to + c * n, &gathered[path * row + c * n], K_INV_PI * f.sky[path].rgb[c], n);
        }
        for (size_t path = first; path < end; path++) {
            const uint32_t sample = reuse ? f.sample[path] : uint32_t(path);
            if (sample == NONE || is_empty(f, path)) continue;
            std::fill(own.begin(), own.end(), 0.0f);
            by.add_own(f, path, own.data());
            if (reuse) shares.add(f, path, suffix, n, own.data());
            add_scaled(&out[sample / f.samples * row], own.data(), weight, row);
        }
    }
    return out;
}

DirectValues light_direct(const PathFactors& f, size_t first_pixel, const HourLight& by, uint32_t step,
                          const std::vector<uint32_t>& turn_of_pixel) {
    const size_t n = by.hours(), row = 3 * n, samples = f.samples, pixels = f.sky.size() / samples;
    const float weight = 1 / float(samples);
    DirectValues out{HourValues(pixels * row), HourValues(pixels * row), HourValues(pixels * n)};
    std::vector<float> one(row), sum(n), squares(n), count(n);
    for (size_t pixel = 0; pixel < pixels; pixel++) {
        float *mean = &out.mean[pixel * row], *off = &out.half_off[pixel * row], *spread = &out.spread[pixel * n];
        for (auto* v : {&sum, &squares, &count}) std::fill(v->begin(), v->end(), 0.0f);
        for (size_t k = 0; k < samples; k++) {
            const size_t path = pixel * samples + k;
            for (size_t c = 0; c < 3; c++) std::fill_n(&one[c * n], n, f.rest[3 * path + c]);
            by.add_own(f, path, one.data());
            add_scaled(mean, one.data(), weight, row);
            add_scaled(off, one.data(), k < samples / 2 ? weight : -weight, row);
            if (step > 1) by.add_own_suns(f, path, 1 / float(step) - 1, one.data());  // each asked counts `step` times
            for (size_t h = 0; h < n; h++) {
                const HourSky& hour = by.hour(h);
                const bool asked = !(hour.sun_radiance > 0) ||
                                   ((hour.number + turn_of_pixel[first_pixel + pixel] + k) & (step - 1)) == 0;
                const float y = float(image::grey_red) * one[h] + float(image::grey_green) * one[n + h] +
                                float(image::grey_blue) * one[2 * n + h];
                if (asked) sum[h] += y, squares[h] += y * y, count[h] += 1;
            }
        }
        for (size_t h = 0; h < n; h++) {
            const float m = count[h] > 0 ? sum[h] / count[h] : 0;
            spread[h] = count[h] > 0 ? std::max(0.0f, squares[h] / count[h] - m * m) : 0;
        }
        for (size_t i = 0; i < row; i++) off[i] = std::clamp(off[i], -std::fabs(mean[i]), std::fabs(mean[i]));
    }
    return out;
}

}  // namespace render
