// SPDX-License-Identifier: BSD-3-Clause
// See actions.h.
#include "actions.h"

#include <fmt/core.h>

#include <algorithm>

#include "base/error.h"
#include "base/printable.h"
#include "base/shutdown.h"
#include "frames.h"
#include "image/header.h"

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

}  // namespace

void warn_of_guesses(const Session& s) {
    const Options& opt = s.run.opt;
    if (opt.actions.empty() || opt.state != opt.states.front().name) return;
    const flatten::Guessed guessed = flatten::guessed_spectra(s.text.scene, opt.lights);
    for (const std::string& lamp : guessed.lamps)
        base::warn("-lamp", "\"" + base::excerpt(lamp) + "\" is no light of the scene, or has a spectrum");
    if (!guessed.lights.empty())
        base::warn("-action", "no spectrum, so daylight " + opt.daylight + ": " + list(guessed.lights));
    if (!guessed.surfaces.empty())
        base::warn("-action", "no spectrum, so a smooth one of the RGB: " + list(guessed.surfaces));
}

std::vector<render::ActionHours> plan_action_hours(Session& s, size_t i) {
    std::vector<render::ActionHours> all;
    for (const ActionRun& action : s.run.opt.actions) {
        render::ActionHours hours{action.label, render::parts_by_daylight(action.parts), {}};
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

void render_actions(Session& s, const Sky& sky, size_t i) {
    const Options& opt = s.run.opt;
    s.action_plans.resize(opt.actions.size());
    for (size_t a = 0; a < opt.actions.size() && !base::shutdown_requested(); a++) {
        const ActionRun& action = opt.actions[a];
        std::vector<render::ViewPlan>& plans = s.action_plans[a];
        plan_parts(s, action.parts, i, plans);
        image::Picture picture = start_picture(opt, sky, i, &plans[0]);
        picture.header.action = action.label;
        picture.header.fingerprint = render::action_fingerprint(plans);
        if (opt.output.empty()) picture.header.last_frame = opt.last;
        const std::string label = image::label(picture.header);
        s.report.begin(label, s.device->name(), opt.first, opt.last);
        film::Accumulator sum;
        const auto give = [&](int64_t k, const std::vector<float>& rgb) {
            picture.rgb = rgb;
            picture.header.frame = k;
            write_frame(opt, picture, sum);
            s.report.frame(k);
            return !base::shutdown_requested();
        };
        try {
            render::render_action(*s.device, action.parts, plans, opt.first, opt.last - opt.first + 1, give);
        } catch (const device::Cancelled&) {}
        if (opt.one_picture) write_sum(opt, sum);
        s.report.end();
    }
}
