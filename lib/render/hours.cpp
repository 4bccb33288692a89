// SPDX-License-Identifier: BSD-3-Clause
// See hours.h.
#include "render/hours.h"

#include <algorithm>
#include <cmath>

#include "base/angle.h"
#include "base/hash.h"
#include "base/shutdown.h"
#include "base/threads.h"
#include "render/hour_light.h"
#include "render/hour_moments.h"
#include "render/hour_sampling.h"
#include "render/hour_suns.h"

namespace render {
using namespace kernels;

namespace {

constexpr uint64_t most_bytes = uint64_t(9) << 26;  // .6 GB of factors: with pictures and tables less than 1 GB
constexpr size_t paths_at_once = 1u << 16;

// Hours together, so that the pictures of all their frames fit.
size_t hours_together(size_t pixels, size_t frames) {
    constexpr size_t most_bytes = size_t(1) << 27;
    size_t n = most_hours_together;
    while (n > 1 && n * pixels * 12 * frames > most_bytes) n /= 2;
    return n;
}

// The factors of a picture.
class Hours {
public:
    Hours(device::Device& device, const ViewPlan& plan, const std::vector<HourSky>& hours, const HoursWanted& wanted)
        : device_(device), plan_(plan), hours_(hours), wanted_(wanted) {
        HourSampling sampling = sample_hours(device, plan, suns_of(hours, hour_of_sun_));
        sampling_ = std::move(sampling.pixels);
        points_ = std::move(sampling.points);
        samples_of_zero_ = sampling.samples_of_zero;
        pixels_ = size_t(sampling_.params.nx) * sampling_.params.ny;

        draw_sources(device, plan, drawn_);
        suns_ = draw_suns(device, plan, sampling_.params);
        if (!draw_zero()) return;
        const uint32_t each = sampling_.samples_per_frame;
        for (int64_t k = first_diffuse(); k <= wanted.last; k++) {
            tell("paths", double(k) / double(wanted.last + 1));
            const Pass pass{MODE_FRAMES, (k - 1) * each + 1, each, 0, uint32_t(pixels_)};
            frames_.push_back(draw_factors(device, params_of_pass(sampling_, pass), each, hour_of_sun_));
            bytes_ += frames_.back().bytes();
            if (!fits(bytes_ + frames_.back().bytes() * uint64_t(wanted.last - k))) return;
        }
    }
    // Else the factors of so many hours would take too much memory, and are not all there.
    bool complete() const { return complete_; }
    const PointLayout& points() const { return points_; }

    // All frames of hours first .. first + count - 1.
    bool give_block(size_t first, size_t count, const GiveHourFrame& give) const {
        const HourLight by(hours_, first, count, draws_suns(plan_));
        const DirectValues direct = light_zero(by);
        const DirectValues by_hour{hour_by_hour(direct.mean, count), hour_by_hour(direct.half_off, count),
                                   hour_by_hour(direct.spread, count)};
        std::vector<FrameZero> zeros;
        for (size_t h = 0; h < count; h++) zeros.push_back(zero_of(by_hour, count, first, h));
        std::vector<image::Moments> moments(count);
        if (wanted_.first == 0 && wanted_.moments && plan_.points_room == 0)
            moments = moments_of_hours(device_, sampling_, by, zeros);
        std::vector<HourValues> frames(frames_.size());
        base::on_all(frames.size(), [&](size_t i) {
            end_on_signal();
            frames[i] = hour_by_hour(frame_of(i, direct, by), count);
        });
        for (size_t h = 0; h < count; h++) {
            if (wanted_.first == 0 && !give(first + h, 0, values_of(zeros[h]), moments[h])) return false;
            for (size_t i = 0; i < frames.size(); i++)
                if (!give(first + h, first_diffuse() + int64_t(i), values_of_hour(frames[i], count, h), {}))
                    return false;
        }
        return true;
    }

private:
    void tell(const char* doing, double share) const {
        if (wanted_.tell) wanted_.tell(doing, share);
    }
    int64_t first_diffuse() const { return std::max<int64_t>(1, wanted_.first); }
    static void end_on_signal() {
        if (base::shutdown_requested()) throw device::Cancelled{};
    }
    bool fits(uint64_t bytes) {
        complete_ = bytes <= most_bytes || hours_.size() <= most_hours_together;
        return complete_;
    }

    // Returns false where they do not fit.
    bool draw_zero() {
        const uint32_t n = samples_of_zero_, some = std::max<uint32_t>(1, uint32_t(paths_at_once) / n);
        const device::Params& par = sampling_.params;
        for (uint32_t first = 0; first < pixels_; first += some) {
            tell("what the eye sees", double(first) / double(pixels_));
            const uint32_t batch = std::min(some, uint32_t(pixels_) - first);
            const Pass pass{MODE_DIRECT, first_sample_of_zero(plan_), n, first, batch};
            zero_.push_back(draw_factors(device_, params_of_pass(sampling_, pass), n, hour_of_sun_));
            zero_at_.push_back(first);
            bytes_ += zero_.back().bytes();
            if (!fits(bytes_ / (first + batch) * pixels_)) return false;
        }
        for (uint32_t pixel = 0; pixel < pixels_; pixel++)
            turn_.push_back(
                hash32(sampler_start(par.seed_lo, par.seed_hi, pixel, uint32_t(first_sample_of_zero(plan_)), 0).key));
        return true;
    }

