// SPDX-License-Identifier: BSD-3-Clause
// A year from tables of hours: what is read, what it comes to, which hours could change it, its files.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>

#include "temp_folder.h"
#include "uncertainty/student.h"
#include "year/honeybee.h"
#include "year/next.h"
#include "year/plot.h"
#include "year/text.h"

namespace {

using namespace year;

const std::string head = "frame\tseconds\tsky\tEv\tDGPf\tDGPf.lo\tDGPf.hi\tDGP.px\tpixels\n";

// Of a picture so large that its pixels have no error of their own.
std::string row(const char* hour, double dgp, double half, double px = 0, int frames = 8) {
    char text[200];
    std::snprintf(text, sizeof text, "%d\t1\t%s\t%g\t%g\t%g\t%g\t%g\t1e12\n", frames, hour, dgp > .159 ? 1000. : 0.,
                  dgp + .001, dgp - half, dgp + half, px);
    return text;
}

// n hours from 1 January on, DGP rising from 0 to 1.
View ramp(int n, double half) {
    View v;
    for (int i = 0; i < n; ++i) {
        Hour h;
        h.time = {weather::date_of(1 + i / 24), i % 24 + .5};
        h.dgp = {i / double(n), half / 1.959964, 0};
        h.frames = 8;
        v.hours.push_back(h);
    }
    return v;
}

}  // namespace

TEST_CASE("the last line of each hour counts, without its bias, in files joined by cat and in later ones") {
    TempFolder folder;
    const std::string a =
        folder.holding("a.tsv", head + row("0621_1430", .5, .1, .002, 1) + row("0621_1430", .4, .01, .003) +
                                    row("0102_0830", .159, std::nan("")) + head + row("0622_1430", .3, .01));
    const std::string b = folder.holding("b.tsv", head + row("0622_1430", .31, .001, 0, 40));
    const Tables t = read_tables({a, b});
    REQUIRE(t.views.size() == 1);
    const std::vector<Hour>& hours = t.views[0].hours;
    REQUIRE(hours.size() == 3);
    CHECK(!t.exact);
    CHECK(hours[0].dark);
    CHECK(hours[0].dgp.error == 0);
    CHECK(hours[1].dgp.value == doctest::Approx(.4));
    CHECK(hours[1].high() == doctest::Approx(.4 + .01 + .003));
    CHECK(hours[1].dgp.bound == .003);
    CHECK(hours[2].frames == 40);
    CHECK(hours[2].dgp.value == doctest::Approx(.31));
    CHECK(read_tables({b, a}).views[0].hours[2].frames == 40);
}

TEST_CASE("of an hour's lines that of the largest picture counts, in any order, unless it has no interval") {
    TempFolder folder;
    const auto text = [&](double dgp, double half, const char* pixels, int frame) {
        return head + std::to_string(frame) + "\t1\t0621_1430\t1000\t" + std::to_string(dgp) + "\t" +
               std::to_string(dgp - half) + "\t" + std::to_string(dgp + half) + "\t0\t" + pixels + "\n";
    };
    const std::string small = folder.holding("s.tsv", text(.39, .001, "3217", 64)),
                      large = folder.holding("l.tsv", text(.41, .004, "12868", 8)),
                      again = folder.holding("a.tsv", text(.42, .004, "12868", 8)),
                      unknown = folder.holding("u.tsv", text(1, std::nan(""), "51472", 8));
    const auto value = [](const std::vector<std::string>& paths) { return read_tables(paths).views[0].hours[0]; };
    CHECK(value({small, large}).dgp.value == doctest::Approx(.41));
    CHECK(value({large, small}).dgp.value == doctest::Approx(.41));
    CHECK(value({large, small}).dgp.bound == doctest::Approx(.0025));
    CHECK(value({large, small}).least_pixels == 3217);
    CHECK(value({again, large}).dgp.value == doctest::Approx(.41));
    CHECK(value({large, again}).dgp.value == doctest::Approx(.42));
    CHECK(value({unknown, small}).dgp.value == doctest::Approx(.39));
    CHECK(value({small, unknown}).dgp.value == doctest::Approx(.39));
}

