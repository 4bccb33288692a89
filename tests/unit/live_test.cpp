// SPDX-License-Identifier: BSD-3-Clause
// The live view: pictures are found in passing bytes however these are cut, news is told once, strangers are kept out.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

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
#include "live/regions.h"
#include "temp_folder.h"

namespace {

using live::Which;

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
    live.put_line(Which::picture, "Ev");
    live.put_line(Which::picture, "1000");
    live.put_picture(Which::picture, small_picture(4, 3));
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
    live.put_picture(Which::picture, p);
    live.put_line(Which::picture, "a \"quoted\"\tline \x01\xff");
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
    const live::State state;
    const auto table = [&](const char* decades) {
        return live::answer_query(state, "/table", arguments({{"top", "1000"}, {"decades", decades}}));
    };
    CHECK(table("3").status == 200);
    CHECK(table("3").body.find("\"thresholds\":[") == 1);
    CHECK(table("-1").status == 400);
    CHECK(table("1e9").status == 400);
    for (const char* number : {"1e300", "-1", "nan", "4294967298", "x", "2.5"}) {
        const auto asked =
            arguments({{"top", "1000"}, {"divisions", number}, {"x", number}, {"y", "0"}, {"n", number}});
        CHECK_MESSAGE(live::answer_query(state, "/table", asked).status == 400, number);
        CHECK_MESSAGE(live::answer_query(state, "/pixel", asked).status == 404, number);
        live::State with_file;
        with_file.files.resize(1), with_file.now.texts.resize(1);
        CHECK_MESSAGE(live::answer_query(with_file, "/file", asked).status == 404, number);
    }
    CHECK(live::answer_query(state, "/table", arguments({})).status == 400);
    CHECK(live::answer_query(state, "/pixel", arguments({{"x", "1"}, {"y", "1"}})).status == 404);
    CHECK(live::answer_query(state, "/etc/passwd", arguments({})).status == 404);
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

TEST_CASE("a design as a text holds all of it, whatever is in the texts") {
    std::minstd_rand random(3);
    for (int trial = 0; trial < 300; ++trial) {
        const auto odd = [&] {
            std::string text;
            for (size_t n = random() % 12; n > 0; --n) text += "\t\n\n# a(\r"[random() % 8];
            return text;
        };
        live::State s;
        s.files = {{"r", live::TextFile::Kind::regions, true}, {"a b.rad"}, {"c.rad"}};
        s.now.texts.resize(3);
        const live::State empty = s;
        s.now.texts[0] = live::Text("desk circle 0 0 1 2\n");
        for (const size_t n : {1, 2})
            if (random() % 3) s.now.texts[n] = live::Text(odd());
        s.now.views = {" -vtv -vp 1 2 3"};
        s.now.places.emplace_back("desk 2", " -vta -vp 1 1 1");
        s.now.variants.push_back({"A", {live::Texts(3), " -vtv -vp 1 2 3"}});
        s.now.variants[0].look.texts[1] = live::Text(odd());
        s.results.push_back(
            {look_of(s, s.now.variants[0].look.texts, " -vtv -vp 1 2 3"), 3, nullptr, {"Ev 9 (8 to 10)"}});
        s.earlier = {"view"};
        s.edits = {{0, ""}, {1, "overlay blind.rad: 20 to 40"}, {2, "view design opened"}};
        std::string regions;
        const std::string text = design_text(s);
        live::State back = with_design(empty, text, "x.design", regions);
        for (size_t n = 1; n < 3; ++n) CHECK(back.now.texts[n] == s.now.texts[n]);
        CHECK(back.now.views == s.now.views);
        CHECK(back.now.places == s.now.places);
        CHECK(back.earlier == std::vector<std::string>{"view", "blind.rad: 20 to 40"});
        CHECK(result_of(back, back.now.variants[0].look)->numbers == std::vector<std::string>{"Ev 9 (8 to 10)"});
        CHECK(regions == "desk circle 0 0 1 2\n");
        back.now.texts[0] = live::Text(regions);
        CHECK(design_text(back) == text);
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
    live::Live live(files);
    int others = 0;
    for (int trial = 0; trial < 300; ++trial) {
        live::Request put{"/file", arguments({{"n", "0"}}), text, files[0].read().tag};
        put.put = true;
        const live::Answer answer = live.ask(put);
        others += answer.status == 200 && answer.tag != base::hash_of(text);
    }
    done = true;
    other.join();
    CHECK(others == 0);
}

TEST_CASE("a change whose file cannot be written has not happened") {
    TempFolder folder;
    live::Live live({{folder.holding("x.regions", "desk circle view 20\n"), live::TextFile::Kind::regions, true}});
    live::Request put{"/file", arguments({{"n", "0"}}), "desk circle\n", live.state().files[0].tag};
    put.put = true;
    CHECK(live.ask(put).status == 400);
    CHECK(live.state().undo.empty());
    CHECK(*live.state().now.texts[0] == "desk circle view 20\n");
}

TEST_CASE("rows of a table and of JSON are the same numbers by name") {
    std::vector<std::string> names;
    CHECK_FALSE(live::read_row(names, "frame\tseconds\tedit\tEv\terrors"));
    const auto row = live::read_row(names, "3\t.1\t2\t1000\tEv=1/2");
    REQUIRE(row);
    CHECK(row->frame() == 3);
    CHECK(row->edit() == 2);
    CHECK(row->of("Ev") == 1000);
    CHECK(std::isnan(row->of("errors")));
    CHECK_FALSE(live::read_row(names, "3\t.1"));
    CHECK(live::with_edit(names, "3\t.1\t2\t1000\t-", 7) == "3\t.1\t7\t1000\t-");
    const std::string object = R"({"frame": 3, "edit": 2, "Ev": 1e3, "tails": "a, \"b\"}", "x": null})";
    const auto same = live::read_row(names, object);
    REQUIRE(same);
    CHECK(same->edit() == 2);
    CHECK(same->of("Ev") == 1000);
    CHECK(std::isnan(same->of("x")));
    CHECK(live::with_edit(names, object, 7).find("\"edit\": 7, \"Ev\"") != std::string::npos);
    for (const char* odd : {"{", "{\"", "{\"a\"", "{\"a\": ", "{\"a\": \"", "{}", "", "\t", "{\"edit\": "})
        live::read_row(names, odd), live::with_edit(names, odd, 1);
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
    REQUIRE(file.write("desk circle view 20\n", "none"));
    const live::FileNow now = file.read();
    CHECK(now.text == "desk circle view 20\n");
    CHECK_FALSE(file.write("desk circle view 30\n", "none"));
    CHECK_THROWS_AS(file.write("desk circle\n", now.tag), base::Error);
    CHECK(file.read().tag == now.tag);
    CHECK(file.write("# none any more\n", now.tag));
    CHECK(live::region_outlines(file.read().text, file.path, small_picture(9, 7)) == "[]");
}
