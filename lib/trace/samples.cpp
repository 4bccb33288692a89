// SPDX-License-Identifier: BSD-3-Clause
// See samples.h.
#include "trace/samples.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace trace {

namespace {
constexpr double worth_of_shared = 8;  // copies
}

void Samples::set_focus(Device& device, const Focus& focus) {
    focus_ = focus;
    focus_at_.clear();
    std::vector<uint32_t> pixels;
    for (const FocusPart& part : focus_) {
        focus_at_.push_back(uint32_t(pixels.size()));
        pixels.insert(pixels.end(), part.pixels.begin(), part.pixels.end());
    }
    device.set_focus(std::move(pixels));
}

// Pictures smaller than a square of groups do not: nearly all slots would lie beside them.
bool Samples::shares(const Params& par) const { return may_share_ && par.nx >= SHARE_SIDE && par.ny >= SHARE_SIDE; }

uint32_t Samples::slots(const Params& base) const {
    return shares(base) ? kernels::share_slots(base.nx, base.ny) : base.nx * base.ny;
}

void Samples::run(Device& device, const Params& base, const Pass& pass, std::vector<float>& rgb) {
    Params p = base;
    p.mode = pass.mode;
    p.frame = uint32_t(pass.first_sample);
    p.together = pass.n;
    p.first = pass.first_pixel * pass.n;
    p.slots = pass.pixels * pass.n;
    if (shares(base) && pass.mode == MODE_FRAMES) {
        p.shared_slots = kernels::share_slots(p.nx, p.ny);
        p.first = 0;
        p.slots = p.shared_slots * pass.n;
    }
    device.run(p, rgb);
    scrub(rgb);
    for (size_t part = 0; part < focus_.size(); part++) refine(device, base, pass, part, rgb);
}

// Samples of a part of the focus, as far as the pass has its pixels, become means of their copies.  A shared sample
// stays and counts for several copies: it is less noisy than one, and any fixed weights keep the expectation.
void Samples::refine(Device& device, const Params& base, const Pass& pass, size_t part, std::vector<float>& rgb) {
    const auto& [pixels, copies] = focus_[part];
    const auto place_of = [&pixels = pixels](uint64_t pixel) {
        return uint32_t(std::lower_bound(pixels.begin(), pixels.end(), pixel) - pixels.begin());
    };
    const uint32_t begin = place_of(pass.first_pixel), end = place_of(uint64_t(pass.first_pixel) + pass.pixels);
    const uint32_t most = UINT32_MAX / (uint32_t(pixels.size()) * copies);  // indices of slots are 32 bits
    Params p = base;
    p.mode = pass.mode;
    p.copies = copies;
    p.focus_at = focus_at_[part];
    for (uint32_t done = 0, n; begin < end && done < pass.n; done += n) {
        n = std::min(pass.n - done, most);
        p.frame = uint32_t(pass.first_sample + done);
        p.together = n * copies;
        const uint32_t first = begin * p.together, last = end * p.together;
        const double before = shares(base) && pass.mode == MODE_FRAMES ? worth_of_shared : 0;
        std::vector<double> sum(size_t(end - begin) * n * 3);
        for (p.first = first; p.first < last; p.first += p.slots) {
            p.slots = std::min(device.good_slots(), last - p.first);
            device.run(p, copies_);
            scrub(copies_);
            for (size_t i = 0; i < copies_.size(); i++)
                sum[(p.first - first + i / 3) / copies * 3 + i % 3] += double(copies_[i]);
        }
        for (size_t i = 0; i < sum.size(); i++) {
            const size_t pixel = pixels[begin + i / 3 / n] - pass.first_pixel, sample = done + i / 3 % n;
            float& value = rgb[3 * (pixel * pass.n + sample) + i % 3];
            value = float((sum[i] + before * double(value)) / (copies + before));
        }
    }
}

void Samples::scrub(std::vector<float>& rgb) {
    constexpr float brightest = 1e32f;
    int64_t found = 0;
    for (float& v : rgb)
        if (!(std::fabs(v) <= brightest)) {
            v = 0;
            found++;
        }
    if (found && !bad_) base::warn("", "samples that were not numbers, or above 1e32, were set to 0");
    bad_ += found;
}

}  // namespace trace
