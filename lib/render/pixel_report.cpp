// SPDX-License-Identifier: BSD-3-Clause
// See pixel_report.h.
#include "render/pixel_report.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>

#include "image/grey.h"
#include "kernels/dialect/host.h"
#include "render/frame_zero.h"
#include "render/learn.h"
#include "render/pixel_moments.h"
#include "render/pixel_names.h"

namespace render {
using namespace kernels;
using device::Rgb;
using From = device::RecordedLight::From;

namespace {
Rgb times(const Rgb& a, const Rgb& b) { return {a[0] * b[0], a[1] * b[1], a[2] * b[2]}; }
Rgb times(const Rgb& a, double b) { return {a[0] * b, a[1] * b, a[2] * b}; }

class Explainer {
public:
    Explainer(const ViewPlan& plan, const scene::Scene& scene, uint32_t pixel, const GiveRow& give)
        : plan_(plan), names_(*plan.scene.tables, scene), pixel_(pixel), give_(give) {}

    // The paths of a sample of the pixel, which counts `weight` times in its value.
    void sample(const PixelSampling& sampling, uint32_t mode, int64_t sample, double weight, PixelRow row) const {
        const std::string name = row.path;
        for (const PixelPath& p : paths_of_pixel(sampling, mode, sample, pixel_)) {
            if (p.weight == 0 || weight == 0) continue;
            device::RecordedPaths r = device::record_paths(*plan_.scene.tables, p.params, p.path);
            scrub_recorded(r, p.path);
            row.path = name;
            give_path(r.paths[p.path], row, times({1, 1, 1}, weight * p.weight), false);
            for (const device::Connection& c : r.connections) {
                const uint32_t from = reuse_pixel(&p.params, p.params.first + c.path);
                row.path =
                    name + fmt::format(", suffix of {},{}", from % p.params.nx, p.params.ny - 1 - from / p.params.nx);
                give_path(r.paths[c.path], row, times(c.weight, weight * p.weight), true);
            }
        }
    }

    // Light of frame 0 that is drawn by area.
    void drawn(device::Device& device, PixelRow row) const {
        row.path = "drawn by area";
        row.weight = {1, 1, 1};
        const SplatList& list = plan_.drawn.straight;
        const std::vector<float> rgb = splat_sources(device, plan_);
        for (size_t i = 0; i < list.rays.size(); i++)
            if (list.pixel[i] == pixel_) give_light(row, names_.source(list.rays[i].source), &rgb[3 * i], 1);
        std::string suns;
        for (const uint32_t source : plan_.drawn.images.sources)
            suns += (suns.empty() ? "" : ", ") + names_.source(source);
        row.path = "image of the sun";
        for (const ImagePoint& i : draw_images(device, plan_.sampling.params, plan_.view, plan_.drawn.images)) {
            if (i.pixel != pixel_) continue;
            give_light(row, suns, i.first, double(i.weight) / 2);
            give_light(row, suns, i.second, double(i.weight) / 2);
        }
    }

    // A path of the pixel that no frame contains.
    void place(const device::Params& p) const {
        device::RecordedPaths r = device::record_paths(*plan_.scene.tables, p, 0);
        scrub_recorded(r, 0);
        give_path(r.paths[0], PixelRow(), {1, 1, 1}, false);
    }

private:
    void give_light(PixelRow row, const std::string& light, const float* rgb, double weight) const {
        row.light = light;
        row.rgb = times({double(rgb[0]), double(rgb[1]), double(rgb[2])}, weight);
        if (row.rgb != Rgb{}) give_(row);
    }

    std::string name_of(const device::RecordedLight& light, const PixelRow& row) const {
        switch (light.from) {
        case From::source: return names_.source(light.which);
        case From::distant: return names_.distant(light.which);
        case From::surface: return row.surface;
        case From::medium: return "medium";
        default: return "-av";
        }
    }

    // weight: of the radiance at the first vertex, or (shared) at the suffix vertex, whose shared light alone counts.
    void give_path(const device::RecordedPath& path, PixelRow row, const Rgb& weight, bool shared) const {
        row.vertex = 0;
        for (const device::RecordedVertex& v : path) {
            row.vertex++;
            if (shared && !v.behind_suffix && !v.at_suffix) continue;
            const Names::Name surface = v.prim == NO_HIT ? Names::Name{} : names_.surface(v.prim, v.inst);
            row.surface = surface.name;
            row.place = surface.place;
            row.material = names_.modifier(v.modifier).name;
            row.has_point = v.prim != NO_HIT;
            row.point = v.point;
            row.lobe = v.lobe;
            row.bounces = v.bounces;
            row.weight = shared && v.at_suffix ? weight : times(weight, v.throughput);
            bool any = false;
            for (const device::RecordedLight& light : v.lights) {
                if (light.shared != shared) continue;
                row.light = name_of(light, row);
                row.rgb = times(weight, light.rgb);
                give_(row);
                any = true;
            }
            row.light.clear();
            row.rgb = {};
            if (!any && (shared || !(v.behind_suffix || v.at_suffix))) give_(row);
        }
    }

