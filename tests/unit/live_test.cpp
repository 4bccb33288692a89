// SPDX-License-Identifier: BSD-3-Clause
// The live view: pictures are found in passing bytes however these are cut, news is told once, strangers are kept out.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <fcntl.h>
#include <sys/stat.h>

#include <atomic>
#include <cmath>
#include <fstream>
#include <random>
#include <thread>

#include "base/hash.h"
#include "image/stream.h"
#include "image_pictures.h"
#include "live/answers.h"
#include "live/design_file.h"
#include "live/framer.h"
#include "live/guard.h"
#include "live/json.h"
#include "live/live.h"
#include "live/pixel.h"
#include "live/plan.h"
#include "live/regions.h"
#include "temp_folder.h"

namespace {

// Two float pictures of different sizes, one after the other.
std::string stream() {
    return image::picture_bytes(small_picture(9, 7), image::Format::flt) +
           image::picture_bytes(small_picture(33, 2), image::Format::flt);
}

live::Arguments arguments(const std::vector<std::pair<std::string, std::string>>& given) {
    return [given](const char* name) {
        for (const auto& [key, value] : given)
            if (key == name) return value;
        return std::string();
    };
}

std::string text_of(const live::Answer& answer) {
    size_t length = 0;
    for (size_t k = 0; k < 4; ++k) length |= size_t((unsigned char)answer.body[k]) << 8 * k;
    return answer.body.substr(4, length);
}

}  // namespace

TEST_CASE("pictures are found whole, however the bytes are cut") {
    const std::string bytes = stream();
    std::minstd_rand random(7);
    for (int trial = 0; trial < 50; ++trial) {
        std::vector<image::Picture> found;
        live::Framer framer([&](image::Picture p) { found.push_back(std::move(p)); });
        for (size_t at = 0; at < bytes.size();) {
            const size_t n = std::min<size_t>(1 + random() % (trial < 5 ? 3 : 900), bytes.size() - at);
            framer.pass(bytes.data() + at, n);
            at += n;
        }
        REQUIRE(found.size() == 2);
        CHECK(found[0].width == 9);
        CHECK(found[1].height == 2);
        CHECK(found[0].rgb == small_picture(9, 7).rgb);
        CHECK(framer.stopped().empty());
    }
}

TEST_CASE("moments are passed over") {
    image::Picture p = small_picture(9, 7);
    p.moments = moments_of(p);
    const std::string one = image::picture_bytes(p, image::Format::flt), bytes = one + one;
    std::vector<image::Picture> found;
    live::Framer framer([&](image::Picture q) { found.push_back(std::move(q)); });
    for (size_t at = 0; at < bytes.size(); at += 100)
        framer.pass(bytes.data() + at, std::min<size_t>(100, bytes.size() - at));
    CHECK(framer.stopped().empty());
    REQUIRE(found.size() == 2);
    CHECK(found[1].rgb == p.rgb);
}

TEST_CASE("what is no float picture ends the looking, not the program") {
    for (const std::string& bytes :
         {image::picture_bytes(small_picture(9, 7), image::Format::rgbe), std::string("#?RADIANCE\n\n-Y 0 +X 4\n"),
          std::string("#?RADIANCE\nFORMAT=float\nNCOMP=3\nBigEndian=0\n\n-Y 40000 +X 40000\n"),
          std::string("#?RADIANCE\nFORMAT=float\nNCOMP=3\nBigEndian=0\n\n+X 4 -Y 4\n"), std::string(3 << 20, 'x')}) {
        int found = 0;
        live::Framer framer([&](const image::Picture&) { ++found; });
        framer.pass(bytes.data(), bytes.size());
        framer.pass(bytes.data(), bytes.size());
        CHECK(found == 0);
        CHECK_FALSE(framer.stopped().empty());
    }
}

TEST_CASE("news is told once: pictures, lines, the end") {
    live::Live live;
    CHECK_FALSE(live.since({}, false));
    live.put_line("Ev");
    live.put_line("1000");
    live.put_picture(small_picture(4, 3));
    auto news = live.since({0, 1, 0, 0}, false);
    REQUIRE(news);
    CHECK(news->lines == std::vector<std::string>{"1000"});
    CHECK(news->shown->width == 4);
    CHECK_FALSE(live.since(*news, false));
    live.put_end(4);
    REQUIRE(live.since(*news, false));
    CHECK(*live.since(*news, false)->ended == 4);
    CHECK_FALSE(live.since(*news, true));
    CHECK(live.since({99, 99, 99, 99}, false));  // of an earlier run: the end is news all the same
}

