// SPDX-License-Identifier: BSD-3-Clause
// What the programs and the disk report: pictures with the edit that they show, rows, messages, files, ends.
#include <algorithm>
#include <cstdio>

#include "base/split.h"
#include "live/steps.h"

namespace live {

namespace {

constexpr size_t most_edits = 1000, most_results = 100;
using Cause = Message::Cause;

template <class DO>
void for_each_model(State& s, DO&& work) {
    work(s.now);
    for (std::vector<Change>* all : {&s.undo, &s.redo})
        for (Change& c : *all) work(c.model);
}

// Options of a view as ptrace has understood them stand for those that it was asked for.
void settle_view(State& s, const std::string& asked, const std::string& is) {
    const auto settle = [&](std::string& view) {
        if (view == asked) view = is;
    };
    if (asked == is) return;
    for_each_model(s, [&](Model& m) {
        for (std::string& view : m.views) settle(view);
        for (Variant& v : m.variants) settle(v.look.view);
    });
    for (Pipe::Sent& e : s.pipe(Which::picture).sent) settle(e.look.view);
    for (Result& r : s.results) settle(r.look.view);
}

// The first view of all, which is known when its picture comes.
void begin_views(State& s, const std::string& first) {
    for_each_model(s, [&](Model& m) {
        if (m.views.empty() || m.views[0] != first) m.views.insert(m.views.begin(), first);
        for (Variant& v : m.variants)
            if (v.look.view.empty()) v.look.view = first;
    });
}

// "overlay blind.rad: 20 to 32 [17]": takes the number of the edit away; 0: it has none.
size_t take_number(std::string& words) {
    const size_t at = words.rfind(" [");
    if (at == words.npos || words.back() != ']') return 0;
    const size_t number = size_t(std::strtoul(words.c_str() + at + 2, nullptr, 10));
    if (number > 0) words.resize(at);
    return number;
}

// The number of the edit whose look these pictures have.
size_t number_of(Pipe& p, int64_t edit, std::string& words) {
    size_t number = take_number(words);
    for (const auto& [known, same] : p.same)
        if (known == edit) number = std::max(number, same);
    p.same.erase(p.same.begin(), p.same.upper_bound(edit));
    return number;
}

// This edit and those before it have arrived.
bool arrive(Pipe& p, size_t number) {
    const auto found = std::find_if(p.sent.begin(), p.sent.end(), [&](const auto& e) { return e.number == number; });
    if (found == p.sent.end()) return false;
    p.look = found->look;
    p.sent.erase(p.sent.begin(), found + 1);
    return true;
}

bool has_variant(const State& s, const Look& look) {
    return std::any_of(s.now.variants.begin(), s.now.variants.end(),
                       [&](const Variant& v) { return look_of(s, v.look.texts, v.look.view) == look; });
}

// The newest picture is one of its look: the better one where there are two edits.
void note_result(State& s) {
    const Pipe& p = s.pipe(Which::picture);
    const auto frames = [](const auto& picture) { return picture ? picture->header.frames.value_or(0) : -1; };
    auto r = std::find_if(s.results.begin(), s.results.end(), [&](const Result& one) { return one.look == p.look; });
    if (r == s.results.end() && !has_variant(s, p.look)) return;
    if (r == s.results.end()) r = s.results.insert(r, {p.look, -1, nullptr, {}});
    if (r->edit != p.edit && frames(s.newest) <= frames(r->picture)) return;
    if (r->edit != p.edit) r->numbers = s.numbers.first == p.edit ? s.numbers.second : std::vector<std::string>();
    r->edit = p.edit;
    r->picture = s.newest;
    if (s.results.size() > most_results) s.results.erase(s.results.begin());
}

// The first picture of an edit that programs have made of the model.
void begin_edit(State& s, const image::Header& h, int64_t edit) {
    Pipe& p = s.pipe(Which::picture);
    std::string words = h.edited;
    const size_t number = number_of(p, edit, words);
    const std::string view = h.view ? view::to_options(*h.view) : "", why = words.substr(0, words.find(' '));
    const bool follows = edit == p.edit + 1;
    p.edit = edit;
    s.edits.emplace_back(edit, words);
    if (s.edits.size() > most_edits) s.edits.erase(s.edits.begin());
    if (s.newest && s.newest->header.edit.value_or(0) != edit) s.before = s.newest;
    s.questions.clear();
    be_gone(s, Cause::programs);
    if (why == "start" || why == "scene" || why == "overlay") be_gone(s, Cause::scene);
    if (arrive(p, number)) settle_view(s, p.look.view, view);
    else if (!follows || why == "scene" || why == "overlay") p.look.texts.assign(s.files.size(), Text());  // not known
    p.look.view = view;
    if (view.empty()) return;
    if (s.now.views.empty()) return begin_views(s, view);
    if (p.sent.empty() && number == 0 && why != "start" && view != s.now.view())  // others have asked for it
        change(s, "view", [&](Model& m) { m.views.push_back(view); });
}

// NAME value (low to high) of each column that has an interval.
std::vector<std::string> numbers_of(const Row& row) {
    std::vector<std::string> all;
    for (const auto& [name, value] : row.cells) {
        char text[200];
        if (std::isnan(row.of(name + ".lo")) || std::isnan(value)) continue;
        std::snprintf(text, sizeof text, " %.4g (%.4g to %.4g)", value, row.of(name + ".lo"), row.of(name + ".hi"));
        all.push_back(name + text);
    }
    return all;
}

// "ptrace: what x y", a tab, the edit, a tab, and what is there.
void take_answer(State& s, const std::string& line) {
    const size_t words = line.find("what ") + 5, end = std::min(line.find('\t'), line.size() - 1);
    const int64_t edit = std::atoll(line.c_str() + end + 1) + s.pipe(Which::picture).first_edit;
    const size_t tab = std::min(line.find('\t', end + 1), line.size());
    s.questions[line.substr(words, end - words)].answer = std::to_string(edit) + line.substr(tab);
}

// "ptrace: same EDIT words [17]": what was sent changes nothing in what that edit shows.
void take_same(State& s, const Said& said) {
    std::string words = said.line;
    Pipe& p = s.pipe(said.which);
    const size_t number = take_number(words);
    const int64_t edit = p.first_edit + std::atoll(words.c_str() + sizeof "ptrace: same");
    const std::string view = p.look.view;
    if (edit > p.edit) p.same[edit] = number;
    else if (arrive(p, number) && said.which == Which::picture) {
        settle_view(s, p.look.view, view);
        p.look.view = view;
        if (s.newest) note_result(s);
    }
    be_gone(s, said.which == Which::plan ? Cause::points : Cause::scene);
}

Cause cause_of(const State& s, const Said& said) {
    if (said.which == Which::plan) return Cause::points;
    const auto regions = regions_file(s);
    if (regions && said.line.find(s.files[*regions].path + ":") != std::string::npos) return Cause::regions;
    const bool fails = base::begins_with(said.line, "ptrace: ") && said.line.find(": warning: ") == std::string::npos;
    if (!fails) return Cause::other;
    return !s.control.empty() && base::begins_with(said.line, "ptrace: " + s.control + ":") ? Cause::command
                                                                                            : Cause::scene;
}

// Texts that followed a file on the disk stand for themselves where the file is another one now.
void keep_text(State& s, size_t n, const Text& old) {
    bool typed = false;
    for_each_model(s, [&](const Model& m) { typed = typed || m.texts[n]; });
    for_each_model(s, [&](Model& m) {
        if (typed && &m != &s.now && !m.texts[n]) m.texts[n] = old;
        for (Variant& v : m.variants)
            if (!v.look.texts[n]) v.look.texts[n] = old;
    });
}

}  // namespace

void take(State& s, Effects&, const Came& came) {
    const image::Header& h = came.picture->header;
    Pipe& p = s.pipe(came.which);
    const int64_t edit = h.edit.value_or(0);
    if (came.which == Which::plan) s.plan.number++;
    if (h.edited == "preview") {
        if (came.which == Which::picture) s.picture = came.picture;
        return;
    }
    if (edit < p.edit) return;  // late: another one stands there
    if (came.which != Which::picture) {
        std::string words = h.edited;
        if (edit > p.edit && !arrive(p, number_of(p, edit, words)) && edit > p.first_edit)
            p.look.texts.assign(s.files.size(), Text());
        p.edit = edit;
        return;
    }
    if (edit > p.edit) begin_edit(s, h, edit);
    s.picture = s.newest = came.picture;
    note_result(s);
}

void take(State& s, Effects&, const Measured& m) {
    if (m.which == Which::day) return take_of_day(s, m);
    s.numbers = {m.row.edit(), numbers_of(m.row)};
    if (m.row.of("settled") > 0 && std::pair(m.row.edit(), m.row.frame()) > s.rest.measured)
        s.rest.settled = m.row.edit();
    for (Result& r : s.results)
        if (r.edit == s.numbers.first) r.numbers = s.numbers.second;
}

void take(State& s, Effects&, const Said& said) {
    const std::string& line = said.line;
    if (base::begins_with(line, "ptrace: same ")) return take_same(s, said);
    if (base::begins_with(line, "ptrace: what ")) return take_answer(s, line);
    const bool fails = base::begins_with(line, "ptrace: ") && line.find(": warning: ") == line.npos;
    if (line.find(": settled after ") != line.npos) return;                                     // a column says so
    if (said.which != Which::picture && line.find(": reading the model") != line.npos) return;  // it takes long
    if (said.which == Which::day) return fails ? fail_hour(s) : void();
    const auto known = [&](const Message& m) { return m.stands && m.text == line; };
    if (line.empty() || std::any_of(s.messages.begin(), s.messages.end(), known)) return;
    say(s, cause_of(s, said), line);
    const auto regions = regions_file(s);  // that nothing is drawn yet is no news
    if (s.messages.back().cause == Cause::regions && (*text_of(s, s.now.texts, *regions)).empty())
        s.messages.back().stands = false;
}

void take(State& s, Effects& out, const FileIs& is) {
    File& file = s.files[is.n];
    const bool first = file.tag.empty();
    if (file.tag == is.now.tag && file.trouble == is.now.trouble) return;
    const Text old = text_of(s, {}, is.n), text(is.now.text);
    file.text = text, file.tag = is.now.tag, file.trouble = is.now.trouble;
    const std::string words = file.path + ": changed by another program";
    if (file.kind == TextFile::Kind::regions) {
        be_gone(s, Cause::regions);
        measure_again(s);
        if (first) s.now.texts[is.n] = text;
        else if (s.now.texts[is.n] != text) change(s, words, [&](Model& m) { m.texts[is.n] = text; });
        return;
    }
    if (first) return;
    keep_text(s, is.n, old);
    const Text typed = s.now.texts[is.n];
    if (typed && typed != text) change(s, words, [&](Model& m) { m.texts[is.n] = Text(); });
    else ++file.version, s.now.texts[is.n] = Text();
    for (Pipe& p : s.pipes) {  // when have they read it?
        for (Pipe::Sent& e : p.sent) e.look.texts[is.n] = Text();
        if (p.edit < p.first_edit && is.n < p.look.texts.size()) p.look.texts[is.n] = Text();
    }
    tell(s, out, "file saved");
}

// Programs that break off are started again once by themselves, then where the page asks for it.
void take(State& s, Effects& out, const Ended& e) {
    Pipe& p = s.pipe(e.which);
    p.stage = Pipe::Stage::ended;
    if (e.which == Which::day) s.day.asked.reset(), s.first.asked = false;  // it will not come
    const bool again = p.own && p.starts == 1 && p.edit >= 0 && !e.what.empty();
    if (!e.what.empty()) say(s, Cause::programs, "vcview: " + e.what + (again ? ": it is started again" : ""));
    if (again) start(s, out, e.which);
    else if (e.which == Which::picture) s.ended = e.status;
}

}  // namespace live