TEST_CASE("small pictures have an error of pixels beyond DGP.px, half of it at twice the sides") {
    TempFolder folder;
    const auto bound = [&](const char* pixels) {
        const std::string text = "sky\tDGPf\tDGPf.lo\tDGPf.hi\tDGP.px\tpixels\n0621_1430\t.4\t.39\t.41\t.001\t";
        return read_tables({folder.holding("p.tsv", text + pixels + "\n")}).views[0].hours[0].dgp.bound;
    };
    CHECK(bound("3217") == doctest::Approx(.005));
    CHECK(bound("12868") == doctest::Approx(.0025));
    CHECK(bound("823552") == .001);
}

TEST_CASE("with DGPf.px the error of pixels is smaller, and what it says counts on its side alone") {
    TempFolder folder;
    const auto dgp = [&](const char* px, const char* joins) {
        const std::string text = "sky\tDGPf\tDGPf.lo\tDGPf.hi\tDGP.px\tDGPf.px\tpixels\n0621_1430\t.41\t.409\t.411\t";
        return read_tables({folder.holding("p.tsv", text + px + "\t" + joins + "\t3217\n")}).views[0].hours[0];
    };
    CHECK(dgp("-.03", "0").dgp.bound == doctest::Approx(.0015));
    const Hour down = dgp(".001", "-.02"), up = dgp(".001", ".02");
    CHECK(down.dgp.at(-1) == doctest::Approx(.3885));
    CHECK(down.dgp.at(1) == doctest::Approx(.4115));
    CHECK(up.dgp.at(-1) == doctest::Approx(.4085));
    CHECK(up.dgp.at(1) == doctest::Approx(.4315));
    CHECK(holds(down, .40));
    CHECK(!holds(up, .40));
    CHECK(holds(up, .43));
}

TEST_CASE("a year is the same whatever the certainty of the table's limits") {
    TempFolder folder;
    const auto year = [&](double certain, bool errors) {
        std::string text = "frame\tsky\tDGPf\tDGPf.lo\tDGPf.hi\tpixels" + std::string(errors ? "\terrors\n" : "\n");
        const double t = uncertainty::student_quantile(1 - certain, 4);
        for (int h = 8; h < 18; ++h) {
            char row[200];
            const double dgp = .38 + .004 * (h - 8), error = .004;
            std::snprintf(row, sizeof row, "8\t0621_%02d30\t%g\t%g\t%g\t1e12%s\n", h, dgp, dgp - t * error,
                          dgp + t * error, errors ? "\tEv=3/7 DGPf=0.004/4" : "");
            text += row;
        }
        const Tables tables = read_tables({folder.holding("c.tsv", text)});
        CHECK(tables.no_errors == !errors);
        return summary(tables.views, {judge(tables.views[0], .05)}, "");
    };
    for (const double certain : {.6, .9, .99}) {
        CHECK(year(certain, true) == year(.95, true));
        CHECK(year(certain, false) != year(.95, false));
    }
}

TEST_CASE("hours that share their paths are counted in half-samples, or not at all") {
    TempFolder folder;
    // Two half-samples of three have all hours above .40, or none.
    const auto row = [](int day, const char* halves, const char* paths) {
        char text[200];
        std::snprintf(text, sizeof text, "8\t06%02d_1230\t.4%02d\t.3\t.5\t1e12\tDGPf=0.01/8%s\t%s\n", day, day % 5,
                      halves, paths);
        return std::string(text);
    };
    const auto year = [&](const std::string& rows) {
        const std::string text = "frame\tsky\tDGPf\tDGPf.lo\tDGPf.hi\tpixels\terrors\tpaths\n";
        return judge(read_tables({folder.holding("h.tsv", text + rows)}).views[0], .05);
    };
    std::string own, same, without = row(1, "", "1f2e3d4c"), other = row(1, "/A_A_A_A__A_A_A_A/8", "00000000");
    for (int day = 2; day <= 30; ++day) {
        own += row(day, "/A_A_A_A__A_A_A_A/8", "-"), same += row(day, "/A_A_A_A__A_A_A_A/8", "1f2e3d4c");
    }
    const Verdict apart = year(own), shared = year(same);
    CHECK(shared.above[1].value == apart.above[1].value);
    CHECK(shared.above[1].low == 0);
    CHECK(shared.above[1].high == 29);
    CHECK(apart.above[1].high - apart.above[1].low < 12);
    CHECK(shared.exceeded.high - shared.exceeded.low > 1.5 * (apart.exceeded.high - apart.exceeded.low));
    const auto said = [&](const std::string& rows) { return error_text([&] { year(rows); }); };
    CHECK(said(same + without) ==
          "0601_1230: has no half-samples, but hours of this year share their paths (vcmetrics -halves)");
    CHECK(said(own + without).find("has no half-samples") != std::string::npos);
    CHECK(said(same + other) ==
          "0602_1230: and 0601_1230 share their paths with hours of two runs: seeds, frames or hours of them differ");
    CHECK(year(own + other).above[1].high == 30);  // one hour that may share its paths, and does with none
    CHECK(said(row(1, "/A_A_A/8", "-")).find("is not NAME=ERROR/DEGREES") != std::string::npos);
}