TEST_CASE("an answer holds its facts, then the pixels to the last bit") {
    live::Live live;
    const image::Picture p = small_picture(5, 4);
    live.put_picture(p);
    live.put_line("a \"quoted\"\tline \x01\xff");
    const auto answer = live::answer_next(live, arguments({{"picture", "0"}, {"line", "-3"}}));
    REQUIRE(answer);
    const std::string text = text_of(*answer);
    CHECK(text.find("\"width\":5,\"height\":4") != std::string::npos);
    CHECK(text.find("\"a \\\"quoted\\\"\\tline ??\"") != std::string::npos);
    const std::string pixels = answer->body.substr(4 + text.size());
    CHECK(pixels == std::string(reinterpret_cast<const char*>(p.rgb.data()), p.rgb.size() * sizeof(float)));
    CHECK_FALSE(live::answer_next(live, arguments({{"picture", "1"}, {"line", "1"}, {"design", "1"}})));
}

TEST_CASE("tables are those of the pictures on disk; questions that mean nothing are refused") {
    const live::Live live;
    const auto table = [&](const char* decades) {
        return live::answer_query(live, {}, "/table", arguments({{"top", "1000"}, {"decades", decades}}));
    };
    CHECK(table("3").status == 200);
    CHECK(table("3").body.find("\"thresholds\":[") == 1);
    CHECK(table("-1").status == 400);
    CHECK(table("1e9").status == 400);
    for (const char* number : {"1e300", "-1", "nan", "4294967298", "x", "2.5"}) {
        const auto asked =
            arguments({{"top", "1000"}, {"divisions", number}, {"x", number}, {"y", "0"}, {"n", number}});
        CHECK_MESSAGE(live::answer_query(live, {}, "/table", asked).status == 400, number);
        CHECK_MESSAGE(live::answer_query(live, {}, "/pixel", asked).status == 404, number);
        const live::Files files(1, live::TextFile("x", live::TextFile::Kind::regions, true));
        CHECK_MESSAGE(live::named(files, asked) == nullptr, number);
    }
    CHECK(live::answer_query(live, {}, "/table", arguments({})).status == 400);
    CHECK(live::answer_query(live, {}, "/pixel", arguments({{"x", "1"}, {"y", "1"}})).status == 404);
    CHECK(live::answer_query(live, {}, "/etc/passwd", arguments({})).status == 404);
}

TEST_CASE("a pixel's facts") {
    image::Picture p = small_picture(8, 8);
    CHECK(live::pixel_facts(p, 8, 0).empty());
    CHECK(live::pixel_facts(p, 0, -1).empty());
    p.header.view.reset();
    CHECK(live::pixel_facts(p, 0, 0).find("direction") == std::string::npos);
    p.header.view = view::View();
    p.header.view->type = 'a';
    p.header.view->vh = p.header.view->vv = 180;
    // the view looks along +y; pixel (3, 4) lies left of the line of sight and below it
    const std::string facts = live::pixel_facts(p, 3, 4);
    CHECK(facts.find("\"direction\":[-0.19") != std::string::npos);
    CHECK(facts.find("\"omega\":0.1") != std::string::npos);
}

TEST_CASE("only this machine's names, only our own pages, only those who know the token") {
    for (const char* host : {"localhost", "localhost:8080", "127.0.0.1:1", "[::1]", "[::1]:80"})
        CHECK(live::is_loopback_host(host));
    for (const char* host : {"", "evil.com", "localhost.evil.com", "127.0.0.1.evil.com:80", "localhost:", "localhost:x",
                             "localhost:123456", "[::1]x", "localhost:80@evil.com"})
        CHECK_FALSE(live::is_loopback_host(host));
    CHECK(live::is_own_origin("", "localhost:1"));
    CHECK(live::is_own_origin("http://localhost:1", "localhost:1"));
    CHECK_FALSE(live::is_own_origin("http://evil.com", "localhost:1"));
    CHECK_FALSE(live::is_own_origin("null", "localhost:1"));
    const std::string token = live::new_token();
    CHECK(token.size() == 32);
    CHECK(token != live::new_token());
    CHECK(live::same_secret(token, token));
    CHECK_FALSE(live::same_secret(token, token.substr(1)));
    CHECK_FALSE(live::same_secret("", token));
}

