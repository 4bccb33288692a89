// SPDX-License-Identifier: BSD-3-Clause
// See frame_zero.h.
#include "render/frame_zero.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "image/grey.h"

namespace render {
using namespace kernels;
using image::grey;

namespace {
constexpr uint32_t most_places = 256;         // of a pixel
constexpr size_t samples_at_once = 1u << 19;  // of places

// In small pictures a pixel holds much of the light, and samples cost little.
uint32_t least_places(size_t pixels) {
    constexpr size_t enough = 1u << 18;  // places, of all pixels
    constexpr uint32_t least = 4, most = 64;
    uint32_t n = least;
    while (n < most && 2 * n * pixels <= enough) n *= 2;
    return n;
}

// Light of a point, which represents `weight` pixels: twice, with independent noise.
void draw_point(FrameZero& zero, std::vector<double>& sum, uint32_t pixel, const float* first, const float* second,
                double weight, float right, float up) {
    for (size_t c = 0; c < 3; c++) sum[3 * size_t(pixel) + c] += weight * (double(first[c]) + double(second[c])) / 2;
    DrawnLight& to = zero.drawn[pixel];
    const double a = grey(first), b = grey(second), y = weight * (a + b) / 2;
    to.sum += y, to.right += y * double(right), to.up += y * double(up), to.squares += weight * a * b;
}

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

// Adds the mean of n samples, in order; moments: of the pixel.
void add_fresh(const float* rgb, const float* others, uint32_t n, double weight, float* mean, float* moments) {
    const double each = weight / (others ? 2 * n : n);
    double sum[3] = {0, 0, 0}, off = 0;
    for (const float* from : {rgb, others})
        for (uint32_t k = 0; from && k < n; k++, from += 3) {
            for (size_t c = 0; c < 3; c++) sum[c] += each * double(from[c]);
            off += (k < n / 2 ? each : -each) * grey(from);
        }
    for (size_t c = 0; c < 3; c++) mean[c] += float(sum[c]);
    moments[image::moment_frame0] += float(off);
}

// Draws n places of each of these pixels.
void draw_places(device::Device& device, const ViewPlan& plan, const std::vector<uint32_t>& pixels, uint32_t n,
                 bool pairs, FrameZero& zero, PixelMoments& moments) {
    const size_t step = std::max<size_t>(1, samples_at_once / n);
    for (size_t first = 0; first < pixels.size(); first += step) {
        const std::vector<uint32_t> some(pixels.begin() + long(first),
                                         pixels.begin() + long(std::min(pixels.size(), first + step)));
        const std::vector<float> a = run_places(device, plan.sampling, some, n, 0),
                                 b = pairs ? run_places(device, plan.sampling, some, n, 1) : std::vector<float>();
        for (size_t k = 0; k < some.size(); k++) {
            const float *const one = &a[3 * n * k], *const other = pairs ? &b[3 * n * k] : nullptr;
            add_fresh(one, other, n, 1 - weight_of_probes(plan), &zero.mean[3 * size_t(some[k])], moments.of(some[k]));
            moments.add_places(some[k], one, other, n);
        }
    }
}
}  // namespace

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

double weight_of_probes(const ViewPlan& plan) { return plan.probes < plan.m ? 1. / 16 : 1; }

std::vector<Fresh> fresh_samples(const ViewPlan& plan, const Probes& probes, const DiffusePlan& learned) {
    const uint32_t least = least_places(probes.variance.size());
    const std::vector<bool> uneven = uneven_pixels(probes, int(plan.sampling.params.nx), int(plan.sampling.params.ny));
    std::vector<Fresh> out(uneven.size(), {plan.probes < plan.m ? plan.probes : 0, false});
    for (size_t i = 0; i < out.size(); i++) {
        if (!uneven[i] || out[i].places == 0) continue;
        uint32_t n = least;
        const uint32_t spp = learned.spp[i];  // m frames would have m spp samples
        while (spp > 1 && n < most_places && 2 * n < plan.m * spp) n *= 2;
        out[i] = {n, true};
    }
    return out;
}

FrameZero draw_frame_zero(device::Device& device, const ViewPlan& plan, const Probes& probes,
                          const DiffusePlan& learned) {
    FrameZero zero;
    const double own = weight_of_probes(plan);
    PixelMoments moments(probes, int(plan.sampling.params.nx), int(plan.sampling.params.ny));
    zero.mean.resize(probes.mean.size());
    for (size_t i = 0; i < zero.mean.size(); i++) zero.mean[i] = float(own * double(probes.mean[i]));
    for (uint32_t i = 0; i < probes.half_off.size(); i++)
        moments.of(i)[image::moment_frame0] = float(own * double(probes.half_off[i]));
    const std::vector<Fresh> fresh = fresh_samples(plan, probes, learned);
    std::map<std::pair<uint32_t, bool>, std::vector<uint32_t>> alike;
    for (uint32_t i = 0; i < fresh.size(); i++)
        if (fresh[i].places > 0) alike[{fresh[i].places, fresh[i].pairs}].push_back(i);
    for (const auto& [how, pixels] : alike) draw_places(device, plan, pixels, how.first, how.second, zero, moments);
    draw_sources(device, plan, zero);
    zero.moments = moments.finish(zero.mean, zero.drawn);
    return zero;
}

std::vector<float> values_of(const FrameZero& zero) {
    std::vector<float> out = zero.mean;
    for (size_t i = 0; i < zero.exact.size(); i++) out[i] += zero.exact[i];
    return out;
}

}  // namespace render