TEST_CASE("where every frame is at the cap there is a year; illuminance alone decides where it is above a limit") {
    TempFolder folder;
    const auto read = [&](const char* ev) {
        const std::string text = "frame\tsky\tEv\tEv.lo\tEv.hi\tDGPf\tDGPf.lo\tDGPf.hi\tDGP.px\tDGPf.px\terrors\n",
                          end = "\t1\tnan\tnan\t0\t0\tEv=100/8\n";
        const std::string path =
            folder.holding("s.tsv", text + "9\t0621_1230\t" + ev + end + "9\t0622_1230\t" + ev + end);
        return read_tables({path}).views[0];
    };
    const View bright = read("9000\t8900\t9100"), dim = read("5000\t4900\t5100");
    const Verdict sure = judge(bright, .05), open = judge(dim, .05);
    CHECK(sure.undecided == 0);
    CHECK(sure.above[2].low == 2);
    CHECK(sure.exceeded.low == doctest::Approx(.16 + 5.87e-5 * (9000 - 100 * 2.306)).epsilon(1e-3));
    CHECK(sure.exceeded.high == doctest::Approx(1));
    CHECK(open.undecided == 2);  // 4770 lx are not enough for .45
    CHECK(open.above[1].low == 2);
    CHECK(open.above[2].low == 0);
}

TEST_CASE("views are told apart; exact tables have no intervals") {
    TempFolder folder;
    const std::string a =
        folder.holding("a.tsv", "frame\tview\tsky\tDGP\n8\tdesk\t0621_1430\t.4\n8\tdoor\t0621_1430\t.2\n");
    const Tables t = read_tables({a});
    REQUIRE(t.views.size() == 2);
    CHECK(t.views[1].name == "door");
    CHECK(t.exact);
    CHECK(t.no_pixels);
}

TEST_CASE("tables that are no year") {
    TempFolder folder;
    const auto said = [&](const std::string& text) {
        const std::string path = folder.holding("x.tsv", text);
        const std::string error = error_text([&] { read_tables({path}); });
        return error.substr(error.rfind(path, 0) == 0 ? path.size() : 0);
    };
    CHECK(said("frame\tEv\tDGP\n1\t2\t.3\n") == ": has no column sky with the names of hours (ptrace -wea)");
    CHECK(said("frame\tsky\tEv\n1\t0621_1430\t3\n") == ": has no column DGPf or DGP");
    CHECK(said("frame\tsky\tDGP\n1\tsky_0900\t3\n") == ": \"sky_0900\" is not the name of an hour (0621_1430)");
    CHECK(said(head + row("0621_1430", .3, std::nan(""))) ==
          "0621_1430: has no interval: it needs two frames or more, and vcmetrics -ci 95");
}

TEST_CASE("an hour without an interval among others is undecided, and needs frames") {
    TempFolder folder;
    const Tables t =
        read_tables({folder.holding("x.tsv", head + row("0621_1330", .2, .01) + row("0621_1430", 1, std::nan("")))});
    const View& view = t.views.at(0);
    REQUIRE(view.hours.size() == 2);
    CHECK(view.hours[1].dgp.value == 1.001);  // as printed: row() has it beside the middle
    const Verdict v = judge(view, .05);
    CHECK(v.undecided == 1);
    CHECK(v.above[2].low == 0);
    CHECK(v.above[2].high == 1);
    const std::vector<Need> all = needs(view, v, .05);
    REQUIRE(all.size() >= 1);
    CHECK(all[0].frames == 17);
    CHECK(all[0].larger == 1);
}

