// SPDX-License-Identifier: BSD-3-Clause
// The picture's programs rest when its numbers are settled and it has frames enough to be looked at, and when no window
// has looked for long.  An edit ends that by itself; other regions, which need another picture, a window that comes,
// and the page's "go" do, too.
#include "live/steps.h"

namespace live {

namespace {

constexpr int64_t enough = 256;   // frames
constexpr double long_ago = 300;  // seconds without a window

bool is_settled(const State& s) {
    const Pipe& p = s.pipe(Which::picture);
    return s.rest.settled == p.edit && s.rest.goes_on != p.edit && s.newest->header.frames.value_or(0) >= enough;
}

}  // namespace

void measure_again(State& s) {
    if (s.newest) s.rest.measured = {s.newest->header.edit.value_or(0), s.newest->header.frames.value_or(0)};
    s.rest.settled = -1;
}

void look_at_rest(State& s, Effects& out, bool watched) {
    const Pipe& p = s.pipe(Which::picture);
    if (watched) s.rest.seen = s.at;
    const bool alone = s.rest.seen >= 0 && s.at - s.rest.seen > long_ago;
    const bool can = p.own && p.stage == Pipe::Stage::running && p.sent.empty() && s.newest && !s.preview && !s.paused;
    const bool rests = can && (alone || is_settled(s));
    if (rests == s.rest.now) return;
    s.rest.now = rests;
    if (rests) out.push_back(ToPipe{Which::picture, "pause\n"});
    else if (can) out.push_back(ToPipe{Which::picture, "go\n"});
}

}  // namespace live
