// SPDX-License-Identifier: BSD-3-Clause
// See hour_moments.h.
#include "render/hour_moments.h"

#include <algorithm>
#include <map>

#include "base/threads.h"
#include "image/grey.h"

namespace render {
using namespace kernels;

namespace {

constexpr uint32_t fewer_places = 4;  // than an hour by itself
constexpr size_t moments_at_once = 1u << 16;

// By pixel, its places of hour after hour: grey.
struct PlaceValues {
    std::vector<HourValues> a, b;
};

// By hour and pixel: number of places.
using Places = std::vector<std::vector<uint32_t>>;

// k places of each pixel; a pixel asks the suns of the hours that have k places in it.
device::Params params_of_hours(const PixelSampling& sampling, const std::vector<uint32_t>& pixels, uint32_t k,
                               bool second, const std::vector<HourSky>& hours, const Places& places,
                               std::vector<uint32_t>& hour_of_sun) {
    device::Params par = params_of_places(sampling, pixels, k, second ? 1 : 0);
    ViewTables tables = *par.view_tables;
    tables.suns = suns_of(hours, hour_of_sun);
    for (FocusEntry& entry : tables.focus) {
        entry.suns_at = uint32_t(tables.asked.size());
        for (uint32_t sun = 0; sun < hour_of_sun.size(); sun++)
            if (places[hour_of_sun[sun]][entry.pixel] == k) tables.asked.push_back(sun);
        entry.suns = uint32_t(tables.asked.size()) - entry.suns_at;
    }
    par = device::with_view(par, std::move(tables));
    par.suns_step_eye = 1;
    par.flags |= PF_ASKS;
    par.first = 0;
    par.path_count = uint32_t(pixels.size()) * k;
    return par;
}

// f: of these places.
void light_places(const PathFactors& f, uint32_t k, const HourLight& light, const std::vector<uint32_t>& pixels,
                  std::vector<HourValues>& out) {
    const size_t n = light.hours();
    base::on_all(pixels.size(), [&](size_t i) {
        HourValues& values = out[pixels[i]];
        values.resize(k * n);
        HourValues rgb(3 * n);
        for (size_t place = 0; place < k; place++) {
            const size_t path = i * k + place;
            for (size_t c = 0; c < 3; c++) std::fill_n(&rgb[c * n], n, f.rest[3 * path + c]);
            light.add_own(f, path, rgb.data());
            for (size_t h = 0; h < n; h++) {
                const float one[] = {rgb[h], rgb[n + h], rgb[2 * n + h]};
                values[h * k + place] = float(image::grey(one));
            }
        }
    });
}

}  // namespace

std::vector<image::Moments> moments_of_hours(device::Device& device, const PixelSampling& sampling, const HourLight& by,
                                             const std::vector<FrameZero>& zeros) {
    const int nx = int(sampling.params.nx), ny = int(sampling.params.ny);
    const size_t n = by.hours(), pixels = size_t(nx) * size_t(ny);
    Places places;
    std::map<uint32_t, std::vector<bool>> wanted;  // by number of places: pixels that have so many in some hour
    for (const FrameZero& zero : zeros) {
        places.push_back(places_of_pixels(zero, nx, ny, fewer_places));
        for (size_t i = 0; i < pixels; i++)
            if (places.back()[i] > 0) {
                std::vector<bool>& some = wanted[places.back()[i]];
                some.resize(pixels, false);
                some[i] = true;
            }
    }
    std::vector<HourSky> hours;
    for (size_t h = 0; h < n; h++) hours.push_back(by.hour(h));
    std::map<uint32_t, PlaceValues> values;
    for (const auto& [k, of] : wanted) {
        std::vector<uint32_t> all;
        for (uint32_t i = 0; i < pixels; i++)
            if (of[i]) all.push_back(i);
        for (std::vector<HourValues>* to : {&values[k].a, &values[k].b}) {
            to->resize(pixels);
            for (size_t from = 0; from < all.size(); from += moments_at_once / k) {
                const std::vector<uint32_t> some(all.begin() + long(from),
                                                 all.begin() + long(std::min(all.size(), from + moments_at_once / k)));
                std::vector<uint32_t> hour_of_sun;
                const device::Params par =
                    params_of_hours(sampling, some, k, to == &values[k].b, hours, places, hour_of_sun);
                light_places(draw_factors(device, par, k, hour_of_sun), k, HourLight(hours, 0, n, by.drawn()), some,
                             *to);
            }
        }
    }
    std::vector<image::Moments> out(n);
    base::on_all(n, [&](size_t h) {
        out[h] = moments_of(zeros[h], nx, ny, places[h], [&](const std::vector<uint32_t>& some, uint32_t k) {
            Pairs pairs;
            for (const uint32_t pixel : some) {
                const float *a = &values[k].a[pixel][h * k], *b = &values[k].b[pixel][h * k];
                pairs.a.insert(pairs.a.end(), a, a + k);
                pairs.b.insert(pairs.b.end(), b, b + k);
            }
            return pairs;
        });
    });
    return out;
}

}  // namespace render