TEST_CASE("the design: changes of texts by version, undone one by one; a drag is one") {
    live::Design d;
    d.texts.resize(2);
    d.change(1, "a", false);
    d.change(1, "b", true);
    d.change(1, "c", true);
    d.obey("go\n");
    d.change(1, "d", false);
    CHECK(d.texts[1].version == 4);
    CHECK(d.texts[0].version == 0);
    for (const char* want : {"c", "a"}) {
        d.undo(1);
        CHECK(d.texts[1].now == want);
    }
    d.undo(1);
    CHECK_FALSE(d.texts[1].now);
    const size_t version = d.texts[1].version;
    d.undo(1);  // there is nothing more
    CHECK(d.texts[1].version == version);
    d.change(1, "e", false);
    d.replaced(1, "of an editor");  // which counts; what was typed here comes back by Undo
    CHECK_FALSE(d.texts[1].now);
    d.undo(1);
    CHECK(d.texts[1].now == "e");
    d.replaced(1, "e");  // saved: as it was typed
    CHECK(d.texts[1].before.size() == 1);
}

TEST_CASE("the design: edits, views and messages") {
    live::Live live;
    image::Picture p = small_picture(2, 2);
    const auto come = [&](int64_t edit, const char* what, double x) {
        p.header.edit = edit;
        p.header.edited = what;
        p.header.view->vp = {x, 0, 0};
        live.put_picture(p);
    };
    come(0, "start", 0);
    live.change([](live::Design& d) { d.tell("ptrace: a \"word\""); });
    come(1, "preview", 5);
    come(2, "view", 1);
    come(3, "overlay blind.rad: 20 to 40", 1);
    CHECK(live.ask([](const live::Design& d) { return d.views.size(); }) == 2);
    const auto current = [&] { return live.ask([](const live::Design& d) { return d.current; }); };
    CHECK(current() == 0);
    live.change([](live::Design& d) { d.tell("ptrace: blind.rad:1: broken"); });
    live.change([](live::Design& d) { CHECK(d.back()); });
    come(3, "overlay blind.rad: 20 to 40", 1);  // a late one of the view that was left
    come(4, "view", 0);
    CHECK(current() == 1);  // the files are as broken as before
    come(5, "scene", 0);
    live.ask([](const live::Design& d) {
        CHECK(d.views.size() == 1);
        CHECK(d.edits.size() == 5);
        CHECK(d.current == 0);
        CHECK(d.messages.size() == 2);
        return 0;
    });
    CHECK_FALSE(live.ask([](const live::Design& d) { return live::Design(d).back(); }));
    const auto answer = live::answer_next(live, arguments({{"picture", "9"}, {"design", "0"}}));
    REQUIRE(answer);
    const std::string text = text_of(*answer);
    CHECK(text.find("[3,\"overlay blind.rad: 20 to 40\"]") != std::string::npos);
    CHECK(text.find("\"messages\":[\"ptrace: a \\\"word\\\"\","
                    "\"ptrace: blind.rad:1: broken\"],\"current\":0,\"paused\":false") != std::string::npos);
    live.change([](live::Design& d) { d.obey("view -vp 1 1 1\npause\n"); });
    CHECK(live.ask([](const live::Design& d) { return d.paused; }));
}

TEST_CASE("Undo takes back at once what a variant has changed, its view, too") {
    live::Live live;
    live.change([](live::Design& d) { d.texts.resize(2); });
    image::Picture p = small_picture(2, 2);
    const auto come = [&](int64_t edit, double x) {
        p.header.edit = edit;
        p.header.view = view::View{};
        p.header.view->vp.x = x;
        live.put_picture(p);
    };
    const auto joined = [&] {
        std::vector<bool> all;
        for (const auto& s : live.ask([](const live::Design& d) { return d.steps; })) all.push_back(s.joined);
        return all;
    };
    come(0, 0);
    live.change([](live::Design& d) { d.keep("A"), d.change(0, "a", false), d.change(1, "b", true); });
    come(1, 1);
    CHECK(joined() == std::vector<bool>{false, false, false});
    live.change([](live::Design& d) { d.show(*d.variant("A")); });
    come(2, 0);
    CHECK(joined() == std::vector<bool>{false, false, false, false, true, true});
    live.change([](live::Design& d) { d.show(*d.variant("A")); });  // it is there already
    come(3, 1);
    CHECK(joined().back() == false);
}

