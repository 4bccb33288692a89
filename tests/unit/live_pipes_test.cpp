// SPDX-License-Identifier: BSD-3-Clause
// The programs of the live page: when picture, hours and plan run, rest, end and begin again.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include "live/steps.h"
#include "live_page_model.h"

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

TEST_CASE("a program whose input is wrong is not started again") {
    Page page;
    page.ask("/start");
    page.happen(live::Ended{Which::picture, "", 1});
    CHECK(page.s.ended == 1);
    CHECK(page.started.size() == 1);
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
    const auto sun = [&](double low) {  // in the eye: DGPf is 1 in all frames, which have no interval yet
        page.happen(
            live::Measured{Which::day, {{{"frame", 3}, {"edit", 1}, {"DGPf", 1}, {"Ev", 9e3}, {"Ev.lo", low}}}});
    };
    sun(7999);  // 5.87e-5 lx + .16
    CHECK(says("\"DGPf\":1,\"DGPf.lo\":0.62"));
    sun(4e4);
    CHECK(says("\"DGPf\":1,\"DGPf.lo\":1,\"DGPf.hi\":1,"));
    for (const double low : {900., double(NAN)}) {
        sun(low);
        CHECK(says("\"DGPf\":1,\"DGPf.lo\":null,\"DGPf.hi\":null,"));
    }
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

TEST_CASE("hours of the night are none of the day, with lamps or without") {
    live::Day day;
    const auto hours = [&] {
        std::string out;
        for (const auto& [hour, row] : live::lit_hours(day)) out += std::to_string(hour) + " ";
        return out;
    };
    for (const auto& [hour, lx] :
         {std::pair(5, 20.), {6, 20.1}, {7, 90.}, {12, 2300.}, {16, 400.}, {17, 21.}, {18, 20.}})
        day.hours[hour] = {.2, .19, .21, lx};
    CHECK(hours() == "5 6 7 12 16 17 18 ");  // more may come
    day.ends[0] = true;
    CHECK(hours() == "7 12 16 17 18 ");
    day.ends[1] = true;  // 17 and 18 differ: it is dusk
    CHECK(hours() == "7 12 16 17 18 ");
    day.hours[19] = day.hours[18];
    CHECK(hours() == "7 12 16 17 ");
    day.hours[17][3] = .5;
    CHECK(hours() == "7 12 16 ");
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
