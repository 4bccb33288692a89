// SPDX-License-Identifier: BSD-3-Clause
// See reading.h.
#include "glare/reading.h"
#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <utility>
#include "base/error.h"
#include "base/split.h"
#include "glare/position_index.h"
#include "glare/threshold.h"

namespace glare {
namespace {

// A picture of irradiance (-i of ptrace and RADIANCE's programs), by the command line in its header.
bool is_of_irradiance(const image::Header& header) {
    bool out = false;
    for (const std::string& line : header.lines) {
        const std::vector<std::string> words = base::split_words(line);
        const std::string program = words.empty() ? "" : words[0].substr(words[0].rfind('/') + 1);
        if (program != "ptrace" && program != "rpict" && program != "rvu" && program != "rpiece") continue;
        for (const std::string& word : words)
            if (base::begins_with(word, "-i") && word.size() <= 3) out = word != "-i-";
    }
    return out;
}

std::vector<RegionPixels> lay_regions(const Plan& plan, const Geometry& g, const std::string& place) {
    if (!plan.regions) return {};
    image::MaskSet drawn;
    if (plan.draw) drawn = plan.draw(g.projector.view(), g.width, g.height);
    const image::MaskSet& regions = plan.draw ? drawn : *plan.regions;
    if (regions.width != g.width || regions.height != g.height)
        base::fail(place, "the picture has " + std::to_string(g.width) + " x " + std::to_string(g.height) +
                              " pixels, the regions " + std::to_string(regions.width) + " x " +
                              std::to_string(regions.height));
    std::vector<RegionPixels> out;
    for (const image::Mask& m : regions.masks) out.emplace_back(m.coverage, g);
    return out;
}

PixelSets pixel_sets(const Plan& plan, const Geometry& g) {
    const Settings& settings = plan.settings;
    PixelSets out;
    if (!(plan.requirements & require::sources)) return out;
    if (settings.band_rad) out.band = band_pixels(g, *settings.band_rad);
    if (settings.mask_file) out.mask = mask_pixels(*settings.mask_file, g);
    if (!settings.zones) return out;
    const Circle& inner = settings.zones->inner;
    if (inner.x < 0 || inner.y < 0 || inner.x >= g.width || inner.y >= g.height)
        base::fail("-l", "the zone's centre is outside the picture");
    out.zone1 = zone_pixels(g, *settings.zones, 1);
    if (settings.zones->outer_opening) out.zone2 = zone_pixels(g, *settings.zones, 2);
    return out;
}

// Where two sources are joined from two thirds of a pixel nearer and farther, but that neighbouring pixels always are.
// The gap between two edges, each anywhere in its pixel, differs by more from that between the pixels' centres in one
// case of nine.
std::vector<FindSources> other_reaches(const Plan& plan, const Geometry& g) {
    constexpr double diagonal = 1.5, known = 2. / 3;
    std::vector<FindSources> out;
    const double pitch = std::sqrt(g.omega[g.index(g.width / 2, g.height / 2)]), own = plan.settings.search_opening / 2;
    for (const double reach : {std::min(own, std::max(own - known * pitch, diagonal * pitch)), own + known * pitch}) {
        Settings settings = plan.settings;
        settings.search_opening = 2 * reach;
        out.push_back(plan.methods.sources(g, settings));
    }
    return out;
}

// All but the regions.
ViewTables tables_of(const SharedPlan& plan, const view::View& view, const image::Picture& picture,
                     const std::string& place) {
    if (plan->settings.patches && view.type != 'a') base::fail("-z", "patches need an angular fisheye view (-vta)");
    if (view.type == 'l') base::fail(place, "a parallel view (-vtl) has no eye point: glare is not defined for it");
    try {
        view::validate(view);
    } catch (const base::Error& e) {
        base::fail(place, std::string("the view cannot be used: ") + e.what());
    }
    ViewTables out;
    out.plan = plan;
    out.geometry = std::make_shared<Geometry>(plan->methods.geometry(view, place), picture.width, picture.height);
    const Geometry& g = *out.geometry;
    if (plan->requirements & require::sources) out.find_sources = plan->methods.sources(g, plan->settings);
    if (plan->requirements & require::reach) out.find_by_other_reach = other_reaches(*plan, g);
    if (plan->requirements & require::rammg) out.pyramid = std::make_shared<Pyramid>(g, plan->settings.rammg_area);
    if (plan->requirements & require::medians) out.position_index.resize(g.omega.size());
    for (size_t i = 0; i < out.position_index.size(); ++i)
        if (g.valid(i)) out.position_index[i] = float(position_index(g, g.seen_direction(i), plan->settings.position));
    out.sets = pixel_sets(*plan, g);
    return out;
}

// The sun of a picture of ours stands anywhere in its pixel, which the moments say.  Without them it counts at the
// centre; L w sin(theta) times half a pixel is the most that its light at the eye changes.
void warn_of_lost_place(const std::string& place, Reading& r) {
    constexpr double least_share = .01;
    const Geometry& g = r.geometry();
    size_t brightest = 0;
    double lux = 0;
    for (size_t i = 0; i < g.omega.size(); ++i) {
        if (!g.valid(i)) continue;
        lux += r.lum.at(i) * g.omega_cos[i];
        if (!g.valid(brightest) || r.lum.at(i) > r.lum.at(brightest)) brightest = i;
    }
    const double omega = g.omega[brightest], cosine = std::min(1., g.omega_cos[brightest] / omega),
                 half_pixel = std::sqrt(omega) / 2,
                 off = r.lum.at(brightest) * omega * std::sqrt(1 - cosine * cosine) * half_pixel;
    if (!(off > least_share * lux) || std::exchange(r.told_place, true)) return;
    base::warn(
        place,
        fmt::format("its brightest pixel stands {:.0f} degrees off the line of sight, and where the light lies in "
                    "it went with the moments: Ev is up to {:.0f} % off (streams of ptrace and OpenEXR files "
                    "keep them)",
                    std::acos(cosine) * evalglare_deg, 100 * off / lux));
}

void warn_of(const image::Header& header, const std::string& place, Reading& r) {
    if (r.lum.not_finite)
        base::warn(place, "pixels that are not finite count as black (-metrics not_finite counts them)");
    if ((r.plan().requirements & require::filled) && !r.lum.moments && !std::exchange(r.told_no_moments, true))
        base::warn(
            place,
            "has no moments of its pixels (a stream of ptrace and its OpenEXR files have): DGPf and its like, and the "
            "effect of the pixels' size on DGP, are unknown");
    if ((r.plan().requirements & require::all_light) && !r.lum.moments && header.frames) warn_of_lost_place(place, r);
    if (is_of_irradiance(header) && !std::exchange(r.told_irradiance, true))
        base::warn(
            place,
            "shows irradiance (-i): numbers in cd/m2 are the surfaces' illuminance in lux, but openings show the "
            "sky's luminance, so that a mean over both has no meaning, nor have glare and Ev");
    if (r.lum.negative) base::warn(place, "pixels are negative (-metrics negative counts them)");
}

}  // namespace

SharedPlan make_plan(Plan plan) {
    const std::string& task = plan.settings.task_region;
    const std::vector<image::Mask> none, &regions = plan.regions ? plan.regions->masks : none;
    if (!task.empty() && std::none_of(regions.begin(), regions.end(), [&](auto& m) { return m.name == task; }))
        base::fail("-task", "there is no region \"" + task + "\"");
    return std::make_shared<const Plan>(std::move(plan));
}

Reading read(const SharedPlan& plan, image::Picture& picture, const std::string& place,
             const std::optional<view::View>& other_view, Reading out) {
    if (!other_view && !picture.header.view)
        base::fail(place, "the header has no view; give one with -vf file or with -vt, -vh and -vv");
    const view::View& view = other_view ? *other_view : *picture.header.view;
    const bool new_view = !out.tables || !out.geometry().fits(view, picture.width, picture.height);
    if (new_view) out.tables.reset(), out.placed_geometry.reset();  // frees their memory first
    if (new_view || out.tables->plan != plan) {
        ViewTables tables = new_view ? tables_of(plan, view, picture, place) : *out.tables;
        tables.plan = plan;
        tables.regions = lay_regions(*plan, *tables.geometry, place);
        out.tables = std::make_shared<const ViewTables>(std::move(tables));
    }
    const Geometry& g = out.geometry();
    if (g.valid_count == 0) base::fail(place, "no pixel of the picture lies in its view");
    const bool new_moments = new_view || out.lum.moments != picture.moments;
    out.lum = make_luminance(picture);
    if (new_moments) {
        out.drawn_pixels = g.drawn_pixels(out.lum.moments);
        out.placed_geometry =
            out.drawn_pixels.empty() ? nullptr : std::make_shared<const Geometry>(g.with(out.drawn_pixels));
    }
    warn_of(picture.header, place, out);
    out.black_corners.reset();
    const bool is_ours = picture.header.frame || picture.header.frames;  // and so its view is true
    if (view.type == 'v' && (other_view || !is_ours)) {
        out.black_corners = black_corner_percent(out.lum);
        if (*out.black_corners > 70 && !plan->settings.force) throw BlackCorners(place, *out.black_corners);
    }
    if (new_view && (plan->requirements & require::all_light) && g.share_of_light() < .9)
        base::warn(place, "Ev and DGP are of this narrow view; -vta -vh 180 -vv 180 has all that reaches the eye");
    return out;
}

}  // namespace glare
