// SPDX-License-Identifier: BSD-3-Clause
// Random lists of events for the live page, and what must hold after each.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include "live_page_model.h"

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
