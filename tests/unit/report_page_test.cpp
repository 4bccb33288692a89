// SPDX-License-Identifier: BSD-3-Clause
// Reports: numbers as vcmetrics prints them, names that are no markup, nothing from outside; SHA-256; rounding.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "base/sha256.h"
#include "base/split.h"
#include "report/page.h"
#include "report/page_about.h"
#include "report/table.h"
#include "report/verdict_words.h"

using report::Page;

namespace {

const double none = std::nan("");

Page sample() {
    Page page;
    page.view.type = 'a', page.view.vh = page.view.vv = 180;
    page.width = page.height = 64;
    page.title = "desk";
    page.numbers = {{"Ev", 2845.8159, 2842.2459, 2849.3859}, {"DGPf", .36175216, .35907203, .3644323}};
    page.drawings = {{"Luminance", "png"}};
    page.legend = {{"#000000", "#ffffff"}, {{0, "1"}, {1, "10"}}};
    return page;
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string verdict_of(double dgp, double low, double high) {
    Page page = sample();
    page.numbers = {{"DGP", dgp, low, high}};
    const std::string text = report::page_text(page);
    const size_t at = text.find("Glare is ");
    return at == std::string::npos ? "" : text.substr(at + 9, text.find('<', at) - at - 9);
}

}  // namespace

TEST_CASE("SHA-256 of the examples of FIPS 180-4, and of lengths around a block") {
    CHECK(base::sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    CHECK(base::sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    CHECK(base::sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
          "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    CHECK(base::sha256(std::string(1000000, 'a')) ==
          "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST_CASE("numbers are rounded by their interval, without powers of ten") {
    CHECK(report::rounded(2845.8159, 3.57) == "2845.8");
    CHECK(report::rounded(81609.7, none) == "81610");
    CHECK(report::rounded(.00039784, none) == "0.0003978");
    CHECK(report::rounded(1234567, 8900) == "1234600");
    CHECK(report::rounded(0, none) == "0");
    CHECK(report::with_error(2845.8159, 3.57) == "2845.8 +- 3.6");
}

TEST_CASE("a number stands as vcmetrics prints it beside what a person reads") {
    const std::string text = report::page_text(sample());
    CHECK(holds(text, "<data value=\"2845.8159\">2846</data>"));
    CHECK(holds(text, "<data value=\"2842.2459\">2842</data> to <data value=\"2849.3859\">2849</data>"));
    CHECK(holds(text, "Illuminance at the eye"));
}

TEST_CASE("the class is in words, and in two where the interval holds a limit") {
    CHECK(verdict_of(.34999, none, none) == "imperceptible");
    CHECK(verdict_of(.35, none, none) == "perceptible");
    CHECK(verdict_of(.40, none, none) == "disturbing");
    CHECK(verdict_of(.451, .4505, .452) == "intolerable");
    CHECK(verdict_of(.36, .349, .37) == "imperceptible to perceptible");
    CHECK(verdict_of(none, none, none) == "");
}

TEST_CASE("a class and what it means are in the words of the live page, and none where the interval holds three") {
    std::ifstream table(LUXPIPE_TESTS "/golden/verdicts.tsv");
    int rows = 0;
    for (std::string line; std::getline(table, line);) {
        if (line[0] == '#') continue;
        const std::vector<std::string> cells = base::split_list(line, '\t');
        const auto said = report::verdict_words(std::stod(cells[0]), std::stod(cells[1]), std::stod(cells[2]));
        CHECK((said.words.empty() ? "-" : said.words) == cells[3]);
        CHECK(said.people == (cells.size() > 4 ? cells[4] : ""));
        ++rows;
    }
    CHECK(rows == 7);
    CHECK(verdict_of(.38, .34, .41) == "");
}

TEST_CASE("a black picture has no class; what limits the numbers stands below the verdict") {
    Page page = sample();
    page.notes = {"DGP depends on the size of <pixels>."};
    CHECK(holds(report::page_text(page), "DGP depends on the size of &lt;pixels&gt;."));
    page.is_black = true;
    CHECK(holds(report::page_text(page), "The picture is black: it is night, "));
    CHECK(!holds(report::page_text(page), "Glare is "));
}

TEST_CASE("names from files are text: no markup, no control characters, no broken UTF-8") {
    const std::string hostile = "</style><script>alert(1)</script>\"'&\x1b[31m\xff <img src=http://evil/x>";
    Page page = sample();
    page.title = hostile;
    page.numbers.push_back({hostile + ".TAL", 1, none, none});
    page.outlines = {{hostile, {{{1, 1}, {2, 1}, {2, 2}}}, 1, 1, false}};
    page.sources = {{1, .5, 1e4, .01, 2, 30, {0, 1, 0}, hostile}};
    page.knows_objects = true;
    page.sky = {hostile};
    page.files = {{hostile, "00"}};
    page.commands = {hostile};
    page.header.lines = {hostile};
    page.header.fingerprint = hostile;
    page.version = hostile;
    page.drawings[0].caption = hostile;
    page.legend.ticks = {{.5, hostile}};
    const std::string text = report::page_text(page);
    CHECK(!holds(text, "<script"));
    CHECK(!holds(text, "<img"));
    CHECK(!holds(text, "\x1b"));
    CHECK(!holds(text, "\xff"));
    CHECK(holds(text, "&lt;script&gt;"));
    CHECK(holds(text, "&quot;&#39;&amp;"));
}

TEST_CASE("the hour of a sky's line in words, which way the eye looks, and where north is") {
    using report::hour_words;
    CHECK(hour_words({"sun: 16.8", "sky.rad: gensky 12 21 14 +s -a 42"}) == "21 December, 14:00");
    CHECK(hour_words({"gendaylit 3 1 9.25 -W 1 2"}) == "1 March, 9:15");
    CHECK(hour_words({"gensky 6 21 9:30"}) == "21 June, 9:30");
    CHECK(hour_words({"gensky 6 21 +12"}) == "21 June, 12:00 solar time");
    CHECK(hour_words({"gensky -ang 30 10", "gensky 13 1 9", "gensky 1 1 x"}) == "");
    Page page = sample();
    page.view.vd = {1, 0, -.1};
    page.sky = {"gensky 12 21 14 +s"};
    const std::string text = report::page_text(page);
    CHECK(holds(text, "The eye looks east (north"));
    CHECK(holds(text, "rotate(-90)"));
    CHECK(holds(text, "</svg>), on 21 December, 14:00.</p>"));
    page.view.vd = {0, .1, -1};
    page.sky.clear();
    CHECK(holds(report::page_text(page), "The eye looks down.</p>"));
}

TEST_CASE("a variant's lines have changes in words, and nothing of pixels") {
    Page page = sample();
    page.variants = {
        {"B", "png", {"Ev 17 (16 to 18)", "Ev.d -11 (-12 to -10)", "DGP.px .003", "DGP.px.d -.01", "odd"}}};
    CHECK(holds(report::page_text(page),
                "<b>B</b><br>Ev 17 (16 to 18)<br>Ev changed by -11 (-12 to -10)<br>odd</figcaption>"));
}

TEST_CASE("a picture is in the page by its bytes") {
    Page page = sample();
    for (const auto& [bytes, text] : {std::pair("M", "TQ=="), {"Ma", "TWE="}, {"Man", "TWFu"}, {"Many", "TWFueQ=="}}) {
        page.drawings[0].png = bytes;
        CHECK(holds(report::page_text(page), std::string("href=\"data:image/png;base64,") + text + "\"/>"));
    }
}

TEST_CASE("names that would cover one another stand in lines of their own") {
    Page page = sample();
    for (int k = 0; k < 5; ++k) page.outlines.push_back({"region", {}, 32, 32, false});
    std::istringstream text(report::page_text(page));
    std::vector<double> lines;
    for (std::string line; std::getline(text, line);)
        if (const size_t at = line.find(" y=\""); line.find("<text class=\"region\"") == 0)
            lines.push_back(std::stod(line.substr(at + 4)));
    REQUIRE(lines.size() == 5);
    for (size_t i = 0; i < 5; ++i)
        for (size_t k = 0; k < i; ++k) CHECK(std::fabs(lines[i] - lines[k]) > 1.9);  // the size of letters is 2
}
