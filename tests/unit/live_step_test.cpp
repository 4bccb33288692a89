// SPDX-License-Identifier: BSD-3-Clause
// The live page as a function: lists of events, and what the state says after each.  Without a browser, a program or a
// clock.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <deque>
#include <map>
#include <random>
#include <set>

#include "base/hash.h"
#include "base/split.h"
#include "image_pictures.h"
#include "live/answers.h"
#include "live/design_file.h"
#include "live/step.h"

namespace {

using live::Which;
using Pairs = std::vector<std::pair<std::string, std::string>>;

live::Arguments arguments(const Pairs& given) {
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

Tracer started(Page& page) {
    Tracer t;
    t.disk = {{"a.rad", "disk of a.rad"}, {"b.rad", "disk of b.rad"}};
    t.good = {t.of("a.rad"), t.of("b.rad")};
    page.ask("/start");
    CHECK(page.started == std::vector<Which>{Which::picture});
    CHECK(page.take().empty());
    page.come(t.picture());
    return t;
}

}  // namespace

TEST_CASE("changes of texts by version, undone and made again one by one; a drag is one") {
    Page page;
    Tracer t = started(page);
    CHECK(page.type(1, "a") == 200);
    CHECK(page.type(1, "b", "b.rad: 1 to 2", true) == 200);
    CHECK(page.type(1, "c", "b.rad: 1 to 3", true) == 200);
    page.ask("/control", {}, "go\n");
    CHECK(page.type(1, "d") == 200);
    CHECK(page.s.files[1].version == 4);
    CHECK(page.s.files[0].version == 0);
    CHECK(page.ask("/overlay", {{"n", "1"}, {"version", "3"}}, "late") == 412);
    for (const char* want : {"c", "a", "disk of b.rad"}) {
        CHECK(page.undo() == 204);
        CHECK(page.text(1) == want);
    }
    CHECK(page.undo() == 409);
    CHECK(page.s.redo.size() == 3);
    for (const char* want : {"a", "c", "d"}) {
        CHECK(page.redo() == 204);
        CHECK(page.text(1) == want);
    }
    CHECK(page.s.undo[1].words == "b.rad: 1 to 3");
    CHECK(page.ask("/undo", {{"state", "0"}}) == 412);
    page.undo();
    page.type(1, "e");
    CHECK(page.redo() == 409);  // another way was taken
    page.run(t);
    CHECK(t.of("b.rad") == "e");
}

TEST_CASE("all that the page can change is undone and made again, and has a name") {
    Page page({"a.rad"}, "x.regions");
    Tracer t = started(page);
    page.run(t);
    page.variant("keep", "");
    page.type(0, "other", "a.rad: 20 to 32");
    page.variant("keep", "dark");
    page.variant("drop", "A");
    page.draw(1, "desk circle view 20\nwall circle view 30\n");
    page.draw(1, "wall circle view 30\n");
    page.ask("/control", {}, "view -vp 1 2 3\n");
    page.run(t);
    page.ask("/place", {{"do", "keep"}, {"name", "door"}});
    page.variant("show", "dark");
    const std::vector<std::string> names{"variant A kept",
                                         "a.rad: 20 to 32",
                                         "variant dark kept",
                                         "variant A deleted",
                                         "region desk added",
                                         "region desk deleted",
                                         "view",
                                         "view door kept",
                                         "variant dark shown"};
    REQUIRE(page.s.undo.size() == names.size());
    for (size_t k = 0; k < names.size(); ++k) CHECK(page.s.undo[k].words == names[k]);
    const std::string end = json_of(page.s);
    for (int k = 0; k < 3; ++k) page.undo();
    CHECK(page.s.now.views.size() == 1);
    page.undo();
    CHECK(page.written[1] == "desk circle view 20\nwall circle view 30\n");
    page.undo();
    CHECK(page.written[1].empty());
    page.undo();
    CHECK(page.s.now.variants.size() == 2);
    for (int k = 0; k < 3; ++k) page.undo();
    CHECK(page.text(0) == "disk of a.rad");
    CHECK(page.s.now.variants.empty());
    for (size_t k = 0; k < names.size(); ++k) CHECK(page.redo() == 204);
    CHECK(page.written[1] == "wall circle view 30\n");
    CHECK(page.s.now.view() == page.s.now.variants[0].look.view);
    page.run(t);
    CHECK(t.of("a.rad") == "other");
    CHECK(t.eye == std::vector<double>{0, 0, 0});
}

TEST_CASE("an edit that has not arrived is sent again with the next one") {
    Page page;
    Tracer t = started(page);
    page.type(0, "new");
    CHECK(page.take() == "note  [1]\noverlay a.rad 3\nnew");  // which is lost
    page.ask("/control", {}, "view -vp 1 2 3\n");
    CHECK(page.s.pipe(Which::picture).sent.size() == 2);
    page.run(t);
    CHECK(t.of("a.rad") == "new");
    CHECK(page.s.pipe(Which::picture).sent.empty());
    CHECK(page.s.pipe(Which::picture).look == look_now(page.s));
    page.type(1, "more");
    CHECK(page.take() == "note  [3]\noverlay b.rad 4\nmore");  // and no more
}

TEST_CASE("a text that is broken stays said until it is mended, and its view is of the text before") {
    Page page;
    Tracer t = started(page);
    page.type(0, "broken");
    page.run(t);
    CHECK(page.standing() == std::vector<std::string>{"ptrace: a.rad:1: broken"});
    page.come(t.picture(2));
    page.type(0, "still broken");
    page.run(t);
    CHECK(page.standing().size() == 1);
    page.ask("/control", {}, "view -vp 1 2 3\n");
    page.run(t);
    CHECK(page.standing().size() == 1);
    CHECK(*page.s.pipe(Which::picture).look.texts[0] == "disk of a.rad");
    page.variant("keep", "B");
    CHECK(result_of(page.s, page.s.now.variants[0].look) == nullptr);  // the picture is not its own
    page.undo(), page.undo(), page.undo();
    page.run(t);
    CHECK(page.standing().size() == 1);
    page.undo();
    page.run(t);
    CHECK(page.standing().empty());
}

TEST_CASE("messages stand until they are dismissed or their cause is gone") {
    Page page({"a.rad"}, "x.regions");
    Tracer t = started(page);
    page.happen(live::Saved{"vcview: x.design: No space left"});
    page.come(t.picture(2));
    page.type(0, "a");
    page.run(t);
    CHECK(page.standing().size() == 1);
    page.happen(live::Saved{""});
    CHECK(page.standing().empty());
    page.draw(1, "desk circle view 20\n");
    page.happen(live::Said{Which::picture, "vcmetrics: x.regions:1: cannot be read"});
    CHECK(page.standing().size() == 1);
    page.disk(1, "desk circle view 30\n");
    CHECK(page.standing().empty());
    page.happen(live::Said{Which::picture, "vcmetrics: warning: something else"});
    page.happen(live::Said{Which::picture, "ptrace: same 0 "});
    CHECK(page.standing().size() == 1);
    page.ask("/dismiss", {{"number", std::to_string(page.s.messages.back().number)}});
    CHECK(page.standing().empty());
}

TEST_CASE("programs that die are named, started again once with the design as it is, then by a click") {
    Page page;
    Tracer t = started(page);
    page.type(0, "mine");
    page.run(t);
    page.ask("/control", {}, "view -vp 1 2 3\n");
    page.run(t);
    page.happen(live::Ended{Which::picture, "ptrace was ended by signal 9", 137});
    CHECK(page.standing()[0] == "vcview: ptrace was ended by signal 9: it is started again");
    CHECK(page.started.size() == 2);
    CHECK_FALSE(page.s.ended);
    const int64_t last = page.s.pipe(Which::picture).edit;
    Tracer again;
    again.disk = t.disk;
    again.good = {again.of("a.rad"), again.of("b.rad")};
    again.read(page.take());
    CHECK(again.of("a.rad") == "mine");
    CHECK(again.eye == std::vector<double>{1, 2, 3});
    image::Picture p = again.picture();
    *p.header.edit += page.s.pipe(Which::picture).first_edit;
    page.come(p);
    CHECK(page.s.pipe(Which::picture).edit > last);
    CHECK(page.standing().empty());
    page.happen(live::Ended{Which::picture, "ptrace was ended by signal 9", 137});
    CHECK(page.s.ended == 137);
    CHECK(page.started.size() == 2);
    CHECK(page.type(1, "later") == 200);  // nothing that is typed is lost
    CHECK(page.ask("/start") == 204);
    CHECK_FALSE(page.s.ended);
    CHECK(page.take().find("overlay b.rad 5\nlater") != std::string::npos);
    CHECK(page.ask("/start") == 409);
}

TEST_CASE("hours and plan that have died twice start again by a click; who is started anew is not paused") {
    Page page({"a.rad"});
    for (const Which which : {Which::day, Which::plan}) {
        page.s.pipe(which).own = true;
        page.s.pipe(which).stage = live::Pipe::Stage::asleep;
    }
    Tracer t = started(page);
    const auto plan_begins = [&](int64_t frames) {
        page.come(t.picture(frames));
        image::Picture sum = small_picture(2, 2);
        sum.header.edit = page.s.pipe(Which::plan).first_edit;
        page.come(sum, Which::plan);
    };
    const auto plans = [&] { return std::count(page.started.begin(), page.started.end(), Which::plan); };
    const auto waits_for_a_click = [&] { return json_of(page.s).find("\"again\":true") != std::string::npos; };
    plan_begins(4);
    page.happen(live::Ended{Which::plan, "ptaccum was ended by signal 9", 137});
    CHECK(plans() == 2);
    CHECK_FALSE(waits_for_a_click());
    page.happen(live::Ended{Which::plan, "ptaccum was ended by signal 9", 137});
    CHECK(plans() == 2);
    CHECK(waits_for_a_click());
    CHECK(page.ask("/start") == 204);
    CHECK_FALSE(waits_for_a_click());
    CHECK(page.standing().empty());
    plan_begins(5);
    CHECK(plans() == 3);
    CHECK(page.ask("/start") == 409);
    page.ask("/control", {}, "pause\n");
    CHECK(page.s.paused);
    page.happen(live::Ended{Which::picture, "ptrace was ended by signal 9", 137});
    CHECK(page.started.back() == Which::picture);
    CHECK_FALSE(page.s.paused);
}

TEST_CASE("a place that is asked about is two numbers from 0 to 1") {
    Page page;
    Tracer t = started(page);
    CHECK(page.ask("/what", {{"x", ".25"}, {"y", "1"}}) == 204);
    CHECK(page.take() == "what 0.25 1\n");
    for (const char* wrong : {"", "x", "nan", "-.1", "1.1", ".5\nset -o x", ".5 .5", "1e999"}) {
        CHECK(page.ask("/what", {{"x", wrong}, {"y", ".5"}}) == 400);
        CHECK(page.ask("/what", {{"x", ".5"}, {"y", wrong}}) == 400);
    }
    CHECK(page.take().empty());
    page.happen(live::Said{Which::picture, "ptrace: what 0.25 1\t0\twall\tpolygon"});
    const auto answer = live::answer_what(page.s, arguments({{"x", "0.25"}, {"y", "1.0"}}));
    REQUIRE(answer);
    CHECK(answer->body == "wall\tpolygon");
}

TEST_CASE("what is typed before the first picture is in the design; a design of nothing is not written") {
    Page page;
    page.ask("/start");
    CHECK(live::design_text(page.s).empty());
    page.type(0, "typed");
    CHECK(live::design_text(page.s).find("\ntext a.rad\n\ttyped") != std::string::npos);
}

TEST_CASE("a program whose input is wrong is not started again") {
    Page page;
    page.ask("/start");
    page.happen(live::Ended{Which::picture, "", 1});
    CHECK(page.s.ended == 1);
    CHECK(page.started.size() == 1);
}

TEST_CASE("a file that another program writes counts; what was typed, and what stood there, comes back") {
    Page page;
    Tracer t = started(page);
    page.type(0, "typed");
    page.variant("keep", "A");
    page.disk(0, "of an editor");
    CHECK_FALSE(page.s.now.texts[0]);
    CHECK(page.text(0) == "of an editor");
    page.undo();
    CHECK(page.text(0) == "typed");
    page.undo(), page.undo();
    CHECK(page.text(0) == "disk of a.rad");
    page.redo();
    live::Request save{"/file", arguments({{"n", "0"}}), "typed", page.s.files[0].tag};
    save.put = true;
    page.happen(save);
    CHECK(page.written[0] == "typed");
    page.undo();
    CHECK(page.text(0) == "disk of a.rad");
}

TEST_CASE("a variant has the edit that shows it with most frames, its numbers and its picture") {
    Page page;
    Tracer t = started(page);
    page.type(0, "a");
    page.run(t, 3);
    live::Row row{{{"frame", 3}, {"edit", 1}, {"Ev", 1000}, {"Ev.lo", 900}, {"Ev.hi", 1100}}};
    page.happen(live::Measured{Which::picture, row});
    page.variant("keep", "A");
    const auto edit = [&] { return result_of(page.s, page.s.now.variants[0].look)->edit; };
    CHECK(edit() == 1);
    CHECK(result_of(page.s, page.s.now.variants[0].look)->numbers[0] == "Ev 1000 (900 to 1100)");
    CHECK(page.s.said_against == "1");
    page.type(0, "b");
    page.run(t);
    page.type(0, "a");
    page.run(t, 2);
    CHECK(edit() == 1);
    page.come(t.picture(4));
    CHECK(edit() == 3);
    CHECK(page.s.said_against == "3");
    page.variant("base", "");
    CHECK(page.s.said_against == "previous");
}

TEST_CASE("a picture that comes late is not taken for the newer edit") {
    Page page;
    Tracer t = started(page);
    page.type(0, "a");
    const image::Picture late = t.picture(9);
    page.run(t);
    page.variant("keep", "A");
    page.come(late);
    CHECK(page.s.picture->header.edit == 1);
    CHECK(result_of(page.s, page.s.now.variants[0].look)->picture->header.edit == 1);
}

TEST_CASE("a plan rests until the picture of a change has four frames, and then has the texts of the page") {
    Page page({"a.rad"});
    page.s.pipe(Which::plan).stage = live::Pipe::Stage::asleep;
    Tracer t = started(page);
    page.come(t.picture(3));
    CHECK(page.started.size() == 1);
    page.come(t.picture(4));
    CHECK(page.started.size() == 2);
    CHECK(page.take(Which::plan) == "go\n");
    page.type(0, "new");
    CHECK(page.take(Which::plan) == "pause\n");
    page.come(t.picture(9));  // of before
    CHECK(page.take(Which::plan).empty());
    page.run(t, 3);
    CHECK(page.take(Which::plan).empty());
    CHECK(plan_waits(page.s));
    page.come(t.picture(4));
    CHECK(page.take(Which::plan) == "go\nnote  [2]\noverlay a.rad 3\nnew");
    page.come(t.picture(5));
    CHECK(page.take(Which::plan).empty());
    CHECK(plan_waits(page.s));
    image::Picture sum = small_picture(2, 2);
    sum.header.edit = 7, sum.header.edited = "overlay  [2]";
    page.come(sum, Which::plan);
    CHECK_FALSE(plan_waits(page.s));
    CHECK(json_of(page.s).find("\"limit\":300,\"edit\":7,\"waits\":false") != std::string::npos);
    page.happen(live::PointsChanged{});
    CHECK(plan_waits(page.s));
    page.happen(live::Drawn{1});
    CHECK_FALSE(plan_waits(page.s));
    page.ask("/control", {}, "pause\n");
    CHECK(page.take(Which::plan) == "pause\n");
    CHECK(page.ask("/plan", {{"limit", "500"}}) == 204);
    for (const char* wrong : {"", "0", "-1", "nan", "1e9", "5 6"}) CHECK(page.ask("/plan", {{"limit", wrong}}) == 400);
}

TEST_CASE("a small picture of the model goes before the hours, unless the large one has an interval") {
    Page page;
    page.s.pipe(Which::day).stage = live::Pipe::Stage::asleep;
    Tracer t = started(page);
    CHECK(page.started.back() == Which::day);
    CHECK(page.take(Which::day) == "size 64 64\nnote now [1]\nview" + page.s.now.view() + "\n");
    const auto row = [&](double edit, double frame, double dgp) {
        page.happen(live::Measured{
            Which::day, {{{"frame", frame}, {"edit", edit}, {"DGPf", dgp}, {"DGPf.lo", .2}, {"DGPf.hi", .4}}}});
    };
    const auto come = [&](int64_t edit, const std::string& words) {
        image::Picture p = small_picture(2, 2);
        p.header.edit = edit, p.header.edited = words;
        page.come(p, Which::day);
    };
    const auto says = [&](const std::string& words) { return json_of(page.s).find(words) != std::string::npos; };
    row(0, 2, .1);  // of another view
    CHECK(says("\"first\":null"));
    come(1, "view now [1]");
    row(1, 2, .3);
    CHECK(says("\"first\":{\"frame\":2,\"DGPf\":0.3,\"DGPf.lo\":0.2,\"DGPf.hi\":0.4,\"Ev\":null}"));
    CHECK(says("\"waits\":false"));
    page.type(0, "new");
    CHECK(says("\"first\":null"));
    CHECK(says("\"waits\":true"));
    CHECK(page.take(Which::day) == "note now [3]\noverlay a.rad 3\nnew");
    row(1, 3, .3);  // of before
    CHECK(says("\"first\":null"));
    come(2, "overlay now [3]");
    row(2, 2, .35);
    CHECK(says("\"DGPf\":0.35"));
    page.type(0, "drag", "", true);  // a slider moves: nothing is asked for
    CHECK(page.take(Which::day).empty());
    CHECK(says("\"first\":null"));
    page.ask("/control", {}, "go\n");
    CHECK(page.take(Which::day) == "note now [5]\noverlay a.rad 4\ndrag");
    page.happen(live::Said{Which::day, "ptrace: a.rad:1: is broken"});
    page.run(t);
    CHECK(says("\"waits\":false"));
    page.type(0, "again");
    page.run(t);
    page.happen(live::Measured{Which::picture, {{{"frame", 2}, {"edit", 3}, {"Ev", 9}, {"Ev.lo", 8}, {"Ev.hi", 10}}}});
    page.take(Which::day);
    page.ask("/control", {}, "go\n");
    CHECK(page.take(Which::day).empty());
}

TEST_CASE("the picture rests when it is settled and good enough, or nobody looks for long") {
    Page page;
    Tracer t = started(page);
    const auto settled = [&](double edit) {
        page.happen(live::Measured{Which::picture, {{{"frame", 20}, {"edit", edit}, {"settled", 1}}}});
    };
    settled(0);
    page.come(t.picture(255));
    page.happen(live::Tick{true});
    CHECK(page.take().empty());
    page.come(t.picture(256));
    page.happen(live::Tick{true});
    CHECK(page.take() == "pause\n");
    CHECK(json_of(page.s).find("\"rests\":true") != std::string::npos);
    page.happen(live::Tick{true});
    CHECK(page.take().empty());
    page.ask("/control", {}, "go\n");
    CHECK(page.take() == "go\n");
    page.happen(live::Tick{true});
    page.happen(live::Tick{true});
    CHECK(page.take().find("pause") == std::string::npos);
    page.type(0, "a");  // ends it by itself
    page.run(t);
    page.happen(live::Tick{true});
    CHECK(page.take().empty());
    settled(1);
    page.come(t.picture(300));
    page.happen(live::Tick{true});
    CHECK(page.take() == "pause\n");
    page.type(0, "b");
    page.run(t);
    page.happen(live::Tick{true}, 200);
    page.happen(live::Tick{false}, 200);
    CHECK(page.take().empty());
    page.happen(live::Tick{false}, 200);
    CHECK(page.take() == "pause\n");
    page.happen(live::Tick{true});
    CHECK(page.take() == "go\n");
}

TEST_CASE("regions that are drawn while the picture rests are measured") {
    Page page({"a.rad"}, "x.regions");
    Tracer t = started(page);
    const auto settled = [&](double frame) {
        page.happen(live::Measured{Which::picture, {{{"frame", frame}, {"edit", 0}, {"settled", 1}}}});
        page.happen(live::Tick{true});
    };
    page.come(t.picture(256));
    settled(20);
    CHECK(page.take() == "pause\n");
    page.disk(1, "desk circle view 30\n");
    page.happen(live::Tick{true});
    CHECK(page.take() == "go\n");
    settled(256);  // may have been on its way, without them
    CHECK(page.take().empty());
    settled(300);
    CHECK(page.take() == "pause\n");
}

TEST_CASE("an hour of the day has the numbers of its own edit") {
    Page page({"sky.rad"});
    page.disk(0, "!gensky 12 21 14 +s\n");
    Tracer t = started(page);
    page.s.pipe(Which::day).stage = live::Pipe::Stage::asleep;
    const auto certain = [&](double edit) {  // the picture needs no small one
        page.happen(
            live::Measured{Which::picture, {{{"frame", 4}, {"edit", edit}, {"Ev", 9}, {"Ev.lo", 8}, {"Ev.hi", 10}}}});
    };
    certain(0);
    page.come(t.picture(32));
    CHECK(page.started.back() == Which::day);
    const std::string sent = page.take(Which::day);
    CHECK(sent.find("overlay sky.rad 20\n!gensky 12 21 12 +s\n") != std::string::npos);
    const auto row = [&](int64_t edit, double ev) {
        const double e = double(edit);
        page.happen(live::Measured{Which::day, {{{"frame", 8}, {"edit", e}, {"Ev", ev}, {"DGPf", .3}}}});
    };
    image::Picture p = small_picture(2, 2);
    p.header.edit = 0, p.header.edited = "start";
    page.come(p, Which::day);
    row(0, 500);  // of 14:00
    CHECK(page.s.day.hours.empty());
    p.header.edit = 1, p.header.edited = "overlay 12:00 [" + std::to_string(page.s.sent) + "]";
    page.come(p, Which::day);
    row(1, 1000);
    CHECK(page.s.day.hours.size() == 1);
    CHECK(page.take(Which::day).find(" 12 21 11 ") != std::string::npos);
    page.type(0, "!gensky 12 21 11 +s\n");  // another hour of that day: the hours stay
    CHECK(page.s.day.hours.size() == 1);
    CHECK(page.take(Which::day).empty());  // the small picture of it is asked for already
    page.type(0, "!gensky 6 21 11 +s\n");
    CHECK(page.s.day.hours.empty());
    p.header.edit = 2, p.header.edited = "overlay 11:00 [3]";
    page.come(p, Which::day);
    row(2, 900);  // of December
    CHECK(page.s.day.hours.empty());
}

namespace {

// Two windows, programs that die, a disk, and pictures that come late, twice or never.
struct Campaign {
    Page page;
    Tracer tracer = started(page);
    std::minstd_rand dice;
    std::map<int64_t, std::pair<std::string, std::string>> shown;  // what each edit shows: texts and view
    std::deque<image::Picture> late;
    size_t known[2][2] = {};  // versions, by window and file
    live::Model first;
    size_t forgotten = 0;
    bool broken = false;

