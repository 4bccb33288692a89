// SPDX-License-Identifier: BSD-3-Clause
// Maps of points, such as the sensors of a desk, beside the picture.  A pipe renders the points of the model that the
// page has, and rests until the picture of a change has its first lines.
#include <algorithm>

#include "live/json.h"
#include "live/steps.h"

namespace live {

namespace {

constexpr int64_t first_frames = 4;   // of the page's picture
constexpr double longest_change = 3;  // seconds for a picture that is asked for; a scene may be broken

// While the picture of a change has no lines yet, moves, or is paused.
bool rests(const State& s) {
    if (!s.picture || s.picture->header.edited == "preview" || s.preview || s.paused) return true;
    const image::Header& h = s.picture->header;
    if (s.pipe(Which::picture).look != look_now(s) && s.at - s.asked_at <= longest_change) return true;
    return h.frames.value_or(0) < std::min(first_frames, h.last_frame.value_or(first_frames));
}

Look wanted(const State& s) { return look_of(s, s.now.texts, ""); }

}  // namespace

void look_at_plan(State& s, Effects& out) {
    Pipe& p = s.pipe(Which::plan);
    if (p.stage == Pipe::Stage::none || p.stage == Pipe::Stage::ended) return;
    const bool rest = rests(s), turns = rest != p.rests;
    if (p.stage == Pipe::Stage::asleep && rest) return;
    if (p.stage == Pipe::Stage::asleep) start(s, out, Which::plan);
    p.rests = rest;
    if (!rest) tell(s, out, Which::plan, wanted(s), "", turns ? "go\n" : "");
    else if (turns) out.push_back(ToPipe{Which::plan, "pause\n"});
}

bool plan_waits(const State& s) {
    const Pipe& p = s.pipe(Which::plan);
    const Look& known = p.look.texts.empty() ? look_of(s, {}, "") : p.look;
    return s.plan.points != s.plan.drawn || !p.sent.empty() || known.texts != wanted(s).texts;
}

std::string json_of_plan(const State& s) {
    const Pipe& p = s.pipe(Which::plan);
    if (p.stage == Pipe::Stage::none) return "null";
    return json::object({{"number", std::to_string(s.plan.number)},
                         {"limit", json::number(s.plan.limit_lx)},
                         {"edit", std::to_string(std::max<int64_t>(p.edit, 0))},
                         {"waits", json::truth(plan_waits(s))},
                         {"ended", json::truth(p.stage == Pipe::Stage::ended)}});
}

}  // namespace live
