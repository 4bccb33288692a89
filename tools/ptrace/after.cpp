// SPDX-License-Identifier: BSD-3-Clause
// See after.h.
#include "after.h"

#include <fmt/core.h>

#include <algorithm>

#include "base/error.h"
#include "base/run.h"
#include "image/stream.h"

namespace {

void go_on_after_sum(const std::string& path, bool seed_given, Options& opt) {
    if (opt.views.size() > 1 || !opt.skies.empty() || opt.states.size() > 1 || opt.after.size() > 1 ||
        opt.one_picture || is_live(opt))
        base::fail("-after", "a sum is of one stream, and goes on with one");
    const image::Picture sum = image::read_file(path);
    const image::Header& h = sum.header;
    if (h.ranges.empty() || sum.sum.empty()) base::fail(path, "is no sum of frames (ptaccum -o)");
    if (!h.other_seeds.empty()) base::fail(path, "has frames of several seeds, of which none goes on by itself");
    if (seed_given && h.seed != opt.render.seed)
        base::fail(path, fmt::format("has the seed {}, not that of -seed", h.seed.value_or(0)));
    opt.render.seed = h.seed.value_or(opt.render.seed);
    const int64_t last = h.ranges.back().second;
    if (opt.last <= last)
        base::fail("-frames", fmt::format("{} has frames up to {} already, and no more are asked for", path, last));
    opt.first = std::max(opt.first, last + 1);
}

bool is_rendered_in(const Options& opt, const std::string& state, size_t i, const Sky& sky) {
    const auto hours = opt.rendered.find({opt.views[i].name, state});
    return hours != opt.rendered.end() && hours->second.count(sky.name) > 0;
}

}  // namespace

bool is_rendered(const Options& opt, size_t i, const Sky& sky) { return is_rendered_in(opt, opt.state, i, sky); }

void go_on_after(Options& opt, bool seed_given) {
    for (const std::string& path : opt.after) {
        base::note_file_read(*opt.files.read, path);
        if (image::ending_of(path) == ".exr") return go_on_after_sum(path, seed_given, opt);
        if (opt.weather.empty()) base::fail("-after", path + " is a table of hours: -wea; sums are .exr files");
        weather::read_rendered(path, opt.rendered);
    }
    if (opt.after.empty()) return;
    size_t there = 0;
    for (const scene::State& state : opt.states)
        for (size_t i = 0; i < opt.views.size(); ++i)
            for (const Sky& sky : opt.skies) there += is_rendered_in(opt, state.name, i, sky);
    const size_t all = opt.states.size() * opt.views.size() * opt.skies.size();
    if (there == all) base::fail("-after", fmt::format("all {} hours are there", all));
    base::say(fmt::format("ptrace: {} of {} hours are there", there, all));
}