    explicit Campaign(unsigned seed) : dice(seed) {
        first = page.s.now;
        note();
    }
    size_t roll(size_t n) { return size_t(dice() >> 8) % n; }

    void note() {
        shown[page.s.pipe(Which::picture).first_edit + tracer.edit] = {tracer.good.first + "|" + tracer.good.second,
                                                                       view::to_options(*tracer.picture().header.view)};
    }
    void read() {
        const int64_t edit = tracer.edit;
        tracer.read(page.take());
        if (tracer.edit != edit) note();
        for (const std::string& line : std::exchange(tracer.said, {})) page.happen(live::Said{Which::picture, line});
    }
    void come(image::Picture p) {
        if (page.s.pipe(Which::picture).stage != live::Pipe::Stage::running) return;
        page.come(p);
        live::Row row{{{"frame", double(*p.header.frames)},
                       {"edit", double(*p.header.edit)},
                       {"Ev", double(*p.header.edit)},
                       {"Ev.lo", 0},
                       {"Ev.hi", 1}}};
        if (roll(2)) page.happen(live::Measured{Which::picture, row});
    }
    void die() {
        if (page.s.pipe(Which::picture).stage != live::Pipe::Stage::running) return;
        page.happen(live::Ended{Which::picture, "ptrace was ended by signal 9", 137});
        late.clear();
        if (page.s.pipe(Which::picture).stage == live::Pipe::Stage::ended && roll(2)) page.ask("/start");
        if (page.s.pipe(Which::picture).stage == live::Pipe::Stage::running) begin();
    }
    void begin() {
        const auto disk = tracer.disk;
        tracer = {};
        tracer.disk = disk;
        tracer.good = {tracer.of("a.rad"), tracer.of("b.rad")};
        note();
    }
    image::Picture picture() {
        image::Picture p = tracer.picture(int64_t(roll(40)));
        *p.header.edit += page.s.pipe(Which::picture).first_edit;
        return p;
    }
    void type() {
        const size_t window = roll(2), n = roll(2);
        if (roll(3)) known[window][n] = page.s.files[n].version;
        const std::string text = roll(12) ? "text " + std::to_string(dice()) : "broken";
        const bool fresh = known[window][n] == page.s.files[n].version;
        const unsigned status = page.ask("/overlay",
                                         {{"n", std::to_string(n)},
                                          {"version", std::to_string(known[window][n])},
                                          {"said", "said"},
                                          {"going", roll(5) ? "" : "1"}},
                                         text);
        CHECK(status == (fresh ? 200 : 412));
        if (fresh) CHECK(page.text(n) == text);
        if (fresh) known[window][n] = page.s.files[n].version;
    }
    void save(size_t n, const std::string& text) {
        const std::string typed = page.text(n);
        const bool stood = bool(page.s.now.texts[n]);
        page.disk(n, text);
        if (stood && typed != text) CHECK(*text_of(page.s, page.s.undo.back().model.texts, n) == typed);
        tracer.texts.erase(n ? "b.rad" : "a.rad");
        tracer.disk[n ? "b.rad" : "a.rad"] = text;
        const auto good = tracer.good;
        tracer.good = {tracer.of("a.rad"), tracer.of("b.rad")};
        if ((tracer.good.first + tracer.good.second).find("broken") != std::string::npos) tracer.good = good;
        if (tracer.good == good) return;
        ++tracer.edit, tracer.words = "scene";
        note();
    }
    void happen() {
        const size_t changes = page.s.undo.size();
        switch (roll(16)) {
        case 0:
        case 1:
        case 2:
        case 3: type(); break;
        case 4: page.undo(); break;
        case 5: page.redo(); break;
        case 6: page.variant("keep", roll(2) ? "" : "A"); break;
        case 7: page.variant(roll(2) ? "drop" : "base", "A"); break;
        case 8: page.variant("show", roll(2) ? "A" : "B"); break;
        case 9: page.ask("/control", {}, "view -vp " + std::to_string(roll(9)) + " 1 1\n"); break;
        case 10: page.ask("/back"); break;
        case 11: read(); break;
        case 12:
            read();
            come(picture());
            break;
        case 13:
            late.push_back(picture());
            if (roll(2)) come(late.back());
            break;
        case 14:
            if (!late.empty()) come(late.front());
            if (roll(2) && !late.empty()) late.pop_front();
            break;
        default:
            if (!roll(6)) die();
            else if (!roll(4)) read(), save(roll(2), "disk " + std::to_string(dice()));
        }
        forgotten += changes == 50 && page.s.undo.size() == 50;
        check();
    }
    void check() {
        const live::Pipe& p = page.s.pipe(Which::picture);
        const auto told = [&](const live::Look& l) {
            return std::pair<std::string, std::string>(*l.texts[0] + "|" + *l.texts[1], l.view);
        };
        const bool known = p.edit >= p.first_edit && p.look.texts[0] && p.look.texts[1];
        if (known) CHECK(shown.at(p.edit).first == told(p.look).first);
        if (known) CHECK(shown.at(p.edit).second == told(p.look).second);
        for (const live::Result& r : page.s.results) {
            if (r.edit < 0) continue;
            REQUIRE(shown.count(r.edit));
            CHECK(shown.at(r.edit) == told(r.look));
            CHECK(r.picture->header.edit == r.edit);
            const std::string numbers = r.numbers.empty() ? "" : r.numbers[0];
            if (!numbers.empty()) CHECK(numbers == "Ev " + std::to_string(r.edit) + " (0 to 1)");
        }
    }
    void end() {
        const auto same = [](const live::Model& a, const live::Model& b) {
            return a.views == b.views && a.variants.size() == b.variants.size() && a.base == b.base;
        };
        if (page.s.pipe(Which::picture).stage != live::Pipe::Stage::running) page.ask("/start"), begin();
        const live::State last = page.s;
        while (page.undo() == 204) {}
        if (!forgotten) CHECK(same(page.s.now, first));
        if (!forgotten && last.undo.size()) CHECK(page.text(0) == *text_of(last, last.undo[0].model.texts, 0));
        while (page.redo() == 204) {}
        for (const size_t n : {0, 1}) {
            const bool gone = last.redo.size() > 0;  // what had been undone is made again, too
            if (!gone) CHECK(page.text(n) == *text_of(last, last.now.texts, n));
        }
        page.type(0, "the last one"), page.type(1, "likewise");
        read();
        come(picture());
        CHECK(tracer.good == std::pair<std::string, std::string>("the last one", "likewise"));
        CHECK(page.s.pipe(Which::picture).look == look_now(page.s));
        CHECK(page.standing() == std::vector<std::string>{});
    }
};

}  // namespace

TEST_CASE("whatever happens in whatever order: no text is lost, no number stands beside another edit's picture") {
    const char* const asked = std::getenv("LISTS");
    const unsigned lists = asked ? unsigned(std::atoi(asked)) : 10000;
    for (unsigned seed = 1; seed <= lists; ++seed) {
        CAPTURE(seed);
        Campaign c(seed);
        for (size_t k = 10 + c.roll(60); k > 0; --k) c.happen();
        c.end();
    }
}
