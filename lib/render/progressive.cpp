// SPDX-License-Identifier: BSD-3-Clause
// Frames of Eq. 7.  L(0) = exact part (what is drawn by area) + S0, the mean of m samples of the direct class; frames
// 1..m carry the diffuse class; frame k > m adds S(k) - S0, so that for n >= m both classes are plain means of n
// samples and frame 0's own noise averages out (docs/spec/paper.md 7, docs/decisions/0002-frame-zero.md).  Half of the
// frames 1..m have the mean of the first half of frame 0's samples in place of S0, the other half that of the second
// half.  In noisy pixels, which have several samples in each frame, all frames k >= 1 add S(k) - S0.
#include "render/progressive.h"

#include <algorithm>
#include <future>

#include "device/device.h"
#include "render/beyond_limit.h"
#include "render/frame_zero.h"
#include "render/learn.h"
#include "render/pixel_moments.h"

namespace render {
using namespace kernels;

namespace {
// Means of so many consecutive samples.
std::vector<float> means_of(std::vector<float> rgb, uint32_t each) {
    if (each == 1) return rgb;
    std::vector<float> means(rgb.size() / each);
    for (size_t i = 0; i < means.size(); i++) {
        double sum = 0;
        for (size_t k = 0; k < each; k++) sum += double(rgb[3 * (i / 3 * each + k) + i % 3]);
        means[i] = float(sum / each);
    }
    return means;
}

// The samples of frames first .. first + count - 1 of all pixels, in order, until give(number, values) returns false.
// The first ones run one by one, later ones together where that is faster.  An asynchronous device has begun the next
// ones during the call of give().
template <class Give>
void for_samples(device::Device& device, const PixelSampling& sampling, int64_t first, int64_t count, Give&& give) {
    const uint32_t each = sampling.samples_per_frame;
    const int64_t most = std::max<int64_t>(1, device.preferred_batch_size() / each / path_count(sampling));
    const auto batch = [&](int64_t done) { return std::min({std::max<int64_t>(1, done), most, count - done}); };
    const auto begin = [&](int64_t done) {
        const Pass pass{MODE_FRAMES, (first + done - 1) * each + 1, uint32_t(batch(done)) * each, 0,
                        sampling.params.nx * sampling.params.ny};
        const auto when = device.is_async() ? std::launch::async | std::launch::deferred : std::launch::deferred;
        return std::async(when, [&, pass] { return run_pass(device, sampling, pass); });
    };
    std::future<std::vector<float>> next = begin(0);
    for (int64_t done = 0, n; done < count; done += n) {
        const std::vector<float> rgb = means_of(next.get(), each);
        n = batch(done);
        if (done + n < count) next = begin(done + n);
        std::vector<float> one(n > 1 ? rgb.size() / size_t(n) : 0);
        for (int64_t i = 0; i < n; i++) {
            for (size_t pixel = 0; 3 * pixel < one.size(); pixel++)
                std::copy_n(&rgb[3 * (size_t(n) * pixel + size_t(i))], 3, &one[3 * pixel]);
            if (!give(first + done + i, n > 1 ? one : rgb)) return;
        }
    }
}

// Frame k >= 1 of Eq. 7 from a sample of all pixels.
std::vector<float> frame_of(int64_t k, const ViewPlan& plan, const FrameZero& zero, const DiffusePlan& learned,
                            std::vector<float> v) {
    if (k > plan.m) {
        for (size_t i = 0; i < v.size(); i++) v[i] -= zero.mean[i];
        return v;
    }
    const float sign = image::in_first_half(k) ? 1.0f : -1.0f;
    const std::vector<float> sampled = v;
    for (size_t i = 0; i < zero.half_off.size(); i++) v[i] += sign * zero.half_off[i];
    for (const NoisyPixels& noisy : learned.noisy) {
        if (k <= int64_t(noisy.direct_above)) continue;
        for (const uint32_t pixel : noisy.pixels)
            for (size_t i = 3 * size_t(pixel); i < 3 * size_t(pixel) + 3; i++) v[i] = sampled[i] - zero.mean[i];
    }
    return v;
}
std::vector<float> picture_of(const ViewPlan& plan, std::vector<float> rgb) {
    return plan.points_room > 0 ? in_order(plan.points, rgb, plan.points_room) : rgb;
}
}  // namespace

void render_frames(device::Device& device, const ViewPlan& plan, int64_t first, int64_t count, bool moments,
                   const GiveFrame& give) {
    device.hold(plan.scene.tables);
    const int64_t end = first + count;
    const bool of_zero = first == 0 || end - 1 > plan.m || plan.m % 2 == 0 || plan.noisy_share > 0;  // frame_of()
    const FrameZero zero = of_zero ? draw_frame_zero(device, plan) : FrameZero();
    if (first == 0) {
        const image::Moments within = moments ? pixel_moments(device, plan, zero) : image::Moments();
        if (!give(0, picture_of(plan, values_of(zero)), within)) return;
        first = 1;
    }
    if (first >= end) return;
    const DiffusePlan learned = learn(device, plan);
    if (plan.tell_limit) warn_of_limit(device, learned.sampling.params, plan.view, zero.exact);
    for_samples(device, learned.sampling, first, end - first, [&](int64_t k, const std::vector<float>& values) {
        return give(k, picture_of(plan, frame_of(k, plan, zero, learned, values)), {});
    });
}

uint32_t samples_per_frame(const ViewPlan& plan) {
    return plan.sampling.samples_per_frame * std::max(1u, plan.points.copies);
}

}  // namespace render
