// SPDX-License-Identifier: BSD-3-Clause
// See samples.h.
#include "render/samples.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <fmt/core.h>

#include "base/error.h"
#include "render/noisy.h"

namespace render {
using namespace kernels;

namespace {
constexpr double reuse_equivalent_spp = 8;  // samples
constexpr uint32_t first_place = 5u << 29;  // first number of the samples of run_places, which no frame uses
}  // namespace

bool allows_path_reuse(const Params& par) {
    const bool mist = par.medium.x > 0 || par.medium.y > 0 || par.medium.z > 0;
    return par.ab > 0 && par.lr <= 0 && par.least_lobe_prob == 0 && (par.flags & PF_ANTIMATTER) == 0 && !mist;
}

uint32_t Samples::Several::first_of(uint64_t pixel) const {
    uint32_t low = 0, high = uint32_t(count());
    while (low < high) {
        const uint32_t middle = (low + high) / 2;
        if (word(middle, FOCUS_PIXEL) < pixel) low = middle + 1;
        else high = middle;
    }
    return low;
}

void Samples::add(Several several) {
    several.at = several_.empty() ? 0 : several_.back().at + uint32_t(several_.back().count());
    several_.push_back(std::move(several));
}

void Samples::send(device::Device& device) const {
    std::vector<uint32_t> all;
    for (const Several& s : several_) all.insert(all.end(), s.entries.begin(), s.entries.end());
    device.set_focus(std::move(all));
}

void Samples::set_focus(device::Device& device, const Focus& focus) {
    several_.clear();
    for (const FocusPart& part : focus) {
        Several s;
        s.spp = part.spp;
        s.reuse_equivalent_spp = reuse_equivalent_spp;
        for (const uint32_t pixel : part.pixels) s.entries.insert(s.entries.end(), {pixel, part.spp, 0});
        add(std::move(s));
    }
    send(device);
}

std::vector<uint32_t> Samples::add_noisy(device::Device& device, std::vector<uint32_t> spp) {
    for (const Several& s : several_)
        for (size_t entry = 0; entry < s.count(); entry++) spp[s.word(entry, FOCUS_PIXEL)] = 0;
    std::vector<uint32_t> pixels;
    Several s;
    s.spp = least_spp;
    s.direct_in_each_frame = true;
    for (uint32_t pixel = 0; pixel < spp.size(); pixel++) {
        if (spp[pixel] > 0) pixels.push_back(pixel);
        for (uint32_t from = 0; from < spp[pixel]; from += least_spp)
            s.entries.insert(s.entries.end(), {pixel, spp[pixel], from});
    }
    if (pixels.empty()) return pixels;
    add(std::move(s));
    send(device);
    return pixels;
}

// Smaller pictures than a square of groups are excluded: nearly all paths would lie outside of them.
bool Samples::reuses(const Params& par) const { return path_reuse_ && par.nx >= REUSE_SIDE && par.ny >= REUSE_SIDE; }

uint32_t Samples::path_count(const Params& base) const {
    return reuses(base) ? kernels::reuse_paths(base.nx, base.ny) : base.nx * base.ny;
}

void Samples::run(device::Device& device, const Params& base, const Pass& pass, std::vector<float>& rgb) {
    Params p = base;
    p.mode = pass.mode;
    p.frame = uint32_t(pass.first_sample);
    p.samples_per_pass = pass.n;
    p.first = pass.first_pixel * pass.n;
    p.path_count = pass.pixels * pass.n;
    if (reuses(base) && pass.mode == MODE_FRAMES) {
        p.reuse_path_count = kernels::reuse_paths(p.nx, p.ny);
        p.first = 0;
        p.path_count = p.reuse_path_count * pass.n;
    }
    device.run(p, rgb);
    scrub(rgb);
    for (const Several& several : several_) refine(device, base, pass, several, rgb);
}

// Pixels with several samples, among those of the pass, get the mean of all.  A sample with path reuse is kept with the
// weight of several others, because it has less noise; the mean is unbiased for any fixed weights.
void Samples::refine(device::Device& device, const Params& base, const Pass& pass, const Several& several,
                     std::vector<float>& rgb) {
    const uint32_t begin = several.first_of(pass.first_pixel),
                   end = several.first_of(uint64_t(pass.first_pixel) + pass.pixels);
    if (begin == end) return;
    const uint32_t most = UINT32_MAX / (uint32_t(several.count()) * several.spp);  // indices of paths are 32 bits
    const double reuse_weight = reuses(base) && pass.mode == MODE_FRAMES ? several.reuse_equivalent_spp : 0;
    Params p = base;
    p.mode = pass.mode;
    p.spp = several.spp;
    p.focus_at = several.at;
    if (several.direct_in_each_frame) p.skip_direct_below = 0;
    for (uint32_t done = 0, n; done < pass.n; done += n) {
        n = std::min(pass.n - done, most);
        p.frame = uint32_t(pass.first_sample + done);
        p.samples_per_pass = n * several.spp;
        const uint32_t first = begin * p.samples_per_pass, last = end * p.samples_per_pass;
        std::vector<double> sum(size_t(end - begin) * n * 3);
        for (p.first = first; p.first < last; p.first += p.path_count) {
            p.path_count = std::min(device.preferred_batch_size(), last - p.first);
            device.run(p, samples_);
            scrub(samples_);
            for (size_t i = 0; i < samples_.size(); i++)
                sum[(p.first - first + i / 3) / several.spp * 3 + i % 3] += double(samples_[i]);
        }
        for (uint32_t entry = begin, next; entry < end; entry = next) {  // entries of a pixel are consecutive
            const uint32_t pixel = several.word(entry, FOCUS_PIXEL), spp = several.word(entry, FOCUS_ALL);
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

void Samples::run_places(device::Device& device, const Params& base, const std::vector<uint32_t>& pixels, uint32_t n,
                         uint32_t redraw, std::vector<float>& rgb) {
    std::vector<uint32_t> entries;
    for (const uint32_t pixel : pixels) entries.insert(entries.end(), {pixel, n, 0});
    device.set_focus(std::move(entries));
    Params p = base;
    p.mode = MODE_DIRECT;
    p.frame = first_place;
    p.spp = p.samples_per_pass = n;
    p.focus_at = 0;
    p.redraw = redraw;
    const uint32_t all = uint32_t(pixels.size()) * n;
    rgb.clear();
    std::vector<float> some;
    for (p.first = 0; p.first < all; p.first += p.path_count) {
        p.path_count = std::min(device.preferred_batch_size(), all - p.first);
        device.run(p, some);
        rgb.insert(rgb.end(), some.begin(), some.end());
    }
    scrub(rgb);
    send(device);
}

void Samples::scrub(std::vector<float>& rgb) {
    constexpr float brightest = 1e32f;
    constexpr size_t enough = 300;
    size_t found = 0;
    for (float& v : rgb)
        if (!(std::fabs(v) <= brightest)) {
            v = 0;
            found++;
        }
    errno = 0;
    if (rgb.size() >= enough && found > rgb.size() / 2)
        base::fail_system("", fmt::format("{:.0f} % of a pass's samples are not numbers, or above 1e32",
                                          100 * double(found) / double(rgb.size())));
    if (found > 0 && !found_bad_) base::warn("", "samples that were not numbers, or above 1e32, were set to 0");
    found_bad_ = found_bad_ || found > 0;
}

}  // namespace render
