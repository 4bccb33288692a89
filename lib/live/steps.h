// SPDX-License-Identifier: BSD-3-Clause
// Parts of step(): each takes the state that is being made.
#pragma once
#include "live/step.h"

namespace live {

// A change of the model, which Undo takes back.  joins: it goes on with the change before it.
void change(State& s, const std::string& words, const std::function<void(Model&)>& how, bool joins = false);
bool undo(State& s, bool again);  // again: Redo.  False: there is nothing

// Tells a pipe all that makes this look of what it may have, if anything does; ahead: other lines for it.
void tell(State& s, Effects& out, Which which, const Look& look, const std::string& words,
          const std::string& ahead = "", const std::string& view_line = "");
inline void tell(State& s, Effects& out, const std::string& words) { tell(s, out, Which::picture, look_now(s), words); }
void start(State& s, Effects& out, Which which);

void say(State& s, Message::Cause cause, const std::string& text);
void be_gone(State& s, Message::Cause cause);

void take(State& s, Effects& out, const Request& request);
void take(State& s, Effects& out, const Came& came);
void take(State& s, Effects& out, const Measured& row);
void take(State& s, Effects& out, const Said& said);
void take(State& s, Effects& out, const FileIs& file);
void take(State& s, Effects& out, const Ended& ended);

// The other pipes, after whatever has happened.
void look_at_day(State& s, Effects& out);
void take_of_day(State& s, const Measured& row);
void fail_hour(State& s);
std::map<int, std::array<double, 4>> lit_hours(const Day& day);  // DGPf, its interval, lx
std::string json_of_day(const State& s);
std::string json_of_first(const State& s);
void look_at_plan(State& s, Effects& out);
std::string json_of_plan(const State& s);
void look_at_rest(State& s, Effects& out, bool watched);
void measure_again(State& s);  // there are other regions

std::string one_line(std::string words);

}  // namespace live
