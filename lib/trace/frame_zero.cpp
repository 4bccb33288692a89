// SPDX-License-Identifier: BSD-3-Clause
// See frame_zero.h.
#include "trace/frame_zero.h"

#include <algorithm>
#include <cmath>

namespace trace {

namespace {
// Adds up the samples of each pixel, and those of the first half less those of the other.  Pixel by pixel, all its
// samples at once: neighbours in the picture are followed together.
void sum_samples(Device& device, Samples& sampler, const Params& base, int64_t begin, uint32_t count,
                 std::vector<double>& sum, std::vector<float>& half_off) {
    const uint32_t pixels = base.nx * base.ny, most = UINT32_MAX / pixels;  // indices of slots are 32 bits
    std::vector<float> rgb;
    for (uint32_t done = 0; done < count;) {
        const uint32_t n = std::min(count - done, most), some = std::max(1u, device.good_slots() / n);
        for (uint32_t first = 0; first < pixels; first += some) {
            const uint32_t together = std::min(some, pixels - first);
            sampler.run(device, base, {MODE_DIRECT, begin + done, n, first, together}, rgb);
            const float* from = rgb.data();
            for (size_t pixel = first; pixel < first + together; pixel++)
                for (uint32_t k = 0; k < n; k++)
                    for (size_t c = 0; c < 3; c++) {
                        if (!half_off.empty()) half_off[3 * pixel + c] += done + k < count / 2 ? *from : -*from;
                        sum[3 * pixel + c] += double(*from++);
                    }
        }
        done += n;
    }
}

std::vector<float> draw_sources(Device& device, Samples& sampler, const Params& base, const DrawList& drawn) {
    if (drawn.rays.empty()) return {};
    std::vector<float> rgb;
    Params p = base;
    p.mode = MODE_DRAW;
    p.first = 0;
    p.slots = uint32_t(drawn.rays.size());
    device.draw(p, drawn.rays, rgb);
    sampler.scrub(rgb);
    std::vector<double> sum(size_t(base.nx) * base.ny * 3, 0.0);
    for (size_t i = 0; i < drawn.rays.size(); i++)
        for (size_t c = 0; c < 3; c++) sum[3 * size_t(drawn.pixel[i]) + c] += double(rgb[3 * i + c]);
    return {sum.begin(), sum.end()};
}
}  // namespace

FrameZero draw_frame_zero(Device& device, Samples& sampler, const Params& base, uint32_t m, uint32_t count,
                          const DrawList& drawn) {
    std::vector<double> sum(size_t(base.nx) * base.ny * 3, 0.0);
    FrameZero zero;
    zero.half_off.assign(m % 2 ? 0 : sum.size(), 0.0f);
    // More than m are drawn behind all frames, so that those above m do not draw them again.
    sum_samples(device, sampler, base, count > m ? int64_t(1) << 31 : 0, count, sum, zero.half_off);

    zero.mean.resize(sum.size());
    for (size_t i = 0; i < sum.size(); i++) zero.mean[i] = float(sum[i] / count);
    for (size_t i = 0; i < zero.half_off.size(); i++) {  // rounding must not take away more than there is
        const float whole = std::fabs(zero.mean[i]);
        zero.half_off[i] = std::clamp(zero.half_off[i] / float(count), -whole, whole);
    }
    zero.exact = draw_sources(device, sampler, base, drawn);
    return zero;
}

}  // namespace trace
