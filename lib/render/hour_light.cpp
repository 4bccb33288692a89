// SPDX-License-Identifier: BSD-3-Clause
// See hour_light.h.
#include "render/hour_light.h"

#include <algorithm>
#include <cmath>

#include "image/grey.h"

namespace render {
using namespace kernels;

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
__attribute__((target_clones("avx512f", "avx2", "default")))
#endif
void add_scaled(float* to, const float* from, float by, size_t n) {
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

HourLight::HourLight(const std::vector<HourSky>& hours, size_t first, size_t count,
                     const std::vector<uint32_t>& hour_of_sun, bool drawn)
    : first_(&hours[first]), sky_(&hours[first], count), place_(hour_of_sun.size(), none), drawn_(drawn) {
    for (size_t sun = 0; sun < hour_of_sun.size(); sun++)
        if (hour_of_sun[sun] >= first && hour_of_sun[sun] < first + count)
            place_[sun] = uint32_t(hour_of_sun[sun] - first);
}

void HourLight::add_sky(const device::SkyShare& sky, float* to) const {
    float radiance[most_hours_together];
    const bool disc = (sky.kind & SKY_MIRRORED) != 0 || ((sky.kind & SKY_STRAIGHT) != 0 && !drawn_);
    sky_.radiance(sky.dir, disc, radiance);
    for (size_t c = 0; c < 3; c++) add_scaled(to + c * hours(), radiance, sky.rgb[c], hours());
}

void HourLight::add_suns(const PathFactors& f, size_t list, float by, float* to) const {
    for (uint64_t i = f.suns_at[list]; i < f.suns_at[list + 1]; i++) {
        const uint32_t hour = place_[f.suns[i].sun];
        if (hour == none) continue;
        float rgb[3];
        unpack(f.suns[i], rgb);
        for (size_t c = 0; c < 3; c++) to[c * hours() + hour] += by * sky_.sun_irradiance(hour) * rgb[c];
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

HourValues light_frame(const PathFactors& f, size_t pixels, const HourLight& by) {
    const size_t n = by.hours(), row = 3 * n, paths = f.sky.size();
    const bool reuse = !f.shares.empty();
    const size_t together = reuse ? REUSE_SQUARE : 1;
    const float weight = 1 / float(f.samples);
    HourValues out(pixels * row, 0.0f);
    for (size_t i = 0; i < f.rest.size(); i++) {
        float* to = &out[(i / 3 / f.samples * 3 + i % 3) * n];
        for (size_t h = 0; h < n; h++) to[h] += weight * f.rest[i];
    }
    std::vector<float> own(row), suffix(together * row);
    for (size_t first = 0; first < paths; first += together) {
        const size_t end = std::min(paths, first + together);
        if (reuse) std::fill(suffix.begin(), suffix.end(), 0.0f);
        for (size_t path = first; reuse && path < end; path++) by.add_suffix(f, path, &suffix[(path - first) * row]);
        for (size_t path = first; path < end; path++) {
            const uint32_t sample = reuse ? f.sample[path] : uint32_t(path);
            if (sample == NONE) continue;
            std::fill(own.begin(), own.end(), 0.0f);
            by.add_own(f, path, own.data());
            for (size_t m = 0; reuse && m < REUSE_GROUP; m++) {
                const float *share = &f.shares[3 * (path * REUSE_GROUP + m)],
                            *from = &suffix[reuse_member(uint32_t(path - first), uint32_t(m)) * row];
                for (size_t c = 0; c < 3; c++)
                    if (share[c] != 0) add_scaled(&own[c * n], from + c * n, share[c], n);
            }
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
