// SPDX-License-Identifier: BSD-3-Clause
// See step.h.
#include "live/step.h"

#include <algorithm>

#include "base/number.h"
#include "live/json.h"
#include "live/steps.h"

namespace live {

namespace {

constexpr size_t most_undone = 50, most_sent = 100, most_messages = 100, most_words = 200;
const char* const size_of_hours = "size 64 64\n";
constexpr double longest_preview = 3;  // seconds without a word of its window

// The line that lets a text stand for a file.
std::string overlaying(const File& f, const Text& text) {
    if (!text || text == f.text) return "overlay " + f.path + " -\n";
    return "overlay " + f.path + " " + std::to_string((*text).size()) + "\n" + *text;
}

void count_versions(State& s, const Texts& before) {
    for (size_t n = 0; n < s.files.size(); ++n) s.files[n].version += s.now.texts[n] != before[n];
}

// A window that has asked for small pictures and says no more may be gone: the full one is asked for.
void end_preview(State& s, Effects& out) {
    if (!s.preview || s.at - *s.preview <= longest_preview) return;
    s.preview.reset();
    s.going = -1;
    out.push_back(ToPipe{Which::picture, "go\n"});
}

void take(State& s, Effects& out, const Tick& e) {
    end_preview(s, out);
    look_at_rest(s, out, e.watched);
}

void take(State& s, Effects&, const PointsChanged&) { ++s.plan.points, s.plan.number += s.plan.number > 0; }

void take(State& s, Effects&, const Drawn& e) {
    s.plan.drawn = e.points;
    if (e.points == s.plan.points) be_gone(s, Message::Cause::points);
}

void take(State& s, Effects&, const Saved& e) {
    be_gone(s, Message::Cause::design);
    if (!e.trouble.empty()) say(s, Message::Cause::design, e.trouble);
}

// Programs that never say what has arrived: where it may differ it is not known.
void forget_first(Pipe& p) {
    const Look& first = p.sent.front().look;
    for (size_t n = 0; n < p.look.texts.size(); ++n)
        if (p.look.texts[n] != first.texts[n]) p.look.texts[n] = Text();
    if (p.look.view != first.view) p.look.view.clear();
    p.sent.erase(p.sent.begin());
}

void take(State& s, Effects& out, const Listens& l) {
    Pipe& p = s.pipe(l.which);
    const bool does = p.stage == Pipe::Stage::running;
    if (does == l.yes) return;
    p.stage = l.yes ? Pipe::Stage::running : Pipe::Stage::asleep;
    if (p.look.texts.empty()) p.look.texts = look_of(s, {}, "").texts;
    if (l.yes) tell(s, out, words_of_opening);
}

}  // namespace

std::string one_line(std::string words) {
    for (char& c : words)
        if ((unsigned char)c < ' ') c = ' ';
    return words.substr(0, most_words);
}

std::string place_of(const Arguments& arguments) {
    std::vector<std::string> place;
    for (const char* name : {"x", "y"})
        if (double v; base::parse_real(arguments(name), v) && v >= 0 && v <= 1) place.push_back(json::number(v));
    return place.size() == 2 ? place[0] + " " + place[1] : "";
}

void change(State& s, const std::string& words, const std::function<void(Model&)>& how, bool joins) {
    const Model before = s.now;
    how(s.now);
    if (joins && !s.undo.empty()) s.undo.back().words = words;
    else s.undo.push_back({words, before});
    if (s.undo.size() > most_undone) s.undo.erase(s.undo.begin());
    s.redo.clear();
    count_versions(s, before.texts);
    ++s.changes;
    s.going = -1;
}

bool undo(State& s, bool again) {
    std::vector<Change>&from = again ? s.redo : s.undo, &to = again ? s.undo : s.redo;
    if (from.empty()) return false;
    const Change c = std::move(from.back());
    from.pop_back();
    to.push_back({c.words, s.now});
    s.now = c.model;
    count_versions(s, to.back().model.texts);
    ++s.changes;
    s.going = -1;
    return true;
}

void tell(State& s, Effects& out, Which which, const Look& look, const std::string& words, const std::string& ahead,
          const std::string& view_line) {
    Pipe& p = s.pipe(which);
    if (p.stage != Pipe::Stage::running) return;
    const auto may_differ = [&](const auto& same) {
        return !same(p.look) || !std::all_of(p.sent.begin(), p.sent.end(), [&](const auto& e) { return same(e.look); });
    };
    const Look& last = p.sent.empty() ? p.look : p.sent.back().look;
    std::string bytes = view_line;
    if (bytes.empty() && last == look) {
        if (!ahead.empty()) out.push_back(ToPipe{which, ahead});
        return;
    }
    if (bytes.empty() && !look.view.empty() && may_differ([&](const Look& l) { return l.view == look.view; }))
        bytes = "view" + look.view + "\n";
    for (size_t n = 0; n < s.files.size(); ++n)
        if (s.files[n].kind == TextFile::Kind::scene &&
            may_differ([&](const Look& l) { return n < l.texts.size() && l.texts[n] == look.texts[n]; }))
            bytes += overlaying(s.files[n], look.texts[n]);
    if (!bytes.empty()) {
        p.sent.push_back({++s.sent, look});
        bytes = "note " + one_line(words) + " [" + std::to_string(s.sent) + "]\n" + bytes;
    }
    if (which == Which::picture && !bytes.empty()) s.rest.now = false;  // an edit ends it
    if (p.sent.size() > most_sent) forget_first(p);
    if (!(ahead + bytes).empty()) out.push_back(ToPipe{which, ahead + bytes});
}

void start(State& s, Effects& out, Which which) {
    Pipe& p = s.pipe(which);
    p.stage = Pipe::Stage::running;
    p.first_edit = p.edit + 1;
    p.look = look_of(s, {}, "");
    p.sent.clear(), p.same.clear();
    p.rests = true;
    ++p.starts;
    out.push_back(Start{which});
    if (which == Which::picture) s.paused = false, s.preview.reset(), tell(s, out, words_of_opening);
    if (which == Which::day) out.push_back(ToPipe{which, size_of_hours});
}

void say(State& s, Message::Cause cause, const std::string& text) {
    for (Message& m : s.messages)
        if (m.stands && m.cause == cause && cause == Message::Cause::scene && m.sent < s.sent) m.stands = false;
    s.messages.push_back({cause, text, ++s.told, s.sent});
    if (s.messages.size() > most_messages) s.messages.pop_front();
}

void be_gone(State& s, Message::Cause cause) {
    for (Message& m : s.messages) m.stands = m.stands && m.cause != cause;
}

std::pair<State, Effects> step(State s, const Event& event) {
    Effects out;
    s.at = event.at;
    std::visit([&](const auto& e) { take(s, out, e); }, event.what);
    look_at_day(s, out);
    look_at_plan(s, out);
    if (const std::string against = against_of(s); against != s.said_against) {
        s.said_against = against;
        out.push_back(Write{Write::To::against, 0, against, ""});
    }
    return {std::move(s), std::move(out)};
}

}  // namespace live
