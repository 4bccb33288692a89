// SPDX-License-Identifier: BSD-3-Clause
// See frame_zero.h.
#include "render/frame_zero.h"

#include <algorithm>
#include <cmath>

#include "image/grey.h"

namespace render {
using namespace kernels;
using image::grey;

namespace {
// Adds the samples of each pixel, those of the first half less those of the second, and their squares.  All samples of
// a pixel at once, and neighbouring pixels together.
void sum_samples(device::Device& device, const PixelSampling& sampling, int64_t begin, uint32_t count,
                 std::vector<double>& sum, std::vector<float>& half_off, std::vector<double>& squares) {
    const uint32_t pixels = sampling.params.nx * sampling.params.ny,
                   most = UINT32_MAX / pixels;  // indices of paths are 32 bits
    for (uint32_t done = 0; done < count;) {
        const uint32_t n = std::min(count - done, most), some = std::max(1u, device.preferred_batch_size() / n);
        for (uint32_t first = 0; first < pixels; first += some) {
            const uint32_t batch = std::min(some, pixels - first);
            const std::vector<float> rgb = run_pass(device, sampling, {MODE_DIRECT, begin + done, n, first, batch});
            const float* from = rgb.data();
            for (size_t pixel = first; pixel < first + batch; pixel++)
                for (uint32_t k = 0; k < n; k++) {
                    squares[pixel] += grey(from) * grey(from);
                    for (size_t c = 0; c < 3; c++) {
                        if (!half_off.empty()) half_off[3 * pixel + c] += done + k < count / 2 ? *from : -*from;
                        sum[3 * pixel + c] += double(*from++);
                    }
                }
        }
        done += n;
    }
}

// Light of a point, which represents `weight` pixels: twice, with independent noise.
void draw_point(FrameZero& zero, std::vector<double>& sum, uint32_t pixel, const float* first, const float* second,
                double weight, float right, float up) {
    for (size_t c = 0; c < 3; c++) sum[3 * size_t(pixel) + c] += weight * (double(first[c]) + double(second[c])) / 2;
    DrawnLight& to = zero.drawn[pixel];
    const double a = grey(first), b = grey(second), y = weight * (a + b) / 2;
    to.sum += y, to.right += y * double(right), to.up += y * double(up), to.squares += weight * a * b;
}

}  // namespace

void draw_sources(device::Device& device, const ViewPlan& plan, FrameZero& zero) {
    const SplatList& list = plan.drawn.straight;
    const std::vector<ImagePoint> images = draw_images(device, plan.sampling.params, plan.view, plan.drawn.images);
    if (list.rays.empty() && images.empty()) return;
    const std::vector<float> rgb = splat_sources(device, plan);
    const size_t pixels = size_t(plan.sampling.params.nx) * plan.sampling.params.ny;
    std::vector<double> sum(3 * pixels, 0.0);
    zero.drawn.resize(pixels);
    for (size_t i = 0; i < list.rays.size(); i++) {
        for (size_t c = 0; c < 3; c++) sum[3 * size_t(list.pixel[i]) + c] += double(rgb[3 * i + c]);
        DrawnLight& to = zero.drawn[list.pixel[i]];
        const double y = grey(&rgb[3 * i]);
        to.sum += y, to.right += y * double(list.right[i]), to.up += y * double(list.up[i]);
        if (y != 0) to.squares += y * y / double(list.rays[i].weight);
    }
    for (const ImagePoint& i : images)
        draw_point(zero, sum, i.pixel, i.first, i.second, double(i.weight), i.right, i.up);
    zero.exact.assign(sum.begin(), sum.end());
}

// Samples beyond m come after all frames in the sequence, so that no frame repeats them.
int64_t first_sample_of_zero(const ViewPlan& plan) { return plan.samples_of_zero > plan.m ? int64_t(1) << 31 : 0; }

std::vector<float> splat_sources(device::Device& device, const ViewPlan& plan) {
    const SplatList& list = plan.drawn.straight;
    std::vector<float> rgb;
    device::Params p = plan.sampling.params;
    p.mode = MODE_SPLAT;
    p.first = 0;
    p.path_count = uint32_t(list.rays.size());
    if (!list.rays.empty()) device.splat(p, list.rays, rgb);
    scrub(rgb);
    return rgb;
}

FrameZero draw_frame_zero(device::Device& device, const ViewPlan& plan) {
    const uint32_t count = plan.samples_of_zero;
    const size_t pixels = size_t(plan.sampling.params.nx) * plan.sampling.params.ny;
    std::vector<double> sum(3 * pixels, 0.0), squares(pixels, 0.0);
    FrameZero zero;
    zero.samples = count;
    zero.half_off.assign(plan.m % 2 ? 0 : sum.size(), 0.0f);
    sum_samples(device, plan.sampling, first_sample_of_zero(plan), count, sum, zero.half_off, squares);

    zero.mean.resize(sum.size());
    for (size_t i = 0; i < sum.size(); i++) zero.mean[i] = float(sum[i] / count);
    for (size_t i = 0; i < zero.half_off.size(); i++) {  // rounding must not make it larger than the mean
        const float whole = std::fabs(zero.mean[i]);
        zero.half_off[i] = std::clamp(zero.half_off[i] / float(count), -whole, whole);
    }
    zero.spread.resize(pixels);
    for (size_t i = 0; i < pixels; i++) {
        const double mean = grey(&zero.mean[3 * i]);
        zero.spread[i] = float(std::max(0.0, squares[i] / count - mean * mean));
    }
    draw_sources(device, plan, zero);
    return zero;
}

std::vector<float> values_of(const FrameZero& zero) {
    std::vector<float> out = zero.mean;
    for (size_t i = 0; i < zero.exact.size(); i++) out[i] += zero.exact[i];
    return out;
}

}  // namespace render