    // As scrub(): a sample that is not a number, or too bright, is 0.
    void scrub_recorded(device::RecordedPaths& r, uint32_t which) const {
        Rgb sum{};
        const auto for_lights = [&](auto&& f) {
            for (device::RecordedVertex& v : r.paths[which])
                for (device::RecordedLight& l : v.lights)
                    if (!l.shared) f(l.rgb, Rgb{1, 1, 1});
            for (const device::Connection& c : r.connections)
                for (device::RecordedVertex& v : r.paths[c.path])
                    for (device::RecordedLight& l : v.lights)
                        if (l.shared) f(l.rgb, c.weight);
        };
        for_lights([&](Rgb& rgb, const Rgb& w) {
            for (size_t c = 0; c < 3; c++) sum[c] += rgb[c] * w[c];
        });
        for (size_t c = 0; c < 3; c++)
            if (!(std::fabs(sum[c]) <= brightest_sample)) for_lights([&](Rgb& rgb, const Rgb&) { rgb[c] = 0; });
    }

    const ViewPlan& plan_;
    const Names names_;
    const uint32_t pixel_;
    const GiveRow& give_;
};
}  // namespace

void explain_pixel(device::Device& device, const ViewPlan& plan, const scene::Scene& scene, int x, int y, int64_t first,
                   int64_t last, const GiveRow& give) {
    const uint32_t nx = plan.sampling.params.nx, ny = plan.sampling.params.ny,
                   pixel = (ny - 1 - uint32_t(y)) * nx + uint32_t(x);
    const Explainer explainer(plan, scene, pixel, give);
    const int64_t begin = std::max<int64_t>(first, 1);
    const double share = last >= begin ? 1 / double(last - begin + 1) : 0;   // of each frame k >= 1
    std::vector<double> zero(plan.samples_of_zero, first == 0 ? 1.0 : 0.0);  // weights of frame 0's samples, times m
    const DiffusePlan learned = last >= begin ? learn(device, plan) : DiffusePlan{plan.sampling, {}};
    const auto own_direct = [&](int64_t k) {
        return std::any_of(learned.noisy.begin(), learned.noisy.end(),
                           [&](const NoisyPixels& noisy) { return noisy.hold_direct(pixel, k); });
    };
    for (int64_t k = begin; k <= last; k++) {  // frame_of()
        for (size_t i = 0; i < zero.size(); i++) {
            const double half = i < zero.size() / 2 ? 1 : -1, sign = image::in_first_half(k) ? 1 : -1;
            if (k > plan.m || own_direct(k)) zero[i] -= share;
            else if (plan.m % 2 == 0) zero[i] += sign * half * share;
        }
    }
    PixelRow row;
    for (row.frame = begin; row.frame <= last; row.frame++) {
        row.path = "sample";
        explainer.sample(learned.sampling, MODE_FRAMES, row.frame, share, row);
    }
    row.frame = 0;
    if (first == 0) explainer.drawn(device, row);
    for (size_t i = 0; i < zero.size(); i++) {
        row.path = fmt::format("sample {} of frame 0", i + 1);
        explainer.sample(plan.sampling, MODE_DIRECT, first_sample_of_zero(plan) + int64_t(i),
                         zero[i] / double(zero.size()), row);
    }
}

MomentReport explain_moments(device::Device& device, const ViewPlan& plan, const scene::Scene& scene, int x, int y) {
    const uint32_t nx = plan.sampling.params.nx, ny = plan.sampling.params.ny,
                   pixel = (ny - 1 - uint32_t(y)) * nx + uint32_t(x);
    const FrameZero zero = draw_frame_zero(device, plan);
    const uint32_t n = places_of_pixels(zero, int(nx), int(ny))[pixel];
    const image::Moments all = pixel_moments(device, plan, zero);
    MomentReport out;
    for (size_t i = 0; i < out.moments.size(); i++) out.moments[i] = double((*all)[image::moment_numbers * pixel + i]);
    if (!(out.moments[image::moment_variance] > 0)) return out;

    // Covariance of both samples of each place, by light.
    std::map<std::string, std::vector<double>> by_light[2];
    std::vector<double> sum[2];
    for (uint32_t set = 0; set < 2; set++) {
        sum[set].assign(n, 0.0);
        device::Params p = params_of_places(plan.sampling, {pixel}, n, set);
        p.path_count = 1;
        for (p.first = 0; p.first < n; p.first++) {
            const GiveRow add = [&](const PixelRow& row) {
                if (row.light.empty()) return;
                std::vector<double>& light = by_light[set][row.light];
                light.resize(n);
                light[p.first] += image::grey(row.rgb);
                sum[set][p.first] += image::grey(row.rgb);
            };
            Explainer(plan, scene, pixel, add).place(p);
        }
    }
    double covariance = 0;
    for (uint32_t set = 0; set < 2; set++) {
        const std::vector<double>& other = sum[1 - set];
        double mean = 0;
        for (const double v : other) mean += v / n;
        for (const auto& [light, values] : by_light[set])
            for (uint32_t k = 0; k < n; k++) {
                const double part = values[k] * (other[k] - mean) / n / 2;
                out.variance_by_light[light] += part;
                covariance += part;
            }
    }
    const bool drawn = !zero.drawn.empty() && zero.drawn[pixel].sum > 0;
    if (drawn) out.variance_by_light["drawn by area"] = out.moments[image::moment_variance] - covariance;
    return out;
}

}  // namespace render