    DirectValues light_zero(const HourLight& by) const {
        DirectValues all;
        std::vector<DirectValues> parts(zero_.size());
        base::on_all(parts.size(), [&](size_t i) {
            end_on_signal();
            parts[i] = light_direct(zero_[i], zero_at_[i], by, sampling_.params.suns_step_eye, turn_);
        });
        const auto add = [](HourValues& to, const HourValues& from) { to.insert(to.end(), from.begin(), from.end()); };
        for (const DirectValues& part : parts)
            add(all.mean, part.mean), add(all.half_off, part.half_off), add(all.spread, part.spread);
        return all;
    }

    FrameZero zero_of(const DirectValues& direct, size_t count, size_t first, size_t h) const {
        FrameZero zero = drawn_;
        zero.samples = samples_of_zero_;
        zero.mean = values_of_hour(direct.mean, count, h);
        zero.half_off = values_of_hour(direct.half_off, count, h);
        zero.spread = values_of_hour(direct.spread, count, h);
        for (size_t sun = 0; sun < suns_.size(); sun++)
            if (hour_of_sun_[sun] == first + h) add_drawn_suns(suns_[sun], hours_[first + h], zero);
        return zero;
    }

    // Frame k of Eq. 7, as frame_of() of progressive.cpp.
    HourValues frame_of(size_t i, const DirectValues& direct, const HourLight& by) const {
        const int64_t k = first_diffuse() + int64_t(i);
        HourValues v = light_frame(frames_[i], pixels_, by);
        if (k > plan_.m) add_scaled(v.data(), direct.mean.data(), -1, v.size());
        else add_scaled(v.data(), direct.half_off.data(), image::in_first_half(k) ? 1.0f : -1.0f, v.size());
        return v;
    }

    device::Device& device_;
    const ViewPlan& plan_;
    const std::vector<HourSky>& hours_;
    const HoursWanted& wanted_;
    PixelSampling sampling_;
    PointLayout points_;
    uint32_t samples_of_zero_ = 0;
    size_t pixels_ = 0;
    std::vector<uint32_t> hour_of_sun_;
    FrameZero drawn_;                          // lamps: the same in all hours
    std::vector<std::vector<DrawnSun>> suns_;  // by sun
    std::vector<PathFactors> zero_, frames_;
    std::vector<size_t> zero_at_;  // first pixel of each part
    uint64_t bytes_ = 0;           // of factors
    bool complete_ = true;
    std::vector<uint32_t> turn_;  // of each pixel (light_direct())
};

}  // namespace

void render_hours(device::Device& device, const ViewPlan& plan, const std::vector<HourSky>& hours,
                  const HoursWanted& wanted, const GiveHourFrame& give) {
    device.hold(plan.scene.tables);
    const size_t pixels = size_t(plan.sampling.params.nx) * plan.sampling.params.ny;
    const size_t n = hours_together(pixels, size_t(wanted.last - wanted.first + 2));
    // Halved where they do not fit: an hour's frames do not depend on the others.
    size_t most = std::min(hours.size(), most_hours);
    for (size_t begin = 0; begin < hours.size();) {
        const size_t count = std::min(most, hours.size() - begin);
        const std::vector<HourSky> some(hours.begin() + long(begin), hours.begin() + long(begin + count));
        const Hours all(device, plan, some, wanted);
        if (!all.complete()) {
            most = std::max(most_hours_together, (count + 1) / 2);
            continue;
        }
        const auto give_points = [&](size_t hour, int64_t k, const std::vector<float>& rgb, const image::Moments& m) {
            return give(begin + hour, k, plan.points_room > 0 ? in_order(all.points(), rgb, plan.points_room) : rgb, m);
        };
        for (size_t first = 0; first < count; first += n)
            if (!all.give_block(first, std::min(n, count - first), give_points)) return;
        begin += count;
    }
}

std::string why_apart(const ViewPlan& plan) {
    if (plan.sampling.params.may_absorb != 0) return "the scene has absorbing media";
    if (plan.scene.mirrors_sources) return "the scene has materials that make virtual suns (mirror, prism)";
    return "";
}

std::vector<bool> have_images(const ViewPlan& plan, const std::vector<HourSky>& hours) {
    std::vector<bool> out(hours.size());
    if (plan.points_room > 0 || plan.scene.smooth.planes.empty() || !plan.may_draw) return out;
    const flatten::HostTracer tracer(*plan.scene.tables);
    const double radius = sun_radius_deg * M_PI / 180;
    for (size_t i = 0; i < hours.size(); i++)
        out[i] = hours[i].sun_radiance > 0 &&
                 shows_image(tracer, plan.scene.smooth, plan.view, plan.nx, plan.ny, hours[i].sun, radius);
    return out;
}

std::string shared_paths(const ViewPlan& plan) { return base::hash_of(plan.fingerprint); }

std::string hour_part(const HourSky& h) {
    base::Hash hash;
    hash.add_all(std::vector<double>{h.sun.x, h.sun.y, h.sun.z, h.sun_radiance, h.level, h.ground, h.horizon});
    hash.add_all(std::vector<double>(h.shape, h.shape + 5));
    return " hour:" + hash.text();
}

}  // namespace render
