// SPDX-License-Identifier: BSD-3-Clause
// The region file: what it means, and that every mistake names its line.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>
#include "base/error.h"
#include "base/edit_distance.h"
#include "region/region.h"

using namespace region;

namespace {
std::string error_of(const std::string& text) {
    try {
        parse(text, "f");
    } catch (const base::Error& e) {
        return e.text;
    }
    return "";
}
bool begins(const std::string& text, const std::string& with) { return text.compare(0, with.size(), with) == 0; }
}  // namespace

TEST_CASE("one region a line; indented lines continue it; # begins a comment") {
    Regions r = parse(
        "# a study\n\ndesk polygon3d 0 0 0  1 0 0\n   1 1 0  # the far corner\n\t0 1 0\nleft-eye_2 circle 0 1 0 30\n",
        "f");
    REQUIRE(r.regions.size() == 2);
    CHECK(r.regions[0].name == "desk");
    CHECK(r.shapes[0].numbers.size() == 12);
    CHECK(r.regions[1].place == "f:6");
    CHECK(r.regions[1].name == "left-eye_2");
}

TEST_CASE("a circle's bare numbers: three and an angle are a direction, two and an angle a pixel") {
    Regions r = parse(
        "a circle 0 1 -.5 30\nb circle 12 34 30\nc circle view 0.5rad\nd circle fraction .5 .5 20deg\ne circle point 1 "
        "2 3 4\n",
        "f");
    CHECK(r.shapes[0].frame == Frame::direction);
    CHECK(r.shapes[1].frame == Frame::pixel);
    CHECK(r.shapes[2].frame == Frame::view);
    CHECK(r.shapes[2].numbers[0] == doctest::Approx(28.64788975654116));
    CHECK(r.shapes[3].frame == Frame::fraction);
    CHECK(r.shapes[4].frame == Frame::point);
}

TEST_CASE("& binds before + and -, which go from left to right; parentheses and ! as usual") {
    Regions r = parse("a rect 0 0 1 1\nb rect 0 0 2 2\nc rect 0 0 3 3\nd a + b & c - !(a + c)\n", "f");
    const Node& minus = r.nodes[size_t(r.regions[3].root)];
    CHECK(minus.op == '-');
    CHECK(r.nodes[size_t(minus.a)].op == '+');
    CHECK(r.nodes[size_t(r.nodes[size_t(minus.a)].b)].op == '&');
    CHECK(r.nodes[size_t(minus.b)].op == '!');
}

TEST_CASE("scene queries take patterns and may be cut to a volume") {
    Regions r = parse("a surface top.* within box3d 0 0 0 1 1 1\nb modifier \"my wood\"\n", "f");
    CHECK(r.shapes[size_t(r.nodes[size_t(r.regions[0].root)].a)].within >= 0);
    CHECK(matches("top.*", "top.1540"));
    CHECK(matches("*a?c*", "xxabcabd"));
    CHECK_FALSE(matches("top", "top.1"));
    CHECK_FALSE(matches("a?c", "ac"));
}

TEST_CASE("mistakes name file and line") {
    CHECK(begins(error_of("desk polygon3d 0 0 0 1 0 0\n"), "f:1: polygon3d needs at least 3 points"));
    CHECK(begins(error_of("\na polygon3d 0 0 0 1 0 0 1 1 0 5\n"), "f:2: polygon3d has 10 numbers"));
    CHECK(begins(error_of("a circle 0 1 9\nb circle 0 1\n"), "f:2: circle needs"));
    CHECK(begins(error_of("a rect 0 0 1 x\n"), "f:1: rect needs 4 numbers; number 4 is \"x\""));
    CHECK(begins(error_of("a rect 0 0 1 1\na rect 0 0 1 1\n"), "f:2: region \"a\" is defined already (f:1)"));
    CHECK(begins(error_of("a b\n"), "f:1: \"b\" is neither a shape nor a region"));
    CHECK(begins(error_of("b a + c\na rect 0 0 1 1\n"), "f:1: \"a\" is neither"));  // only regions above
    CHECK(begins(error_of("a/b rect 0 0 1 1\n"), "f:1: \"a/b\" is not a region name"));
    CHECK(begins(error_of("rect 0 0 1 1\n"), "f:1: \"rect\" is the name of a shape"));
    CHECK(begins(error_of("  rect 0 0 1 1\n"), "f:1: an indented line"));
    CHECK(begins(error_of("a ( rect 0 0 1 1\n"), "f:1: a parenthesis"));
    CHECK(begins(error_of("a rect 0 0 1 1 &\n"), "f:1: the line ends"));
    CHECK(begins(error_of("a mask \"x.png\n"), "f:1: a quote"));
    CHECK(begins(error_of("a sphere3d 0 0 0 -1\n"), "f:1: the radius must be positive"));
    CHECK(begins(error_of("a circle 0 1 0 400\n"), "f:1: the angle"));
    CHECK(begins(error_of("a circle 0 0 0 40\n"), "f:1: the direction is zero"));
    CHECK(begins(error_of("a rect 0 0 inf 1\n"), "f:1: rect needs 4"));
    CHECK(begins(error_of("# nothing\n"), "f: holds no region"));
    CHECK(begins(error_of("a " + std::string(100000, '(')), "f:1: nested too deeply"));
    CHECK(begins(error_of("a " + std::string(100000, '!') + "b"), "f:1: nested too deeply"));
    std::string bomb = "r0 rect 0 0 1 1\n", chain = "r rect 0 0 1 1\ns r";
    for (int i = 1; i < 60; ++i)
        bomb += "r" + std::to_string(i) + " r" + std::to_string(i - 1) + " + r" + std::to_string(i - 1) + "\n";
    for (int i = 0; i < 200000; ++i) chain += " + r";
    CHECK(begins(error_of(bomb), "f:14: the region is made of more than"));
    CHECK(begins(error_of(chain), "f:2: the region is made of more than"));
    CHECK(begins(error_of(std::string(64, 'n') + " rect 0 0 1 1"), "f:1: "));
}

TEST_CASE("names that do not exist come with those a person may have meant") {
    CHECK(error_of("screen rect 0 0 1 1\nb sreen - screen\n").find("did you mean \"screen\"?") != std::string::npos);
    CHECK(error_of("a zone egorama\n").find("\"ergorama\"") != std::string::npos);
    CHECK(error_of("a circel 0 1 0 3\n").find("\"circle\"") != std::string::npos);
    CHECK(near_matches("top", {"top.1540", "leg.1540", "stand"}).find("top.1540") != std::string::npos);
    CHECK(near_matches("zzzz", {"top", "leg"}).empty());
}
