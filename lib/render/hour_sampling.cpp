// SPDX-License-Identifier: BSD-3-Clause
// See hour_sampling.h.
#include "render/hour_sampling.h"

#include <algorithm>

#include "render/learn.h"

namespace render {
using namespace kernels;

namespace {

constexpr uint32_t samples_of_sun = 8;  // of each pixel in frame 0
// Of points.  A suffix vertex asks the suns of all hours, so that few of them should be met by many points and, where
// these are sensors in turn, by many others; for large grids that would take most of the time and memory.
constexpr size_t fewest_pixels = 64;
constexpr size_t enough_paths = 1024;
constexpr size_t most_met = size_t(1) << 18;  // paths of a sample times the members of the groups that each meets

uint32_t step_of_zero(uint32_t samples) {
    uint32_t step = 1;
    while (2 * step * samples_of_sun <= samples) step *= 2;
    return step;
}

// Leaves so many pixels to each point.  Returns the number of pixels.
size_t keep_copies(uint32_t most, PointLayout& layout, std::vector<PointRay>& rays) {
    std::vector<uint32_t> kept(layout.point.size());  // by point
    size_t pixels = 0;
    for (size_t pixel = 0; pixel < layout.point.size(); pixel++) {
        uint32_t& point = layout.point[pixel];
        if (point == PointLayout::none) continue;
        if (kept[point]++ < most) pixels++;
        else point = PointLayout::none, rays[pixel] = {};
    }
    return pixels;
}

void sample_points(ViewTables& tables, HourSampling& out) {
    device::Params& par = out.pixels.params;
    const size_t points = size_t(std::count_if(out.points.point.begin(), out.points.point.end(),
                                               [](uint32_t point) { return point != PointLayout::none; })) /
                          out.points.copies;
    const size_t pixels = keep_copies(uint32_t(std::max<size_t>(1, fewest_pixels / points)), out.points, tables.points);
    uint32_t samples = 1;
    while (2 * samples * pixels <= enough_paths) samples *= 2;
    out.pixels.samples_per_frame = out.samples_of_zero = samples;  // frame 0 cancels (plan_points())
    par.suns_step_eye = samples;
    par.reuse_rounds = REUSE_GROUPS;
    while (par.reuse_rounds > 1 && par.reuse_rounds * REUSE_GROUP * pixels > most_met) par.reuse_rounds /= 2;
    if (par.lr != -1) par.flags |= PF_GATHERS;
}

}  // namespace

HourSampling sample_hours(device::Device& device, const ViewPlan& plan, std::vector<Source> suns) {
    HourSampling out{plan.sampling, plan.points, plan.samples_of_zero};
    out.pixels.several.clear();
    device::Params& par = out.pixels.params;
    par = learn(device, plan).sampling.params;
    par.flags |= PF_HOURS;
    par.hours_sky_at = plan.scene.tables->hours_sky_at;
    par.suns_step = par.reuse_rounds = 1;
    par.suns_step_eye = step_of_zero(plan.samples_of_zero);

    ViewTables tables = *plan.sampling.params.view_tables;
    tables.focus.clear();
    tables.suns = std::move(suns);
    if (plan.points_room > 0) sample_points(tables, out);
    par = device::with_view(par, std::move(tables));
    return out;
}

}  // namespace render
