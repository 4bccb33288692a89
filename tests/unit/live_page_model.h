// SPDX-License-Identifier: BSD-3-Clause
// The live page for tests of its step(): a page that takes events and keeps what is sent, and a model of ptrace.
#pragma once
#include <doctest/doctest.h>

#include <deque>
#include <map>
#include <set>

#include "base/hash.h"
#include "base/split.h"
#include "image_pictures.h"
#include "live/answers.h"
#include "live/design_file.h"
#include "live/step.h"

using live::Which;
using Pairs = std::vector<std::pair<std::string, std::string>>;

inline live::Arguments arguments(const Pairs& given) {
    return [given](const char* name) {
        for (const auto& [key, value] : given)
            if (key == name) return value;
        return std::string();
    };
}

// A model of ptrace: what it is told becomes edits, whose pictures say what they show.
struct Tracer {
    std::map<std::string, std::string> texts, disk;  // that stand for files; of the files
    std::string note;
    std::vector<double> eye{0, 0, 0};
    int64_t edit = 0;
    std::string words = "start";
    std::string of(const std::string& file) const {
        return texts.count(file) ? texts.at(file) : disk.count(file) ? disk.at(file) : "";
    }
    std::vector<std::string> said;
    // All that has come; the scene is broken where a text says so.
    void read(std::string bytes) {
        const Tracer before = *this;
        std::string last;
        while (!bytes.empty()) {
            const size_t end = bytes.find('\n');
            const std::string line = bytes.substr(0, end);
            bytes.erase(0, end + 1);
            const std::vector<std::string> all = base::split_words(line);
            if (all[0] == "note") note = line.substr(5);
            if (all[0] == "view") {
                const size_t at = size_t(std::find(all.rbegin(), all.rend(), "-vp").base() - all.begin());
                for (size_t k = 0; k < 3; ++k) eye[k] = std::stod(all[at + k]);
                last = "view";
            }
            if (all[0] != "overlay") continue;
            last = "overlay";
            if (all[2] == "-") {
                texts.erase(all[1]);
                continue;
            }
            texts[all[1]] = bytes.substr(0, std::stoul(all[2]));
            bytes.erase(0, std::stoul(all[2]));
        }
        if (last.empty()) return;
        const bool broken = (of("a.rad") + of("b.rad")).find("broken") != std::string::npos;
        if (broken && last == "overlay") {
            said.push_back("ptrace: a.rad:1: broken");
            if (eye == before.eye) return void(note.clear());
            note.clear(), last = "view";
        }
        if (!broken) good = {of("a.rad"), of("b.rad")};
        if (last == "overlay" && before.good == good && eye == before.eye) {
            said.push_back("ptrace: same " + std::to_string(edit) + " " + note);
            return void(note.clear());
        }
        ++edit;
        words = last + (note.empty() ? "" : " " + note);
        note.clear();
    }
    std::pair<std::string, std::string> good;  // texts that are rendered
    image::Picture picture(int64_t frames = 1) const {
        image::Picture p = small_picture(2, 2);
        p.header.edit = edit, p.header.edited = words, p.header.frames = frames;
        p.header.view = view::View();
        p.header.view->vp = {eye[0], eye[1], eye[2]};
        return p;
    }
};

struct Page {
    live::State s;
    double at = 0;
    std::string to_ptrace;                  // since it was read last
    std::map<size_t, std::string> written;  // files of the page
    std::map<Which, std::string> to;
    std::vector<Which> started;
    live::Answer answer;

    explicit Page(const std::vector<std::string>& names = {"a.rad", "b.rad"}, const char* regions = nullptr) {
        for (const std::string& name : names) s.files.push_back({name, live::TextFile::Kind::scene, true});
        if (regions) s.files.push_back({regions, live::TextFile::Kind::regions, true});
        s.now.texts.resize(s.files.size());
        s.pipe(Which::picture).own = true;
        s.pipe(Which::picture).stage = live::Pipe::Stage::ended;
        for (size_t n = 0; n < s.files.size(); ++n) disk(n, n < names.size() ? "disk of " + names[n] : "");
    }
    void happen(decltype(live::Event::what) what, double seconds = .01) {
        auto [next, effects] = live::step(s, {at += seconds, std::move(what)});
        s = std::move(next);
        for (const live::Effect& e : effects) {
            if (const auto* a = std::get_if<live::Answer>(&e)) answer = *a;
            if (const auto* p = std::get_if<live::ToPipe>(&e)) to[p->which] += p->bytes;
            if (const auto* t = std::get_if<live::Start>(&e)) started.push_back(t->which), to[t->which].clear();
            const auto* w = std::get_if<live::Write>(&e);
            if (w && w->to == live::Write::To::file) written[w->n] = w->text;
        }
    }
    unsigned ask(const std::string& path, const Pairs& given = {}, const std::string& body = "") {
        happen(live::Request{path, arguments(given), body});
        return answer.status;
    }
    void disk(size_t n, const std::string& text) { happen(live::FileIs{n, {base::hash_of(text), text, ""}}); }
    unsigned type(size_t n, const std::string& text, const std::string& said = "", bool going = false) {
        return ask("/overlay",
                   {{"n", std::to_string(n)},
                    {"version", std::to_string(s.files[n].version)},
                    {"said", said},
                    {"going", going ? "1" : ""}},
                   text);
    }
    unsigned draw(size_t n, const std::string& text) {
        live::Request r{"/file", arguments({{"n", std::to_string(n)}}), text, s.files[n].tag};
        r.put = true;
        happen(r);
        return answer.status;
    }
    unsigned undo() { return ask("/undo", {{"state", std::to_string(s.changes)}}); }
    unsigned redo() { return ask("/redo", {{"state", std::to_string(s.changes)}}); }
    unsigned variant(const std::string& does, const std::string& name) {
        return ask("/variant", {{"do", does}, {"name", name}});
    }
    std::string take(Which which = Which::picture) { return std::exchange(to[which], ""); }
    void come(const image::Picture& p, Which which = Which::picture) {
        happen(live::Came{which, std::make_shared<const image::Picture>(p)});
    }
    std::string text(size_t n) const { return *text_of(s, s.now.texts, n); }
    std::vector<std::string> standing() const {
        std::vector<std::string> all;
        for (const live::Message& m : s.messages)
            if (m.stands) all.push_back(m.text);
        return all;
    }
    // ptrace reads all that was sent, and its picture comes.
    void run(Tracer& t, int64_t frames = 1) {
        t.read(take());
        for (const std::string& line : std::exchange(t.said, {})) happen(live::Said{Which::picture, line});
        come(t.picture(frames));
    }
};

inline Tracer started(Page& page) {
    Tracer t;
    t.disk = {{"a.rad", "disk of a.rad"}, {"b.rad", "disk of b.rad"}};
    t.good = {t.of("a.rad"), t.of("b.rad")};
    page.ask("/start");
    CHECK(page.started == std::vector<Which>{Which::picture});
    CHECK(page.take().empty());
    page.come(t.picture());
    return t;
}
