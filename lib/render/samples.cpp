// SPDX-License-Identifier: BSD-3-Clause
// See samples.h.
#include "render/samples.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <fmt/core.h>

#include "base/error.h"

namespace render {
using namespace kernels;

namespace {
constexpr double reuse_equivalent_spp = 8;  // samples
constexpr uint32_t first_place = 5u << 29;  // first number of the samples of run_places, which no frame uses
}  // namespace

namespace {
// The first entry of this pixel or of one after it.
uint32_t first_entry(const Several& s, uint64_t pixel) {
    const auto before = [](const FocusEntry& entry, uint64_t p) { return entry.pixel < p; };
    return uint32_t(std::lower_bound(s.entries.begin(), s.entries.end(), pixel, before) - s.entries.begin());
}
}  // namespace

PixelSampling with_several(PixelSampling sampling, Several several) {
    ViewTables tables = *sampling.params.view_tables;
    several.at = uint32_t(tables.focus.size());
    tables.focus.insert(tables.focus.end(), several.entries.begin(), several.entries.end());
    sampling.params = device::with_view(sampling.params, std::move(tables));
    sampling.several.push_back(std::move(several));
    return sampling;
}

PixelSampling with_focus(PixelSampling sampling, const Focus& focus) {
    for (const FocusPart& part : focus) {
        Several s;
        s.spp = part.spp;
        s.reuse_equivalent_spp = reuse_equivalent_spp;
        for (const uint32_t pixel : part.pixels) s.entries.push_back({pixel, part.spp, 0, 0, 0});
        sampling = with_several(std::move(sampling), std::move(s));
    }
    return sampling;
}

namespace {
// Smaller pictures than a square of groups are excluded: nearly all paths would lie outside of them.
bool reuses(const PixelSampling& s) { return s.path_reuse && s.params.nx >= REUSE_SIDE && s.params.ny >= REUSE_SIDE; }

bool reuses(const PixelSampling& s, uint32_t mode) { return reuses(s) && mode == MODE_FRAMES; }

double weight_of_reuse(const PixelSampling& sampling, uint32_t mode, const Several& several) {
    return reuses(sampling, mode) ? several.reuse_equivalent_spp : 0;
}

device::Params params_of_several(const PixelSampling& sampling, uint32_t mode, const Several& several) {
    device::Params p = sampling.params;
    p.mode = mode;
    p.spp = several.spp;
    p.focus_at = several.at;
    if (several.direct_above) p.skip_direct_below = *several.direct_above;
    return p;
}

}  // namespace

device::Params params_of_pass(const PixelSampling& sampling, const Pass& pass) {
    device::Params p = sampling.params;
    p.mode = pass.mode;
    p.frame = uint32_t(pass.first_sample);
    p.samples_per_pass = pass.n;
    p.first = pass.first_pixel * pass.n;
    p.path_count = pass.pixels * pass.n;
    if (reuses(sampling, pass.mode)) {
        p.reuse_path_count = kernels::reuse_paths(p.nx, p.ny);
        p.first = 0;
        p.path_count = p.reuse_path_count * pass.n;
    }
    return p;
}

namespace {
// Pixels with several samples, among those of the pass, get the mean of all.  A sample with path reuse is kept with the
// weight of several others, because it has less noise; the mean is unbiased for any fixed weights.
void refine(device::Device& device, const PixelSampling& sampling, const Pass& pass, const Several& several,
            std::vector<float>& rgb) {
    const uint32_t begin = first_entry(several, pass.first_pixel),
                   end = first_entry(several, uint64_t(pass.first_pixel) + pass.pixels);
    if (begin == end) return;
    const uint32_t most =
        UINT32_MAX / (uint32_t(several.entries.size()) * several.spp);  // indices of paths are 32 bits
    const double reuse_weight = weight_of_reuse(sampling, pass.mode, several);
    device::Params p = params_of_several(sampling, pass.mode, several);
    std::vector<float> samples;
    for (uint32_t done = 0, n; done < pass.n; done += n) {
        n = std::min(pass.n - done, most);
        p.frame = uint32_t(pass.first_sample + done);
        p.samples_per_pass = n * several.spp;
        const uint32_t first = begin * p.samples_per_pass, last = end * p.samples_per_pass;
        std::vector<double> sum(size_t(end - begin) * n * 3);
        for (p.first = first; p.first < last; p.first += p.path_count) {
            p.path_count = std::min(device.preferred_batch_size(), last - p.first);
            device.run(p, samples);
            scrub(samples);
            for (size_t i = 0; i < samples.size(); i++)
                sum[(p.first - first + i / 3) / several.spp * 3 + i % 3] += double(samples[i]);
        }
        for (uint32_t entry = begin, next; entry < end; entry = next) {  // entries of a pixel are consecutive
            const auto [pixel, spp, from, suns_at, suns] = several.entries[entry];
            next = entry + spp / several.spp;
            for (size_t i = 0; i < size_t(n) * 3; i++) {
                double all = 0;
                for (uint32_t e = entry; e < next; e++) all += sum[size_t(e - begin) * n * 3 + i];
                float& value = rgb[3 * (size_t(pixel - pass.first_pixel) * pass.n + done) + i];
                value = float((all + reuse_weight * double(value)) / (spp + reuse_weight));
            }
        }
    }
}
}  // namespace

uint32_t path_count(const PixelSampling& s) {
    return reuses(s) ? kernels::reuse_paths(s.params.nx, s.params.ny) : s.params.nx * s.params.ny;
}

std::vector<float> run_pass(device::Device& device, const PixelSampling& sampling, const Pass& pass) {
    std::vector<float> rgb;
    device.run(params_of_pass(sampling, pass), rgb);
    scrub(rgb);
    for (const Several& several : sampling.several) refine(device, sampling, pass, several, rgb);
    return rgb;
}

std::vector<PixelPath> paths_of_pixel(const PixelSampling& sampling, uint32_t mode, int64_t sample, uint32_t pixel) {
    PixelPath all{params_of_pass(sampling, {mode, sample, 1, pixel, 1}), 0, 1};
    if (reuses(sampling, mode)) {
        uint32_t path = 0;
        while (reuse_pixel(&all.params, path) != pixel) path++;
        all.params.first = path / REUSE_SQUARE * REUSE_SQUARE;
        all.params.path_count = REUSE_SQUARE;
        all.path = path % REUSE_SQUARE;
    }
    std::vector<PixelPath> out{all};
    for (const Several& several : sampling.several) {
        const double reuse_weight = weight_of_reuse(sampling, mode, several);
        for (uint32_t entry = first_entry(several, pixel), end = first_entry(several, uint64_t(pixel) + 1); entry < end;
             entry++) {
            const double share = 1 / (several.entries[entry].spp + reuse_weight);
            out[0].weight = reuse_weight * share;
            PixelPath one{params_of_several(sampling, mode, several), 0, share};
            one.params.frame = uint32_t(sample);
            one.params.samples_per_pass = several.spp;
            one.params.path_count = 1;
            for (uint32_t k = 0; k < several.spp; k++) {
                one.params.first = entry * several.spp + k;
                out.push_back(one);
            }
        }
    }
    return out;
}

device::Params params_of_places(const PixelSampling& sampling, const std::vector<uint32_t>& pixels, uint32_t n,
                                uint32_t redraw) {
    ViewTables tables = *sampling.params.view_tables;
    tables.focus.clear();
    for (const uint32_t pixel : pixels) tables.focus.push_back({pixel, n, 0, 0, 0});
    device::Params p = device::with_view(sampling.params, std::move(tables));
    p.focus_at = 0;
    p.mode = MODE_DIRECT;
    p.frame = first_place;
    p.spp = p.samples_per_pass = n;
    p.redraw = redraw;
    return p;
}

std::vector<float> run_places(device::Device& device, const PixelSampling& sampling,
                              const std::vector<uint32_t>& pixels, uint32_t n, uint32_t redraw) {
    device::Params p = params_of_places(sampling, pixels, n, redraw);
    const uint32_t all = uint32_t(pixels.size()) * n;
    std::vector<float> rgb, some;
    for (p.first = 0; p.first < all; p.first += p.path_count) {
        p.path_count = std::min(device.preferred_batch_size(), all - p.first);
        device.run(p, some);
        rgb.insert(rgb.end(), some.begin(), some.end());
    }
    scrub(rgb);
    return rgb;
}

void scrub(std::vector<float>& rgb) {
    constexpr size_t enough = 300;
    size_t found = 0;
    for (float& v : rgb)
        if (!(std::fabs(v) <= brightest_sample)) {
            v = 0;
            found++;
        }
    errno = 0;
    if (rgb.size() >= enough && found > rgb.size() / 2)
        base::fail_system("", fmt::format("{:.0f} % of a pass's samples are not numbers, or above 1e32",
                                          100 * double(found) / double(rgb.size())));
    if (found > 0) base::warn("", "samples that were not numbers, or above 1e32, were set to 0");
}

}  // namespace render
