// SPDX-License-Identifier: BSD-3-Clause
// What the page asks for: each question changes the model, or says why not, and what differs goes to the programs.
#include <algorithm>
#include <map>
#include <sstream>

#include "base/hash.h"
#include "base/number.h"
#include "base/split.h"
#include "live/steps.h"

namespace live {

namespace {

constexpr size_t longest_command = 64 * 1024, most_places = 100, most_variants = 26, most_questions = 1000;
constexpr double greatest_limit_lx = 1e6;
const Answer done{204, "", "", ""};

std::optional<size_t> file_of(const State& s, const Request& r) {
    const std::string n = r.arguments("n");
    if (n.empty() || n.size() > 9 || n.find_first_not_of("0123456789") != n.npos) return {};
    return std::stoul(n) < s.files.size() ? std::optional<size_t>(std::stoul(n)) : std::nullopt;
}

// Whoever changes the model ends a pause.
Answer changed(State& s, Effects& out, const std::string& words) {
    s.paused = false;
    tell(s, out, words);
    return done;
}

// A line "view ..." of the page, which says what changes in the view before it, or all of it.
void change_view(State& s, Effects& out, const std::string& line) {
    const size_t from = line.find_first_not_of(" \t", line.find("view") + 4);
    const std::string options = from == line.npos ? "" : " " + line.substr(from);
    const std::string view = base::begins_with(options, " -vt") ? options : s.now.view() + options;
    if (view != s.now.view()) change(s, "view", [&](Model& m) { m.views.push_back(view); });
    tell(s, out, Which::picture, look_now(s), "", "", line + "\n");
}

// Lines for ptrace.
Answer control(State& s, Effects& out, const Request& r) {
    if (r.body.size() > longest_command) return plain(413, "too long");
    for (const char c : r.body)
        if ((unsigned char)c < ' ' && c != '\n' && c != '\t') return plain(400, "control characters in a command");
    if (r.deaf) return *r.deaf;
    std::istringstream lines(r.body);
    for (std::string line, word; std::getline(lines, line);) {
        word.clear();
        std::istringstream(line) >> word;
        be_gone(s, Message::Cause::command);
        if (word != "what" && word != "next") s.paused = word == "pause";
        if (word == "preview") s.preview = s.at;
        else if (word != "what" && word != "next" && word != "pause") s.preview.reset();
        if (word == "go") s.going = -1, s.rest.goes_on = s.pipe(Which::picture).edit;
        if (word == "view") change_view(s, out, line);
        else out.push_back(ToPipe{Which::picture, line + "\n"});
    }
    return done;
}

// A text that stands for a file of -edit until the file changes on the disk.
Answer overlay(State& s, Effects& out, const Request& r) {
    const auto n = file_of(s, r);
    if (!n || s.files[*n].kind != TextFile::Kind::scene) return plain(404, "no such file");
    const File& file = s.files[*n];
    if (r.arguments("version") != std::to_string(file.version))
        return plain(412, file.path + " has been changed in another window");
    if (r.deaf) return *r.deaf;
    const std::string said = one_line(r.arguments("said")), words = said.empty() ? file.path + " changed" : said;
    const bool joins = s.going == int(*n);
    const size_t version = file.version + 1;
    change(
        s, words, [&](Model& m) { m.texts[*n] = Text(r.body); }, joins);
    s.files[*n].version = version;
    if (!r.arguments("going").empty()) s.going = int(*n);
    if (s.preview) s.preview = s.at;
    changed(s, out, said);
    return {200, "text/plain; charset=utf-8", "", std::to_string(version)};
}

Answer back(State& s, Effects& out, const Request& r) {
    if (s.now.views.size() < 2) return plain(409, "there is no earlier view");
    if (r.deaf) return *r.deaf;
    change(s, "view", [](Model& m) { m.views.pop_back(); });
    return changed(s, out, "");
}

// The text of the region file goes to the disk at once.
void write_regions(State& s, Effects& out, size_t n) {
    File& file = s.files[n];
    if (!s.now.texts[n] || s.now.texts[n] == text_of(s, {}, n)) return;
    out.push_back(Write{Write::To::file, n, *s.now.texts[n], file.tag});
    file.text = s.now.texts[n];
    file.tag = base::hash_of(*file.text);
    be_gone(s, Message::Cause::regions);
    measure_again(s);
}

Answer undo_or_redo(State& s, Effects& out, const Request& r, bool again) {
    if (r.arguments("state") != std::to_string(s.changes)) return plain(412, "the design has been changed meanwhile");
    const std::vector<Change>& all = again ? s.redo : s.undo;
    if (all.empty()) return plain(409, again ? "there is nothing to redo" : "there is nothing to undo");
    const std::string words = (again ? "" : "undone: ") + all.back().words;
    const Look before = look_now(s);
    if (r.deaf && look_of(s, all.back().model.texts, all.back().model.view()) != before) return *r.deaf;
    undo(s, again);
    for (size_t n = 0; n < s.files.size(); ++n)
        if (s.files[n].kind == TextFile::Kind::regions) write_regions(s, out, n);
    if (look_now(s) != before) changed(s, out, words);
    return {204, "", "", std::to_string(s.changes)};
}

// The first letter, or number behind a word, that no item of a list has as its name.
template <class TAKEN>
std::string free_name(const std::string& word, TAKEN&& taken) {
    for (int k = 0;; ++k) {
        std::string name = word.empty() && k < 26 ? std::string(1, char('A' + k)) : word + " " + std::to_string(k + 1);
        if (!taken(name)) return name;
    }
}

void keep(State& s, std::string name) {
    if (name.empty()) name = free_name("", [&](const std::string& n) { return find_variant(s.now, n); });
    const Look look = look_now(s);
    if (!find_variant(s.now, name) && s.now.variants.size() >= most_variants) return;
    Variant v{name, {s.now.texts, look.view}};
    if (const auto n = regions_file(s)) v.look.texts[*n] = Text();
    change(s, "variant " + name + " kept", [&](Model& m) {
        const auto same = [&](const Variant& o) { return o.name == name; };
        const auto at = std::find_if(m.variants.begin(), m.variants.end(), same);
        if (at != m.variants.end()) *at = v;
        else m.variants.push_back(v);
        if (m.base.empty()) m.base = name;
    });
    const Pipe& p = s.pipe(Which::picture);
    if (p.look == look && !result_of(s, look))
        s.results.push_back(
            {look, p.edit, s.newest, s.numbers.first == p.edit ? s.numbers.second : std::vector<std::string>()});
}

Answer show(State& s, Effects& out, const Request& r, const Variant& v) {
    if (r.deaf) return *r.deaf;
    if (look_of(s, v.look.texts, v.look.view) == look_now(s)) return done;
    change(s, "variant " + v.name + " shown", [&](Model& m) {
        for (size_t n = 0; n < s.files.size(); ++n)
            if (s.files[n].kind == TextFile::Kind::scene) m.texts[n] = v.look.texts[n];
        if (!v.look.view.empty() && v.look.view != m.view()) m.views.push_back(v.look.view);
    });
    return changed(s, out, v.name);
}

Answer change_variant(State& s, Effects& out, const Request& r) {
    const std::string name = one_line(r.arguments("name")), what = r.arguments("do"), to = one_line(r.arguments("to"));
    const Variant* known = find_variant(s.now, name);
    if (what != "keep" && !known && !(what == "base" && name.empty()))
        return plain(404, "there is no variant \"" + name + "\"");
    if (what == "show") return show(s, out, r, Variant(*known));
    if (what == "keep") keep(s, name);
    if (what == "base" && name != s.now.base)
        change(s, name.empty() ? "compare with the edit before" : "compare with " + name,
               [&](Model& m) { m.base = name; });
    const bool drops = what == "drop", calls = what == "call" && to != name;
    if (calls && (to.empty() || find_variant(s.now, to))) return plain(409, "each variant has a name of its own");
    if (drops || calls)
        change(s, "variant " + name + (drops ? " deleted" : " called " + to), [&](Model& m) {
            if (m.base == name) m.base = drops ? "" : to;
            for (Variant& v : m.variants)
                if (v.name == name) v.name = drops ? "" : to;
            m.variants.erase(
                std::remove_if(m.variants.begin(), m.variants.end(), [](auto& v) { return v.name.empty(); }),
                m.variants.end());
        });
    return done;
}

Answer place(State& s, const Request& r) {
    std::string name = one_line(r.arguments("name"));
    const auto taken = [&](const std::string& n) {
        return std::any_of(s.now.places.begin(), s.now.places.end(), [&](const auto& p) { return p.first == n; });
    };
    const bool keeps = r.arguments("do") == "keep";
    if (keeps && (s.now.views.empty() || s.now.places.size() >= most_places)) return done;
    if (!keeps && !taken(name)) return done;
    if (keeps && name.empty()) name = free_name("view", taken);
    change(s, "view " + name + (keeps ? " kept" : " deleted"), [&](Model& m) {
        m.places.erase(std::remove_if(m.places.begin(), m.places.end(), [&](auto& p) { return p.first == name; }),
                       m.places.end());
        if (keeps) m.places.emplace_back(name, m.view());
    });
    return done;
}

// "desk deleted": regions by name whose lines differ.
std::string words_of_regions(const std::string& before, const std::string& after) {
    const auto regions = [](const std::string& text) {
        std::map<std::string, std::string> all;
        std::istringstream lines(text);
        for (std::string line, name; std::getline(lines, line);) {
            if (!line.empty() && line[0] != ' ' && line[0] != '\t' && line[0] != '#') std::istringstream(line) >> name;
            all[name] += line + "\n";
        }
        return all;
    };
    const auto was = regions(before), is = regions(after);
    for (const auto& [name, lines] : was)
        if (!name.empty() && !is.count(name)) return "region " + name + " deleted";
    for (const auto& [name, lines] : is)
        if (!name.empty() && (!was.count(name) || was.at(name) != lines))
            return "region " + name + (was.count(name) ? " changed" : " added");
    return "regions changed";
}

// A file is written: regions, a change of the model; a file of the scene, its text as it is shown.
Answer put(State& s, Effects& out, const Request& r) {
    const auto n = file_of(s, r);
    if (!n) return plain(404, "no such file");
    const File& file = s.files[*n];
    if (!file.writable) return plain(403, file.path + " was not named to be written");
    if (!file.trouble.empty()) return plain(409, file.trouble);
    if (r.tag != file.tag) return plain(412, file.path + " has been changed by another program");
    if (file.kind == TextFile::Kind::regions) {
        change(s, words_of_regions(*text_of(s, s.now.texts, *n), r.body),
               [&](Model& m) { m.texts[*n] = Text(r.body); });
        write_regions(s, out, *n);
    } else {
        out.push_back(Write{Write::To::file, *n, r.body, file.tag});
        take(s, out, FileIs{*n, {base::hash_of(r.body), r.body, ""}});
    }
    return {200, "text/plain; charset=utf-8", "", base::hash_of(r.body)};
}

Answer limit(State& s, const Request& r) {
    double lx;
    if (s.pipe(Which::plan).stage == Pipe::Stage::none) return plain(404, "there is no plan");
    if (!base::parse_real(r.arguments("limit"), lx) || !(lx > 0 && lx <= greatest_limit_lx))
        return plain(400, "no such limit");
    s.plan.limit_lx = lx;
    s.plan.number += s.plan.number > 0;
    return done;
}

Answer start_again(State& s, Effects& out) {
    if (!has_ended(s)) return plain(409, "nothing has ended that can be started again");
    be_gone(s, Message::Cause::programs);
    for (Pipe& p : s.pipes)
        if (p.own && p.stage == Pipe::Stage::ended) p.stage = Pipe::Stage::asleep;
    if (s.pipe(Which::picture).stage == Pipe::Stage::running) return done;
    s.ended.reset();
    start(s, out, Which::picture);
    return done;
}

// A place of the picture: a question to ptrace, again where no answer has come.
Answer ask_what(State& s, Effects& out, const Request& r) {
    if (r.deaf) return *r.deaf;
    const std::string words = place_of(r.arguments);
    if (words.empty()) return plain(400, "no place in the picture");
    if (s.questions.size() > most_questions) s.questions.clear();
    s.questions[words].at = s.at;
    out.push_back(ToPipe{Which::picture, "what " + words + "\n"});
    return done;
}

// One message or, without a number, all.
Answer dismiss(State& s, const Request& r) {
    for (Message& m : s.messages)
        if (r.arguments("number").empty() || r.arguments("number") == std::to_string(m.number)) m.stands = false;
    return done;
}

Answer answer_to(State& s, Effects& out, const Request& r) {
    if (r.put) return r.path == "/file" ? put(s, out, r) : plain(405, "GET only");
    if (r.path == "/plan") return limit(s, r);
    if (r.path == "/start") return start_again(s, out);
    if (r.path == "/dismiss") return dismiss(s, r);
    if (r.path == "/what") return ask_what(s, out, r);
    s.asked_at = s.at;
    if (r.path == "/control") return control(s, out, r);
    if (r.path == "/overlay") return overlay(s, out, r);
    if (r.path == "/undo" || r.path == "/redo") return undo_or_redo(s, out, r, r.path == "/redo");
    if (r.path == "/back") return back(s, out, r);
    if (r.path == "/variant") return change_variant(s, out, r);
    if (r.path == "/place") return place(s, r);
    return plain(404, "nothing here");
}

}  // namespace

Answer plain(unsigned status, const std::string& text) {
    return {status, "text/plain; charset=utf-8", text + "\n", ""};
}

void take(State& s, Effects& out, const Request& r) {
    const Answer a = answer_to(s, out, r);
    out.push_back(a);
}

}  // namespace live