TEST_CASE("counts, the exceeded value, class and autonomy of exact hours") {
    const Verdict v = judge(ramp(1000, 0), .05);
    CHECK(v.above[0].value == 649);  // 351 ... 999
    CHECK(v.above[1].low == 599);
    CHECK(v.above[2].high == 549);
    CHECK(v.exceeded.value == .949);
    CHECK(v.exceeded.low == doctest::Approx(.949));
    CHECK(v.best == 3);
    CHECK(v.worst == 3);
    CHECK(v.autonomy.value == doctest::Approx(.401));
    CHECK(v.undecided == 0);
}

TEST_CASE("the class is that of the value that 5 % exceed, and undecided where its interval holds a limit") {
    View v = ramp(100, 0);
    for (Hour& h : v.hours) h.dgp.value *= .4 / .94;  // the sixth value from the top is .4
    CHECK(class_name(judge(v, .05).worst) == std::string("medium"));
    for (Hour& h : v.hours) h.dgp.error = .005;
    const Verdict open = judge(v, .05);
    CHECK(class_name(open.best) == std::string("medium"));
    CHECK(class_name(open.worst) == std::string("minimum"));
    CHECK(open.exceeded.low < .4);
    CHECK(open.exceeded.high > .4);
    CHECK(open.undecided > 0);
}

TEST_CASE("hours that could change the class: as few of the cheapest as decide it, and what they need") {
    const auto around = [](double middle, double half, double bound) {
        View v = ramp(100, half);
        for (Hour& h : v.hours) h.dgp.value *= middle / .94, h.dgp.bound = bound;  // the sixth from the top
        return v;
    };
    const auto needs_of = [](const View& v) { return needs(v, judge(v, .05), .05); };
    const View noisy = around(.4, .01, 0);  // .392 .396 .4 .404 .408 hold .4, so that it stays on the limit
    const std::vector<Need> all = needs_of(noisy);
    REQUIRE(all.size() == 5);
    CHECK(all[0].hour.dgp.value == doctest::Approx(.392).epsilon(.002));
    CHECK(all[0].frames == 33);  // three standard errors of .01 / 1.96 to .008
    CHECK(all[0].larger == 1);
    for (const Need& n : all) CHECK(n.limit == .4);
    const std::vector<Need> pixels = needs_of(around(.404, .001, .005));
    REQUIRE(!pixels.empty());
    CHECK(pixels[0].larger == 2);
    CHECK(pixels[0].frames == 9);
    CHECK(pixels.size() == 1);  // .3954 .3997 .404: of those that hold .4 only the last one can show that six are above
    CHECK(pixels[0].hour.dgp.value == doctest::Approx(.404));
    const std::vector<View> decided{around(.403, .001, .0005), around(.2, 0, .1)};
    for (const View& v : decided) CHECK(needs_of(v).empty());
    View fine = around(.4, 0, .0004);
    for (Hour& h : fine.hours) h.pixels = 823552;
    CHECK(judge(fine, .05).best < judge(fine, .05).worst);
    CHECK(needs_of(fine).empty());  // no larger picture
}

TEST_CASE("what is next says sizes by the smallest picture of the view") {
    View v = ramp(100, .001);
    for (Hour& h : v.hours) h.dgp.value *= .4012 / .94, h.dgp.bound = .0025, h.pixels = 12912;
    v.hours[0].least_pixels = 3228;
    const std::string text = need_lines({v}, {judge(v, .05)}, .05);
    CHECK(text.rfind("hour\tframes\tlarger\tlimit\tview\n0104_2230\t9\t8\t0.40\t-\n", 0) == 0);
}

