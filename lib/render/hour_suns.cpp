// SPDX-License-Identifier: BSD-3-Clause
// See hour_suns.h.
#include "render/hour_suns.h"

#include <cmath>

#include "base/angle.h"
#include "flatten/pack.h"
#include "image/grey.h"
#include "render/image_tracer.h"
#include "render/picture_place.h"

namespace render {
using namespace kernels;
using base::Vec3;

namespace {
constexpr uint32_t points_of_sun = 256;
}

bool draws_suns(const ViewPlan& plan) {
    const device::Params& par = plan.sampling.params;
    return par.points_count == 0 && plan.view.type != 'l' && plan.view.va <= 0 && plan.view.vo <= 0 &&
           par.lens_diameter <= 0 && (par.flags & PF_DV) != 0 && (par.flags & (PF_IRRADIANCE | PF_EYE_ON_SURFACE)) == 0;
}

std::vector<std::vector<DrawnSun>> draw_suns(device::Device& device, const ViewPlan& plan, const device::Params& par) {
    const std::vector<Source>& suns = par.view_tables->suns;
    std::vector<std::vector<DrawnSun>> out(suns.size());
    if (!draws_suns(plan)) return out;
    const view::Projector projector(plan.view);
    const int nx = int(par.nx), ny = int(par.ny);
    const Vec3 eye = plan.view.vp - plan.scene.tables->centre;
    SplatList list;
    for (uint32_t i = 0; i < suns.size(); i++)
        for (uint32_t k = 0; k < points_of_sun; k++) {
            const double r = std::sqrt(unit_step(k, first_step)), turn = 2 * base::pi * unit_step(k, second_step);
            const Vec3 dir = unit(flatten::vec_of(suns[i].centre) + flatten::vec_of(suns[i].u) * (r * std::cos(turn)) +
                                  flatten::vec_of(suns[i].v) * (r * std::sin(turn)));
            const auto place = place_of(projector, dir, nx, ny);
            if (!place) continue;
            device::SplatRay ray{};
            flatten::put(ray.org, eye);
            flatten::put(ray.dir, dir);
            ray.dist = FAR_AWAY;
            ray.weight = float(double(suns[i].area) / points_of_sun / place->sr * nx * ny);
            ray.source = i | SUN_OF_HOUR;
            list.rays.push_back(ray);
            list.pixel.push_back(place->pixel);
            list.right.push_back(place->right);
            list.up.push_back(place->up);
        }
    if (list.rays.empty()) return out;
    std::vector<float> rgb;
    device::Params p = par;
    p.mode = MODE_SPLAT;
    p.first = 0;
    p.path_count = uint32_t(list.rays.size());
    device.splat(p, list.rays, rgb);
    scrub(rgb);
    for (size_t i = 0; i < list.rays.size(); i++) {
        const double y = image::grey(&rgb[3 * i]);
        if (y == 0) continue;
        std::vector<DrawnSun>& of_sun = out[list.rays[i].source & ~SUN_OF_HOUR];
        size_t at = 0;
        while (at < of_sun.size() && of_sun[at].pixel != list.pixel[i]) at++;
        if (at == of_sun.size()) of_sun.push_back({list.pixel[i], {}, {}});
        DrawnSun& to = of_sun[at];
        for (size_t c = 0; c < 3; c++) to.rgb[c] += rgb[3 * i + c];
        to.light.sum += y, to.light.right += y * double(list.right[i]), to.light.up += y * double(list.up[i]);
        to.light.squares += y * y / double(list.rays[i].weight);
    }
    return out;
}

void add_drawn_suns(const std::vector<DrawnSun>& drawn, float radiance, FrameZero& zero) {
    if (drawn.empty()) return;
    zero.exact.resize(zero.mean.size());
    zero.drawn.resize(zero.spread.size());
    const double L = radiance;
    for (const DrawnSun& d : drawn) {
        for (size_t c = 0; c < 3; c++) zero.exact[3 * size_t(d.pixel) + c] += radiance * d.rgb[c];
        DrawnLight& to = zero.drawn[d.pixel];
        to.sum += L * d.light.sum, to.right += L * d.light.right, to.up += L * d.light.up;
        to.squares += L * L * d.light.squares;
    }
}

}  // namespace render
