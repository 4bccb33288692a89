// SPDX-License-Identifier: BSD-3-Clause
// See actions.h.
#include "actions.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/angle.h"
#include "base/error.h"
#include "base/printable.h"
#include "base/run.h"
#include "base/shutdown.h"
#include "frames.h"
#include "image/header.h"
#include "render/sky_light.h"

namespace {

using Names = std::vector<std::string>;

// "a, b, c and 4 more"
std::string list(const Names& names) {
    constexpr size_t most = 6;
    std::string text;
    for (size_t i = 0; i < std::min(names.size(), most); i++) text += (i ? ", " : "") + base::excerpt(names[i]);
    return names.size() > most ? text + fmt::format(" and {} more", names.size() - most) : text;
}

// The plans of all parts of an action, which take over what is the same in those before.
void plan_parts(Session& s, const std::vector<render::ActionPart>& parts, size_t i,
                std::vector<render::ViewPlan>& plans) {
    base::Progress progress("ptrace");
    plans.resize(parts.size(), s.plan);
    for (size_t p = 0; p < parts.size(); p++)
        plans[p] =
            render::plan_picture(*s.device, s.text, in_bands(setup_of(s.run.opt, i, progress), parts[p]), plans[p]);
}

// Those of -daylight and -lamp, and of the sky as loaded.
flatten::LightSpectra lights_of(const Session& s) {
    const flatten::LightSpectra& lights = s.run.opt.lights;
    return lights.by_sky ? render::with_sky_spectra(lights, s.text.scene, *s.plan.scene.tables) : lights;
}

std::string said_of_hours(const std::vector<Sky>& skies) {
    double least = 1e9, most = 0;
    for (const Sky& sky : skies) {
        if (!sky.light) continue;
        const double kelvin = sky_kelvin(render::sky_light(*sky.light));
        least = std::min(least, kelvin), most = std::max(most, kelvin);
    }
    return fmt::format("skies of {:.0f} to {:.0f} K", least, most);
}

std::string said_of(const spectrum::SkyLight& light) {
    const double height = std::asin(light.sun_sine) / base::degree;
    const std::string sun = light.sun_lx > 0
                                ? fmt::format("clearness {:.1f}; a sun at {:.0f} degrees", clearness(light), height)
                                : "taken for overcast, as there is no sun";
    return fmt::format("a sky of {:.0f} K ({:.0f} lx, {})", sky_kelvin(light), light.sky_lx, sun);
}

}  // namespace

void tell_daylight(const Session& s, const Sky& sky, bool is_first) {
    const Options& opt = s.run.opt;
    if (!opt.lights.by_sky || (sky.light && !is_first) || opt.state != opt.states.front().name) return;
    const spectrum::SkyLight light = render::sky_light(*s.plan.scene.tables);
    if (light.sky_lx + light.sun_lx <= 0) base::warn("-daylight", "the scene has no sun and no sky");
    else base::say("ptrace: -daylight sky: " + (sky.light ? said_of_hours(opt.skies) : said_of(light)));
}

void warn_of_guesses(const Session& s) {
    const Options& opt = s.run.opt;
    if (opt.actions.empty() || opt.state != opt.states.front().name) return;
    const flatten::Guessed guessed = flatten::guessed_spectra(s.text.scene, lights_of(s));
    for (const std::string& lamp : guessed.lamps)
        if (opt.lights.lamps.count(lamp) > 0)
            base::warn("-lamp", "\"" + base::excerpt(lamp) + "\" is no light of the scene, or has a spectrum");
    if (!guessed.lights.empty())
        base::warn("-action", "no spectrum, so daylight " + (opt.lights.by_sky ? "D65" : opt.daylight) + ": " +
                                  list(guessed.lights));
    if (!guessed.surfaces.empty())
        base::warn("-action", "no spectrum, so a smooth one of the RGB: " + list(guessed.surfaces));
}

std::vector<render::ActionHours> plan_action_hours(Session& s, size_t i) {
    std::vector<render::ActionHours> all;
    for (const ActionRun& action : s.run.opt.actions) {
        const auto parts = render::parts_of(action.action, action.label.bands, s.run.opt.lights);
        render::ActionHours hours{action.label, render::parts_by_daylight(parts), {}};
        plan_parts(s, hours.parts, i, hours.plans);
        all.push_back(std::move(hours));
    }
    return all;
}

void write_dark_actions(const Options& opt, image::Picture& picture) {
    for (const ActionRun& action : opt.actions) {
        picture.header.action = action.label;
        write_dark(opt, picture);
    }
}

std::vector<render::ActionPart> plan_action(Session& s, size_t a, size_t i) {
    const ActionRun& action = s.run.opt.actions[a];
    s.action_plans.resize(s.run.opt.actions.size());
    std::vector<render::ActionPart> parts = render::parts_of(action.action, action.label.bands, lights_of(s));
    plan_parts(s, parts, i, s.action_plans[a]);
    return parts;
}

bool render_actions(Session& s, const Sky& sky, size_t i) {
    const Options& opt = s.run.opt;
    for (size_t a = 0; a < opt.actions.size() && !s.control.edited() && !base::shutdown_requested(); a++) {
        const std::vector<render::ActionPart> parts = plan_action(s, a, i);
        const std::vector<render::ViewPlan>& plans = s.action_plans[a];
        image::Picture picture = start_picture(opt, sky, i, &plans[0]);
        picture.header.action = opt.actions[a].label;
        picture.header.fingerprint = render::action_fingerprint(plans);
        if (is_live(opt)) picture.header.edit = s.run.edits, picture.header.edited = s.run.edited;
        const auto draw = [&](int64_t first, int64_t count, const render::GiveFrame& give) {
            render::render_action(*s.device, parts, plans, first, count,
                                  [&](int64_t k, const std::vector<float>& rgb) { return give(k, rgb, {}); });
        };
        render_frames(opt, ends_of(opt, s.control, image::label(picture.header)), opt.first, picture, draw,
                      render::samples_per_frame(plans[0]), s.control, s.report, s.device->name());
        if (!is_live(opt)) s.report.end();
    }
    return !s.control.edited();
}
