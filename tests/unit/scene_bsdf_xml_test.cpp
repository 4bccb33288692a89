// SPDX-License-Identifier: BSD-3-Clause
// The reader of BSDF files: sides, order of values, angle bases, trees, units, colour; and one line for what is broken.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include "base/error.h"
#include "scene/bsdf_xml.h"
#include "unit/bsdf_text.h"

using scene::Bsdf;
using scene::parse_bsdf;

// Two rings of 1 and 2 patches: three cells, so matrices are short.
static const char* three_cells =
    "<AngleBasis><AngleBasisName>three</AngleBasisName>"
    "<AngleBasisBlock><Theta>0</Theta><nPhis>1</nPhis><ThetaBounds><LowerTheta>0</LowerTheta><UpperTheta>30</"
    "UpperTheta>"
    "</ThetaBounds></AngleBasisBlock>"
    "<AngleBasisBlock><Theta>60</Theta><nPhis>2</nPhis><ThetaBounds><LowerTheta>30</LowerTheta><UpperTheta>90</"
    "UpperTheta>"
    "</ThetaBounds></AngleBasisBlock></AngleBasis>";

static std::string error_of(const std::string& text) {
    try {
        parse_bsdf(text, "a.xml");
    } catch (const base::Error& e) {
        return e.what();
    }
    return "no error";
}

TEST_CASE("a file's columns are incident directions, its rows leave") {
    const std::string block = bsdf_block("Transmission Back", "1 2 3\n4,5,6\n 7,8,9,", "three");
    const Bsdf columns = parse_bsdf(bsdf_file("Columns", block, three_cells), "a.xml");
    const auto& t = columns.transmission[0];
    REQUIRE(t.present);
    CHECK(columns.bases[t.incident].cells() == 3);
    CHECK(t.y == std::vector<float>{1, 4, 7, 2, 5, 8, 3, 6, 9});  // incident * cells + exit
    const Bsdf rows = parse_bsdf(bsdf_file("Rows", block, three_cells), "a.xml");
    CHECK(rows.transmission[0].y == std::vector<float>{1, 2, 3, 4, 5, 6, 7, 8, 9});
}

TEST_CASE("the files' Back is the side of the surface normal") {
    const std::string one = "1 1 1 1 1 1 1 1 1", two = "2 2 2 2 2 2 2 2 2";
    const Bsdf b = parse_bsdf(
        bsdf_file("Columns",
                  bsdf_block("Reflection Back", one, "three") + bsdf_block("Reflection Front", two, "three") +
                      bsdf_block("Transmission Front", two, "three"),
                  three_cells),
        "a.xml");
    CHECK(b.reflection[0].y[0] == 1);
    CHECK(b.reflection[1].y[0] == 2);
    CHECK(!b.transmission[0].present);
    CHECK(b.transmission[1].present);
}

TEST_CASE("Klems' bases have 145, 77 and 41 patches") {
    const Bsdf b = parse_bsdf(bsdf_file("Columns", bsdf_block("Reflection Back", bsdf_numbers(41 * 41, 1))), "a.xml");
    REQUIRE(b.bases.size() == 3);
    CHECK(b.bases[0].cells() == 145);
    CHECK(b.bases[1].cells() == 77);
    CHECK(b.bases[2].cells() == 41);
    CHECK(b.bases[b.reflection[0].incident].name == "LBNL/Klems Quarter");
}

TEST_CASE("values below zero count as zero, other wavelengths are left out") {
    const Bsdf b = parse_bsdf(bsdf_file("Columns",
                                        bsdf_block("Reflection Back", "-1 2 3 4 5 6 7 8 9", "three") +
                                            bsdf_block("Reflection Back", "not read", "three", "Solar"),
                                        three_cells),
                              "a.xml");
    CHECK(b.reflection[0].y[0] == 0);
    CHECK(b.reflection[0].x.empty());
}

TEST_CASE("colour needs X and Z beside Y") {
    const std::string n = "1 1 1 1 1 1 1 1 1", y = bsdf_block("Reflection Back", n, "three");
    const std::string x = bsdf_block("Reflection Back", n, "three", "CIE-X"),
                      z = bsdf_block("Reflection Back", n, "three", "CIE-Z");
    CHECK(parse_bsdf(bsdf_file("Columns", x + y + z, three_cells), "a.xml").reflection[0].x.size() == 9);
    CHECK(parse_bsdf(bsdf_file("Columns", x + y, three_cells), "a.xml").reflection[0].x.empty());
}

TEST_CASE("lengths are metres") {
    const Bsdf b =
        parse_bsdf(bsdf_file("Columns", bsdf_block("Reflection Back", "1 1 1 1 1 1 1 1 1", "three"), three_cells,
                             "<Name>p</Name><Thickness unit=\"Millimeter\">6</Thickness><Width unit=\"foot\">2</Width>"
                             "<Height unit=\"Meter\"> 1.5 </Height>"),
                   "a.xml");
    CHECK(b.thickness == doctest::Approx(.006));
    CHECK(b.width == doctest::Approx(.6096));
    CHECK(b.height == 1.5);
}