TEST_CASE("five lines") {
    TempFolder folder;
    std::string text = head + row("0102_0830", .159, std::nan(""));
    for (int day = 10; day < 29; ++day)
        text += row(("06" + std::to_string(day) + "_1430").c_str(), .2 + .01 * day, .004, .001);
    const std::vector<View> views = read_tables({folder.holding("t.tsv", text)}).views;
    CHECK(summary(views, {judge(views[0], .05)}, "ptrace room.rad") ==
          "hours     20, 1 dark, 3 undecided\n"
          "above     0.35: 13 (13 to 14)   0.40: 8 (8 to 9)   0.45: 3 (3 to 4)\n"
          "DGPe5     0.470 (0.465 to 0.475): EN 17037 none\n"
          "autonomy  60.0 % (55.0 to 60.0) of the hours are not above 0.40\n"
          "worst     0.480: ptrace -hours 0628_1430 room.rad\n");
    CHECK(worst_lines(views, 2, "p") == "0.480\t-\tp -hours 0628_1430\n0.470\t-\tp -hours 0627_1430\n");
}

TEST_CASE("spatial autonomy counts views, sure ones and possible ones") {
    std::vector<Verdict> all(4);
    all[0].autonomy = {.99, .98, 1};
    all[1].autonomy = {.951, .94, .96};
    all[2].autonomy = {.94, .93, .96};
    const Bounded s = spatial_autonomy(all);
    CHECK(s.value == .5);
    CHECK(s.low == .25);
    CHECK(s.high == .75);
}

TEST_CASE("a heat map as SVG and PNG") {
    TempFolder folder;
    View v = ramp(8760, .01);
    v.hours[0].dark = true;
    const std::string svg = folder.name("p.svg"), png = folder.name("p.png");
    write_plot(svg, {v}, .05);
    write_plot(png, {v, v}, .05);
    const std::string text = bytes_of(svg);
    CHECK(text.find("<svg") == 0);
    CHECK(text.find("url(#h)") != std::string::npos);
    CHECK(text.size() < 300000);
    CHECK(bytes_of(png).substr(1, 3) == "PNG");
    CHECK(error_text([&] { write_plot(folder.name("p.gif"), {v}, .05); }).find("plots are written to .svg or .png") !=
          std::string::npos);
}

TEST_CASE("single days are drawn as wide as they are apart, and the plot says so") {
    TempFolder folder;
    View v = ramp(24, .01);
    for (int i = 0; i < 24; ++i) v.hours[size_t(i)].time.date = weather::date_of(i < 12 ? 20 : 48);
    write_plot(folder.name("p.svg"), {v}, .05);
    const std::string text = bytes_of(folder.name("p.svg"));
    CHECK(text.find("days 28 apart") != std::string::npos);
    CHECK(text.find("h84v12") != std::string::npos);
}

TEST_CASE("Honeybee's folder: a row a view, a column an hour that is not dark, hours of the year") {
    TempFolder folder;
    View v = ramp(48, 0);
    v.name = "desk";
    for (int i = 0; i < 48; ++i) v.hours[size_t(i)].dark = i % 24 < 12;
    v.hours[47].time = {{2, 29}, 12.5};
    const std::string at = folder.name("hb");
    write_honeybee(at, {v, v});
    const std::string rows = bytes_of(at + "/views.dgp"), hours = bytes_of(at + "/sun-up-hours.txt");
    CHECK(std::count(rows.begin(), rows.end(), '\n') == 2);
    CHECK(std::count(rows.begin(), rows.end(), '\t') == 2 * 22);
    CHECK(std::count(hours.begin(), hours.end(), '\n') == 23);
    CHECK(hours.substr(0, 5) == "12.5\n");
    const std::string schedule = bytes_of(at + "/schedule.txt");
    CHECK(std::count(schedule.begin(), schedule.end(), '1') == 47);
    CHECK(schedule.size() == 2 * 8760);
    CHECK(bytes_of(at + "/grids_info.json").find("\"count\": 2") != std::string::npos);
    View w = v;
    w.hours.pop_back();
    w.name = "door";
    CHECK(error_text([&] { write_honeybee(at, {v, w}); }) == "door: does not have the hours of desk");
    for (const char* file : {"/views.dgp", "/sun-up-hours.txt", "/schedule.txt", "/grids_info.json"})
        std::remove((at + file).c_str());
    rmdir(at.c_str());
}
