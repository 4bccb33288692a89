// SPDX-License-Identifier: BSD-3-Clause
// See hour_suns.h.
#include "render/hour_suns.h"

#include <cmath>
#include <numeric>

#include "base/angle.h"
#include "flatten/pack.h"
#include "image/grey.h"
#include "render/image_tracer.h"
#include "render/picture_place.h"

namespace render {
using namespace kernels;
using base::Vec3;

namespace {
constexpr uint32_t points_of_look = 64, points_of_whole = 256;
constexpr uint32_t points_of_cut = 4096;  // of a sun that something hides in part: error about 1/n^(3/4) of it
}  // namespace

bool draws_suns(const ViewPlan& plan) {
    const device::Params& par = plan.sampling.params;
    return par.points_count == 0 && plan.view.type != 'l' && plan.view.va <= 0 && plan.view.vo <= 0 &&
           par.lens_diameter <= 0 && (par.flags & PF_DV) != 0 && (par.flags & (PF_IRRADIANCE | PF_EYE_ON_SURFACE)) == 0;
}

namespace {

// Rays to so many points of each of these suns, in the pixels that show them, and what arrives per radiance.
struct SunPoints {
    SplatList list;
    std::vector<float> rgb;
};
SunPoints trace_points(device::Device& device, const ViewPlan& plan, device::Params par,
                       const std::vector<uint32_t>& which, uint32_t points) {
    SunPoints out;
    const view::Projector projector(plan.view);
    const int nx = int(par.nx), ny = int(par.ny);
    const Vec3 eye = plan.view.vp - plan.scene.tables->centre;
    for (const uint32_t i : which)
        for (uint32_t k = 0; k < points; k++) {
            const Source& sun = par.view_tables->suns[i];
            const double r = std::sqrt(unit_step(k, first_step)), turn = 2 * base::pi * unit_step(k, second_step);
            const Vec3 dir = unit(flatten::vec_of(sun.centre) + flatten::vec_of(sun.u) * (r * std::cos(turn)) +
                                  flatten::vec_of(sun.v) * (r * std::sin(turn)));
            const auto place = place_of(projector, dir, nx, ny);
            if (!place) continue;
            device::SplatRay ray{};
            flatten::put(ray.org, eye);
            flatten::put(ray.dir, dir);
            ray.dist = FAR_AWAY;
            ray.weight = float(double(sun.area) / points / place->sr * nx * ny);
            ray.source = i | SUN_OF_HOUR;
            out.list.rays.push_back(ray);
            out.list.pixel.push_back(place->pixel);
            out.list.right.push_back(place->right);
            out.list.up.push_back(place->up);
        }
    par.mode = MODE_SPLAT;
    par.first = 0;
    par.path_count = uint32_t(out.list.rays.size());
    if (!out.list.rays.empty()) device.splat(par, out.list.rays, out.rgb);
    scrub(out.rgb);
    return out;
}

void add_points(const SunPoints& points, std::vector<std::vector<DrawnSun>>& out) {
    const SplatList& list = points.list;
    for (size_t i = 0; i < list.rays.size(); i++) {
        const float* rgb = &points.rgb[3 * i];
        const double y = image::grey(rgb);
        if (y == 0) continue;
        std::vector<DrawnSun>& of_sun = out[list.rays[i].source & ~SUN_OF_HOUR];
        size_t at = 0;
        while (at < of_sun.size() && of_sun[at].pixel != list.pixel[i]) at++;
        if (at == of_sun.size()) of_sun.push_back({list.pixel[i], {}, {}});
        DrawnSun& to = of_sun[at];
        for (size_t c = 0; c < 3; c++) to.rgb[c] += rgb[c];
        to.light.sum += y, to.light.right += y * double(list.right[i]), to.light.up += y * double(list.up[i]);
        to.light.squares += y * y / double(list.rays[i].weight);
    }
}

}  // namespace

std::vector<std::vector<DrawnSun>> draw_suns(device::Device& device, const ViewPlan& plan, const device::Params& par) {
    const size_t count = par.view_tables->suns.size();
    std::vector<std::vector<DrawnSun>> out(count);
    if (!draws_suns(plan)) return out;
    std::vector<uint32_t> all(count), whole, cut, lit(count, 0);
    std::iota(all.begin(), all.end(), 0u);
    const SunPoints look = trace_points(device, plan, par, all, points_of_look);
    for (size_t i = 0; i < look.list.rays.size(); i++) {
        const uint32_t sun = look.list.rays[i].source & ~SUN_OF_HOUR;
        if (image::grey(&look.rgb[3 * i]) != 0) lit[sun]++;
    }
    for (const uint32_t i : all)
        if (lit[i] > 0) (lit[i] == points_of_look ? whole : cut).push_back(i);
    add_points(trace_points(device, plan, par, whole, points_of_whole), out);
    add_points(trace_points(device, plan, par, cut, points_of_cut), out);
    return out;
}

void add_drawn_suns(const std::vector<DrawnSun>& drawn, const HourSky& hour, FrameZero& zero) {
    if (drawn.empty()) return;
    zero.exact.resize(zero.mean.size());
    zero.drawn.resize(zero.spread.size());
    const auto radiance = float(hour.sun_radiance);
    const double L = radiance;
    for (const DrawnSun& d : drawn) {
        for (size_t c = 0; c < 3; c++) zero.exact[3 * size_t(d.pixel) + c] += radiance * d.rgb[c] * hour.tint.sun[c];
        DrawnLight& to = zero.drawn[d.pixel];
        to.sum += L * d.light.sum, to.right += L * d.light.right, to.up += L * d.light.up;
        to.squares += L * L * d.light.squares;
    }
}

}  // namespace render