TEST_CASE("a variant has the edit that shows it with most frames, and a change of that is news") {
    live::Live live;
    live.change([](live::Design& d) { d.texts.resize(1); });
    image::Picture p = small_picture(2, 2);
    const auto come = [&](int64_t edit, const char* what, int64_t frames) {
        p.header.edit = edit;
        p.header.edited = what;
        p.header.frames = frames;
        live.put_picture(p);
        return live.numbers().design;
    };
    const auto edit = [&] { return live.ask([](const live::Design& d) { return d.variants[0].edit; }); };
    come(0, "start", 8);
    come(1, "overlay a", 0);
    live.change([](live::Design& d) { d.keep("A"); });
    CHECK(edit() == 1);
    const auto before = come(2, "overlay a", 0);
    CHECK(edit() == 1);
    CHECK(come(2, "overlay a", 1) > before);
    CHECK(edit() == 2);
    const auto after = come(2, "overlay a", 2);
    CHECK(come(2, "overlay a", 3) == after);

    // a view that comes while a text is broken shows the text before it
    live.change([](live::Design& d) { d.change(0, "broken", false), d.tell("ptrace: a.rad:1: broken"); });
    come(3, "view", 9);
    live.change([](live::Design& d) { d.keep("B"), d.undo(0), d.keep("C"); });
    live.ask([](const live::Design& d) {
        CHECK(d.variants[1].edit == -1);
        CHECK(d.variants[2].edit == 3);
        return 0;
    });
}

TEST_CASE("a design as a text holds all of it, whatever is in the texts") {
    using live::TextFile;
    const live::Files files{{"r", TextFile::Kind::regions, true},
                            {"a b.rad", TextFile::Kind::scene, true},
                            {"c.rad", TextFile::Kind::scene, true}};
    std::minstd_rand random(3);
    for (int trial = 0; trial < 300; ++trial) {
        const auto odd = [&] {
            std::string text;
            for (size_t n = random() % 12; n > 0; --n) text += "\t\n\n# a(\r"[random() % 8];
            return text;
        };
        live::Design d;
        d.texts.resize(3);
        for (const size_t n : {1, 2})
            if (random() % 3) d.texts[n].now = odd();
        d.views = {" -vtv -vp 1 2 3"};
        d.places.emplace_back("desk 2", " -vta -vp 1 1 1");
        d.earlier = {"view"};
        d.edits = {{0, ""}, {1, "overlay blind.rad: 20 to 40"}, {2, "view design opened"}};
        std::string regions;
        const std::string text = design_text(d, files, "desk circle 0 0 1 2\n");
        const live::Design back = live::read_design(text, "x.design", files, regions);
        for (size_t n = 0; n < 3; ++n) CHECK(back.texts[n].now == d.texts[n].now);
        CHECK(back.views == d.views);
        CHECK(back.places == d.places);
        CHECK(back.earlier == std::vector<std::string>{"view", "blind.rad: 20 to 40"});
        CHECK(regions == "desk circle 0 0 1 2\n");
        CHECK(design_text(back, files, regions) == text);
    }
}

TEST_CASE("the tag of an answer is of what was written, though another program appends at this moment") {
    TempFolder folder;
    const std::string text = "desk circle view 20\n";
    const live::Files files{{folder.holding("x.regions", text), live::TextFile::Kind::regions, true}};
    std::atomic<bool> done{false};
    std::thread other([&] {
        while (!done) std::ofstream(files[0].path, std::ios::app) << "# by hand\n";
    });
    live::Live live;
    int others = 0;
    for (int trial = 0; trial < 300; ++trial) {
        const live::Answer answer = live::answer_put(live, files, arguments({{"n", "0"}}), text, files[0].read().tag);
        others += answer.status == 200 && answer.tag != base::hash_of(text);
    }
    done = true;
    other.join();
    CHECK(others == 0);
}