// Bit k of a child is the upper half of dimension k; a leaf's grid has dimension 0 slowest.
TEST_CASE("branches and leaf grids of a tensor tree name the same cells") {
    const Bsdf b = parse_bsdf(bsdf_file("TensorTree3", bsdf_block("Reflection Back", "{0 1 2 3 4 5 6 7}")), "a.xml");
    const Bsdf c =
        parse_bsdf(bsdf_file("TensorTree3", bsdf_block("Reflection Back", "{{0}{4}{2}{6}{1}{5}{3}{7}}")), "a.xml");
    CHECK(b.reflection[0].tree.depth == 1);
    CHECK(b.reflection[0].tree.value == c.reflection[0].tree.value);
    CHECK(b.reflection[0].tree.child == c.reflection[0].tree.child);
}

TEST_CASE("a broken file is one line that names it") {
    const auto three = [](const std::string& data, const std::string& basis = "three",
                          const std::string& direction = "Reflection Back") {
        return bsdf_file("Columns", bsdf_block(direction, data, basis), three_cells);
    };
    const auto tree = [](const std::string& data) {
        return bsdf_file("TensorTree3", bsdf_block("Reflection Back", data));
    };
    CHECK(error_of("").find("a.xml:1: XML: ") == 0);
    CHECK(error_of("not xml").find("a.xml") == 0);
    CHECK(error_of(three("1 2").substr(0, 300)).find("a.xml:2: XML: ") == 0);
    CHECK(error_of("<a/>") == "a.xml: not a BSDF file: no <WindowElement>");
    CHECK(error_of("<WindowElement/>") == "a.xml: no <Layer> in <Optical>");
    CHECK(error_of(bsdf_file("Columns", "")) == "a.xml: no scattering data for visible light");
    CHECK(error_of(bsdf_file("Diagonals", bsdf_block("Reflection Back", "1"))) ==
          "a.xml: unknown <IncidentDataStructure> \"Diagonals\"");
    CHECK(error_of(three("1 2 3")) == "a.xml: Reflection Back: 3 scattering values where 3 x 3 are expected");
    CHECK(error_of(three("1 2 3 4 5 6 7 8 9 10")) == "a.xml: Reflection Back: more than 3 x 3 scattering values");
    CHECK(error_of(three("1 2 3 4 five")) == "a.xml: Reflection Back: \"five\" is not a number");
    CHECK(error_of(three("1 2 3 4 nan")) == "a.xml: Reflection Back: \"nan\" is not a number");
    CHECK(error_of(three("1", "four")) == "a.xml: Reflection Back: unknown angle basis \"four\"");
    CHECK(error_of(three("1", "three", "Sideways")) == "a.xml: unknown <WavelengthDataDirection> \"Sideways\"");
    CHECK(error_of(tree("")) == "a.xml: Reflection Back: a tensor tree lacks an opening brace");
    CHECK(error_of(tree("{1")) == "a.xml: Reflection Back: scattering data end too early");
    CHECK(error_of(tree("{{1}{1}}")) == "a.xml: Reflection Back: a tensor tree lacks an opening brace");
    CHECK(error_of(tree("{1 2 3}")) ==
          "a.xml: Reflection Back: a leaf of a tensor tree has 3 values, which fill no grid of 3 dimensions");
    CHECK(error_of(tree("{1} 2")) == "a.xml: Reflection Back: more scattering data than the tensor tree holds");
    CHECK(error_of(tree(std::string(100000, '{'))) == "a.xml: Reflection Back: a tensor tree is deeper than 12 levels");
    CHECK(error_of(bsdf_file("Columns", "", "", "<Thickness unit=\"cubit\">1</Thickness>")) ==
          "a.xml: unknown unit \"cubit\" of <Thickness>");
    std::string gap = three_cells;
    gap.replace(gap.find("<LowerTheta>30"), 14, "<LowerTheta>40");
    CHECK(error_of(bsdf_file("Columns", "", gap)) == "a.xml: rings of angle basis \"three\" do not join");
    std::string many = three_cells;
    many.replace(many.find("<nPhis>2<"), 9, "<nPhis>999999999<");
    CHECK(error_of(bsdf_file("Columns", "", many)) == "a.xml: angle basis \"three\" has a ring of 1e+09 patches");
    CHECK_THROWS_AS(scene::read_bsdf("/nonexistent/a.xml"), base::Error);
}

// Whatever is cut off a good file, the reader answers by a table or by an Error.
TEST_CASE("every beginning of a file is read or refused") {
    std::mt19937 random(5);
    const std::string good = bsdf_file("TensorTree4", bsdf_block("Reflection Back", bsdf_tree(4, 2, random)));
    for (size_t n = 0; n < good.size(); n += 7) CHECK(error_of(good.substr(0, n)) != "no error");
    CHECK(error_of(good) == "no error");
}
