// SPDX-License-Identifier: BSD-3-Clause
// See choose_actions.h.
#include "choose_actions.h"

#include <fmt/core.h>

#include "base/error.h"
#include "base/printable.h"
#include "image/header.h"
#include "spectrum/illuminants.h"

namespace {

base::Opener opener_of(const Options& opt) { return {"", nullptr, opt.files.read.get()}; }

void choose_lights(Options& opt) {
    opt.lights.by_sky = opt.daylight == "sky";
    opt.lights.daylight = spectrum::illuminant(opt.lights.by_sky ? "D65" : opt.daylight, "-daylight", opener_of(opt));
    for (const std::string& word : opt.lamp_words) {
        const size_t at = word.rfind('=');
        if (at == std::string::npos || at == 0 || at + 1 == word.size())
            base::fail("-lamp", "needs a light and an illuminant, as lamp=F11, not \"" + base::excerpt(word) + "\"");
        const std::string name = word.substr(0, at);
        const auto spectrum = spectrum::illuminant(word.substr(at + 1), "-lamp", opener_of(opt));
        if (!opt.lights.lamps.emplace(name, spectrum).second)
            base::fail("-lamp", "two illuminants for \"" + base::excerpt(name) + "\"");
    }
}

}  // namespace

void choose_actions(Options& opt) {
    if (opt.action_words.empty()) {
        if (!opt.lamp_words.empty()) base::fail("-lamp", "is for -action");
        return;
    }
    if (opt.bands % 3 != 0) base::fail("-bands", fmt::format("are rendered three by three, not {}", opt.bands));
    choose_lights(opt);
    for (const std::string& word : opt.action_words) {
        const spectrum::Action action = spectrum::action_of(word, opener_of(opt));
        image::plain_name(action.name, "-action");
        for (const ActionRun& other : opt.actions)
            if (other.label.name == action.name)
                base::fail("-action", "two actions are called \"" + action.name + "\"");
        const int bands = opt.bands > 0 ? opt.bands : action.default_bands;
        opt.actions.push_back({{action.name, bands, action.unit}, action});
    }
}