TEST_CASE("JSON of numbers") {
    CHECK(live::json::number(.1) == "0.1");
    CHECK(live::json::number(std::nan("")) == "null");
    CHECK(live::json::numbers({1, 2.5}) == "[1,2.5]");
}

TEST_CASE("a file is written only over the state that its writer has read, and regions only if they can be read") {
    TempFolder folder;
    const live::TextFile file(folder.name("x.regions"), live::TextFile::Kind::regions, true);
    CHECK(file.read().tag == "none");
    REQUIRE(file.write("desk circle view 20\n", "none").has_value());
    const live::FileNow now = file.read();
    CHECK(now.text == "desk circle view 20\n");
    CHECK_FALSE(file.write("desk circle view 30\n", "none").has_value());
    CHECK_THROWS_AS(file.write("desk circle\n", now.tag), base::Error);
    CHECK(file.read().tag == now.tag);
    CHECK(file.write("# none any more\n", now.tag).has_value());
    CHECK(live::region_outlines(file.read().text, file.path, small_picture(9, 7)) == "[]");
}

namespace {

// A FIFO and what has been written to it, or is.
struct Fifo {
    explicit Fifo(std::string name) : path(std::move(name)) {
        REQUIRE(mkfifo(path.c_str(), 0600) == 0);
        fd = open(path.c_str(), O_RDWR | O_NONBLOCK);
    }
    ~Fifo() { close(fd); }
    void send(const std::string& text) const { REQUIRE(write(fd, text.data(), text.size()) == ssize_t(text.size())); }
    std::string read() const {
        char block[1000];
        const ssize_t n = ::read(fd, block, sizeof block);
        return n > 0 ? std::string(block, size_t(n)) : "";
    }
    std::string path;
    int fd;
};

}  // namespace

TEST_CASE("a plan rests until the picture of a change has four frames, and then has the texts of the page") {
    TempFolder folder;
    const Fifo control(folder.name("control")), lines(folder.name("lines"));
    const live::Files files{{folder.holding("a.rad", ""), live::TextFile::Kind::scene, true}};
    const live::PlanOptions options{control.path, lines.path, folder.name("sum.exr"), {}};
    live::Live page;
    page.change([](live::Design& d) { d.texts.resize(1); });
    live::Plan plan(options, files, page);
    const auto picture = [&](int64_t edit, int64_t frames) {
        image::Picture p = small_picture(2, 2);
        p.header.edit = edit, p.header.frames = frames;
        page.put_picture(p);
        plan.look();
    };
    const auto says = [&](const std::string& words) {
        return page.ask([](const live::Design& d) { return d.plan; }).find(words) != std::string::npos;
    };
    plan.look();
    picture(0, 3);
    CHECK(control.read().empty());
    picture(0, 4);
    CHECK(control.read() == "go\n");
    page.change([](live::Design& d) { d.change(0, "new", false); });
    plan.look(true);
    CHECK(control.read() == "pause\n");
    CHECK(says("\"waits\":true"));
    picture(0, 9);
    picture(1, 3);
    CHECK(control.read().empty());
    picture(1, 4);
    CHECK(control.read() == "go\noverlay " + files[0].path + " 3\nnewwhat .5 .5\n");
    CHECK(says("\"waits\":true"));
    lines.send("ptrace: what .5 .5\t7\t\nptrace: x.pts:2: said once\nptrace: x.pts:2: said once\n");
    plan.look();
    CHECK(says("\"edit\":7,\"waits\":false"));
    CHECK(page.ask([](const live::Design& d) { return d.messages.size(); }) == 1);
    page.change([](live::Design& d) { d.paused = true; });
    plan.look();
    CHECK(control.read() == "pause\n");

    CHECK(says("{\"number\":0,\"limit\":300,"));
    folder.holding("sum.exr", "a sum");
    plan.look();
    CHECK(says("{\"number\":1,"));
    CHECK(plan.limit("500").status == 204);
    CHECK(says("{\"number\":2,\"limit\":500,"));
    for (const char* wrong : {"", "0", "-1", "nan", "1e9", "5 6"}) CHECK(plan.limit(wrong).status == 400);
}
