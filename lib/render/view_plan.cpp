// SPDX-License-Identifier: BSD-3-Clause
// See view_plan.h.
#include "render/view_plan.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <fmt/core.h>

#include "base/error.h"
#include "base/memory.h"
#include "render/fingerprint.h"
#include "render/scene_params.h"
#include "render/view_params.h"
#include "sampling/mixture_weights.h"

namespace render {
using namespace kernels;

namespace {
// In small pictures frame 0 costs little, and a single noisy pixel holds much of the light: m is two or four times as
// large, up to half a million samples in all.
uint32_t more_for_few(size_t pixels) {
    constexpr size_t enough = 256 * 256;
    return 4 * pixels <= enough ? 4 : 2 * pixels <= enough ? 2 : 1;
}
// Does the eye lie on a surface (PF_EYE_ON_SURFACE)?  Its rays must not hit that surface (RADIANCE: a hit within 1e-6
// does not stop a ray), but rounding decides on which side of it they begin.  Of short rays through the eye, one
// crosses each surface that contains it.
bool eye_on_surface(const flatten::FlatScene& flat, const flatten::HostTracer& tracer, base::Vec3 eye) {
    using base::Vec3;
    const Vec3 p = eye - flat.centre;
    const double size = flat.radius + std::fabs(p.x) + std::fabs(p.y) + std::fabs(p.z);
    const double far = std::ldexp(size, -18);  // well above Surface.rounding
    for (int k = 0; k < 27; k++) {
        const Vec3 d{k % 3 - 1.0, k / 3 % 3 - 1.0, k / 9 - 1.0};
        if (length(d) == 0) continue;
        const Vec3 dir = base::unit(d);
        if (tracer.closest(eye - dir * far, dir, 0, 2 * far, flatten::HostTracer::all).t >= 0) return true;
    }
    return false;
}

// All frames hold both classes, so that frame 0's noise cancels, and nothing is drawn by area.
void plan_points(const RenderView& v, const flatten::FlatScene& flat, ViewPlan& plan) {
    device::Params& par = plan.sampling.params;
    plan.m = par.skip_direct_below = 0;
    plan.noisy_share = 0;
    plan.points = lay_out(v.points->points);
    plan.points_room = size_t(v.nx) * size_t(v.ny);
    plan.sampling.samples_per_frame = plan.points.samples_per_frame;
    par.nx = plan.points.nx;
    par.ny = plan.points.ny;
    par.flags |= v.points->sensors ? PF_SENSORS : PF_EYE_ON_SURFACE;
    ViewTables tables = view_tables({}, flat);
    tables.points = point_rays(*v.points, plan.points, flat);
    par = device::with_view(par, std::move(tables));
}
}  // namespace

flatten::Viewpoint viewpoint_of(const RenderView& v) {
    if (!v.points || v.points->points.empty()) return v.view.vp;
    const std::vector<image::Point>& points = v.points->points;
    const auto median = [&](auto&& value) {
        std::vector<double> values;
        for (const image::Point& point : points) values.push_back(value(point.p));
        const auto half = values.begin() + std::ptrdiff_t(values.size() / 2);
        std::nth_element(values.begin(), half, values.end());
        return *half;
    };
    const base::Vec3 middle{median([](base::Vec3 p) { return p.x; }), median([](base::Vec3 p) { return p.y; }),
                            median([](base::Vec3 p) { return p.z; })};
    return {middle, median([&](base::Vec3 p) { return length(p - middle); })};
}

void require_memory(const RenderView& v) {
    constexpr uint64_t pixel = 60;  // bytes: frame 0's sums in double, a sample, a frame and its output buffer
    const uint64_t memory = base::machine_memory(), least = pixel * uint64_t(v.nx) * uint64_t(v.ny);
    if (memory == 0 || least <= memory) return;
    errno = 0;
    base::fail_system("-x, -y", fmt::format("{} x {} pixels need at least {:.1f} GB; this machine has {:.1f} GB", v.nx,
                                            v.ny, double(least) * 1e-9, double(memory) * 1e-9));
}

ViewPlan plan_view(device::Device& device, const LoadedScene& scene, const RenderView& v, const RenderOptions& o) {
    const flatten::FlatScene& flat = *scene.tables;
    device.hold(scene.tables);
    const std::string bits = device.own_bits(), of_device = bits.empty() ? "" : " device:" + bits;
    ViewPlan plan;
    plan.scene = scene;
    plan.view = v.view;
    plan.nx = v.nx, plan.ny = v.ny;
    device::Params& par = plan.sampling.params;
    par = {params_of(flat, o), nullptr};
    par.nx = uint32_t(v.nx);
    par.ny = uint32_t(v.ny);
    set_view(par, v.view, flat.centre);
    sampling::pick_all_portals(uint32_t(flat.portals.size()), 0, 0, par);
    plan.sampling.path_reuse = o.sampling == Sampling::reuse && allows_path_reuse(par);
    plan.noisy_share = o.sampling == Sampling::reuse ? o.noisy_share : 0;
    if (o.more_if_small) par.skip_direct_below *= more_for_few(size_t(v.nx) * size_t(v.ny));
    plan.m = plan.samples_of_zero = par.skip_direct_below;

    if (v.points) {
        plan_points(v, flat, plan);
        plan.fingerprint = fingerprint(scene.geometry, flat, "points " + v.points->hash, v.nx, v.ny, o, {}) + of_device;
        return plan;
    }
    const flatten::HostTracer tracer(flat);
    const bool one_eye = v.view.type != 'l' && v.view.vo == 0 && o.pd <= 0;
    const bool on_surface = one_eye && eye_on_surface(flat, tracer, v.view.vp);
    if (on_surface || !one_eye) par.flags |= PF_EYE_ON_SURFACE;  // its rays may begin on a surface
    // drawing needs one eye point, and straight rays no unattenuated path through glass
    plan.may_draw = o.pd <= 0 && o.dv && !o.i;
    const bool drawable = plan.may_draw && !flat.sources.empty();
    plan.drawn = find_drawn_sources(device, scene, tracer, v.view, drawable && !on_surface, drawable, par);
    par = device::with_view(par, view_tables(plan.drawn, flat));
    plan.sampling = with_focus(std::move(plan.sampling), v.focus);
    plan.tell_limit = o.tell_limit;
    plan.fingerprint = fingerprint(scene.geometry, flat, view::to_options(v.view), v.nx, v.ny, o, v.focus) + of_device;
    return plan;
}

}  // namespace render
