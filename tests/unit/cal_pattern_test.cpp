// SPDX-License-Identifier: BSD-3-Clause
// Textures, patterns and mixtures as programs: RADIANCE's values, text layout, spectra, materials' functions, bad
// input.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>
#include <cstdio>
#include "base/vec.h"
#include "cal/tables.h"
#include "unit/cal_pattern_rows.h"

using namespace cal;

// Outputs of a program; empty if it ended with an error.
static std::vector<float> run(const Code& code, uint32_t entry, int outputs, const std::vector<float>& vars) {
    device::SceneTables tables{};
    tables.u = code.words.data();
    tables.f = code.floats.data();
    float out[CAL_OUTPUTS] = {};
    if (device::cal_run(&tables, entry, vars.data(), out)) return {};
    return std::vector<float>(out, out + outputs);
}

static std::vector<float> pattern(const PatternSpec& spec, const std::vector<float>& vars) {
    Library library(golden_files());
    Code code;
    const Program p = compile_pattern(library, spec, code);
    return run(code, p.entry, p.outputs, vars);
}

static std::string trouble(const std::string& type, std::vector<std::string> strings, std::vector<double> reals = {}) {
    try {
        const float p[3] = {0, 0, 0};
        pattern({type, std::move(strings), std::move(reals), "a.rad:3", {}}, golden_vars(p));
    } catch (const base::Error& e) {
        return e.what();
    }
    return "no error";
}

static std::string temporary(const char* name, const std::string& text) {
    const std::string path = std::string("cal_pattern_test.") + name;
    FILE* f = std::fopen(path.c_str(), "wb");
    REQUIRE(f);
    std::fwrite(text.data(), 1, text.size(), f);
    std::fclose(f);
    return "./" + path;
}

TEST_CASE("patterns, textures and mixtures have RADIANCE's values") {
    int rows = 0;
    for (const PatternRow& r : pattern_rows("cal_patterns.tsv", false)) {
        std::vector<float> got = pattern(r.spec, r.vars);
        if (got.empty()) got.assign(r.want.size(), 1.0f);  // an error: no pattern
        if (r.spec.type.compare(0, 3, "tex") == 0) {
            const base::Vec3 sun = base::unit({0.3094263739, 0.2062842493, 0.9282791216});
            got = {float(base::dot(base::unit({got[0], got[1], 1 + got[2]}), sun) / sun.z)};
        }
        REQUIRE(got.size() == r.want.size());
        for (size_t k = 0; k < got.size(); k++) {
            // RADIANCE's flat spectrum is 4e-4 off, and negative light is black
            const double slack = r.id == "spec_flat5" ? 4e-4 : std::fmax(2e-5, 2e-4 * std::fabs(r.want[k]));
            CHECK_MESSAGE(std::fabs(std::fmax(0, got[k]) - r.want[k]) <= slack, r.id, ": ", got[k], ", RADIANCE ",
                          r.want[k]);
        }
        rows++;
    }
    CHECK(rows >= 70);
}

TEST_CASE("gensky's and gendaylit's skies have RADIANCE's values") {
    int rows = 0;
    for (const PatternRow& r : pattern_rows("cal_skies.tsv", true)) {
        const std::vector<float> got = pattern(r.spec, r.vars);
        REQUIRE(got.size() == 1);
        CHECK_MESSAGE(got[0] == doctest::Approx(r.want[0]).epsilon(1e-4), r.id);
        rows++;
    }
    CHECK(rows == 53);
}

TEST_CASE("library files: luminaires, meshes, glazings have RADIANCE's values") {
    const float p[3] = {0.3f, 0.7f, 0.2f};
    int rows = 0;
    for (const PatternRow& r : pattern_rows("cal_library.tsv", false)) {
        const std::vector<float> got = pattern(r.spec, golden_vars(p));
        REQUIRE(got.size() == 1);
        CHECK_MESSAGE(four_digits(got[0], r.want[0]), r.id, ": ", got[0], ", RADIANCE ", r.want[0]);
        rows++;
    }
    CHECK(rows > 70);
}

// The example of the text chapter: A 64..192, B 32..224, I 112..144, mean width 117.
TEST_CASE("characters are placed evenly, squeezed and proportionally") {
    const Font font = read_font(LUXPIPE_TESTS "/golden/cal/tri2.fnt", "test");
    CHECK(font.mean_width == 117);
    CHECK(text_advances(font, "AB I A", 51) == std::vector<int>{-14, 215, 254, 35, 174, 83, 247});
    CHECK(text_advances(font, "AB I A", -51) == std::vector<int>{-14, 210, 249, 30, 169, 78, 242});
    CHECK(text_advances(font, "AB I A", 127) == std::vector<int>{62, 316, 317, 98, 237, 147, 349});
    CHECK(text_advances(font, "AzA", 0) == std::vector<int>{0, 255, 0, 255});
}

// 1 + nm/1000 in four notations.  RADIANCE 6.0a (rtrace with specfunc, which draws its wavelengths at random) gives
// 1.6318 1.5481 1.4372 and 1.6338 1.5417 1.4387 in two tries.
TEST_CASE("spectra become RGB by the colour matching functions") {
    const float p[3] = {0, 0, 0};
    const std::vector<double> want{1.6324, 1.5437, 1.4362};
    const std::string file = temporary("spec.dat", "1\n300 900 3\n1.3 1.6 1.9\n");
    const std::string plane = temporary("plane.dat", "2\n0 1 2\n300 900 2\n1.3 1.9\n1.3 1.9\n");
    std::vector<double> steps{380, 780};
    for (int nm = 380; nm <= 780; nm += 20) steps.push_back(1 + nm / 1000.0);
    for (const PatternSpec& spec :
         {PatternSpec{"specfile", {file}, {}, "t", {}}, PatternSpec{"spectrum", {}, steps, "t", {}},
          PatternSpec{"specfunc", {"ramp", "ramp.cal"}, {380, 780}, "t", {}},
          PatternSpec{"specdata", {"noop", plane, ".", "Px"}, {}, "t", {}}}) {
        temporary("ramp.cal", "ramp(nm) = 1 + nm/1000;");
        PatternSpec s = spec;
        if (s.type == "specfunc") s.strings[1] = "./cal_pattern_test.ramp.cal";
        const std::vector<float> got = pattern(s, golden_vars(p));
        REQUIRE(got.size() == 3);
        for (size_t k = 0; k < 3; k++) CHECK_MESSAGE(got[k] == doctest::Approx(want[k]).epsilon(1e-3), spec.type);
    }
}

// six_bands.hsr: written by rtrace 6.0a (-cs 6 -co+ -fac), and its values as a specpict there.  RADIANCE shares
// wavelengths out to bands by whole nanometres, about one too many at the long end: by up to 4 % of a channel other
// values.
TEST_CASE("a hyperspectral picture becomes RGB band by band") {
    const double rows[5][5] = {{.0001, .0001, .7681941, .2492308, .2047894},
                               {1.3332, .999, .8310944, .2687789, .2219432},
                               {.4444, .5, .7127634, .2305959, .1919014},
                               {.7, .3, .8899369, .2881215, .2389044},
                               {.1667, .1667, .7632407, .2467589, .2040448}};
    for (const auto& r : rows) {
        const float p[3] = {float(r[0]), float(r[1]), 0};
        const std::vector<float> got =
            pattern({"specpict", {"noop", "six_bands.hsr", ".", "Px", "Py"}, {}, "t", {}}, golden_vars(p));
        REQUIRE(got.size() == 3);
        for (size_t k = 0; k < 3; k++) CHECK(got[k] == doctest::Approx(r[2 + k]).epsilon(.04));
    }
    // The function gets the middle of each band: 1 + nm/1000 whatever the picture holds.
    const float p[3] = {.5f, .5f, 0};
    temporary("ramp2.cal", "ramp2(v, nm) = 1 + nm/1000; flat(v, nm) = .7;");
    std::string text =
        "#?RADIANCE\nNCOMP=24\nWAVELENGTH_SPLITS= 780 588 480 380\nFORMAT=Radiance_spectra\n\n-Y 2 +X 3\n";
    for (int i = 0; i < 6; i++) text += std::string(24, char(64)) + char(129);
    temporary("even.hsr", text);
    const auto at = [&](const char* f, const char* cal) {
        return pattern({"specpict", {f, "./cal_pattern_test.even.hsr", cal, "Px", "Py"}, {}, "t", {}}, golden_vars(p));
    };
    const double want[3] = {1.6324, 1.5437, 1.4362};
    for (size_t k = 0; k < 3; k++) {
        CHECK(at("ramp2", "./cal_pattern_test.ramp2.cal")[k] == doctest::Approx(want[k]).epsilon(1e-3));
        CHECK(at("flat", "./cal_pattern_test.ramp2.cal")[k] == doctest::Approx(.7).epsilon(1e-4));
        CHECK(at("noop", ".")[k] == doctest::Approx(64.5 / 128).epsilon(1e-4));
    }
}

TEST_CASE("hyperspectral pictures that are broken") {
    const auto fault = [](const std::string& lines, const std::string& pixels) {
        temporary("bad.hsr", "#?RADIANCE\n" + lines + "FORMAT=Radiance_spectra\n\n-Y 2 +X 2\n" + pixels);
        return trouble("specpict", {"noop", "./cal_pattern_test.bad.hsr", ".", "Px", "Py"});
    };
    const std::string splits = "WAVELENGTH_SPLITS= 780 588 480 380\n", pixels(4 * 7, 'x');
    CHECK(fault("NCOMP=6\n" + splits, pixels) == "no error");
    CHECK(fault("NCOMP=6\n" + splits, pixels.substr(1)).find("input ends inside the picture") != std::string::npos);
    CHECK(fault("NCOMP=6\n", pixels).find("needs WAVELENGTH_SPLITS=") != std::string::npos);
    CHECK(fault("NCOMP=6\nWAVELENGTH_SPLITS= 700 1 1 700\n", pixels).find("spans no wavelengths") != std::string::npos);
    CHECK(fault("NCOMP=6\nWAVELENGTH_SPLITS= 780 588\n", pixels).find("is malformed") != std::string::npos);
    CHECK(fault(splits, pixels).find("NCOMP=3: hyperspectral pictures have 4 to 24 bands") != std::string::npos);
    CHECK(fault("NCOMP=1000000\n" + splits, pixels).find("4 to 24 bands") != std::string::npos);
    CHECK(trouble("colorpict", {"red", "green", "blue", "six_bands.hsr", ".", "Px", "Py"}).find("only specpict") !=
          std::string::npos);
}

TEST_CASE("a spectral colour keeps its luminance inside the primaries' triangle") {
    const float p[3] = {0, 0, 0};
    const std::vector<float> got = pattern({"spectrum", {}, {500, 540, 1, 1, 1, 1, 1}, "t", {}}, golden_vars(p));
    CHECK(std::fmin(got[0], std::fmin(got[1], got[2])) == doctest::Approx(0).epsilon(1e-5));
    // integral of y from 500 to 540 nm over the whole of it: (.323/2 + .503 + .710 + .862 + .954/2)/10.6858
    CHECK(.265074f * got[0] + .670115f * got[1] + .064811f * got[2] == doctest::Approx(0.25395).epsilon(2e-3));
}

TEST_CASE("the transform of the instance acts after the pattern's own") {
    const float p[3] = {5, 2, 0};
    PatternSpec spec{"brightfunc", {"Px+10*Py", ".", "-t", "1", "0", "0"}, {}, "t", {}};
    std::vector<std::string> words{"-rz", "90", "-s", "2"};
    base::parse_xform({words.data(), words.size()}, 0, spec.outer, "t");
    // outer undone: (5,2)/2 turned back by 90 degrees = (1,-2.5); own undone: (0,-2.5)
    CHECK(pattern(spec, golden_vars(p))[0] == doctest::Approx(-25));
}

TEST_CASE("functions of materials: values of a hit and lobes of a light direction") {
    Library library(golden_files());
    library.define("half(lx,ly,lz) = .5*lz; scaled(v,lx,ly,lz,om) = v*lz*om; up(lx,ly,lz,om) = 10*lz;", "defs");
    Code code;
    const float p[3] = {1, 2, 3};
    std::vector<float> vars = golden_vars(p);
    vars[device::CAL_LX] = 0.6f;
    vars[device::CAL_LZ] = 0.8f;
    vars[device::CAL_OMEGA] = 0.25f;
    auto material = [&](const std::string& type, std::vector<std::string> strings) {
        return compile_material(library, {type, std::move(strings), {}, "t", {}}, code);
    };
    MaterialProgram m = material("prism1", {"Px", "1", "0", "0", ".", "-rz", "90", "-s", "3"});
    std::vector<float> got = run(code, m.values, m.value_count, vars);
    REQUIRE(got.size() == 4);
    CHECK(got[0] == doctest::Approx(2.0 / 3));
    CHECK(got[2] == doctest::Approx(1));  // x of the object is y of the world
    m = material("plasfunc", {"half", "."});
    CHECK(m.value_count == 0);
    CHECK(run(code, m.lobe, m.lobe_count, vars)[0] == doctest::Approx(0.4));
    m = material("plasfunc", {"half", ".", "-ry", "90"});  // z of the object is x of the world
    CHECK(run(code, m.lobe, m.lobe_count, vars)[0] == doctest::Approx(0.3));
    m = material("plasdata", {"scaled", "ramp.dat", ".", "up"});
    CHECK(run(code, m.lobe, m.lobe_count, vars)[0] == doctest::Approx(64 * 0.8 * 0.25));
    m = material("BRTDfunc", {".1", ".2", ".3", "Px", "Py", "Pz", "0", "0", "half", "."});
    CHECK(run(code, m.values, m.value_count, vars) == std::vector<float>{.1f, .2f, .3f, 1, 2, 3});
    CHECK(run(code, m.lobe, m.lobe_count, vars)[2] == doctest::Approx(0.4));
    m = material("WGMDfunc", {"a", ".5", ".1", ".2", "b", "0", ".3", ".4", "void", "0", "0", "1", "."});
    CHECK(m.modifiers == std::vector<std::string>{"a", "b", "void"});
    CHECK(run(code, m.values, m.value_count, vars) == std::vector<float>{.5f, .1f, .2f, 0, .3f, .4f, 0, 0, 1});
    m = material("BSDF", {".02", "x.xml", "0", "0", "1", "."});
    CHECK(m.file == "x.xml");
    CHECK(m.value_count == 4);
}

TEST_CASE("a mixture names its modifiers and stays within 0 and 1") {
    Library library(golden_files());
    Code code;
    const float p[3] = {3, 0, 0};
    const Program m = compile_pattern(library, {"mixfunc", {"red", "void", "Px", "."}, {}, "t", {}}, code);
    CHECK(m.first == "red");
    CHECK(m.second == "void");
    CHECK(run(code, m.entry, 1, golden_vars(p))[0] == 1);
}

TEST_CASE("a data file is read once, however many patterns use it") {
    Library library(golden_files());
    Code code;
    compile_pattern(library, {"brightdata", {"noop", "grid.dat", ".", "Px", "Py"}, {}, "t", {}}, code);
    const size_t floats = code.floats.size();
    compile_pattern(library, {"brightdata", {"noop", "grid.dat", ".", "Py", "Px"}, {}, "t", {}}, code);
    CHECK(code.floats.size() == floats);
}

TEST_CASE("a picture of a single row, column or pixel is a pattern; across it, nothing changes") {
    const std::string head = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n";
    const auto grey = [](const char* bytes) {
        std::string all;
        for (const char* b = bytes; *b; ++b) all += std::string(3, *b) + '\x81';
        return all;
    };
    const auto at = [&](const char* size, const char* bytes, float x, float y) {
        const float p[3] = {x, y, 0};
        const auto file = temporary("one.hdr", head + size + "\n" + grey(bytes));
        const auto got =
            pattern({"colorpict", {"red", "green", "blue", file, ".", "Px", "Py"}, {}, "t", {}}, golden_vars(p));
        REQUIRE(got.size() == 3);
        return got[0];
    };
    // rtrace's values (RADIANCE 6) of a glow with this pattern
    for (const auto& [x, y] : {std::pair(.5f, .5f), {3.f, 3.f}, {-3.f, -3.f}, {10.f, .5f}, {.5f, 10.f}})
        CHECK(at("-Y 1 +X 1", "\x64", x, y) == doctest::Approx(.7851562).epsilon(1e-5));
    const double row[][3] = {{.5, .5, .9153646}, {1, 1, 1.045573},   {2.5, .5, 1.436198}, {-.3, .5, .7070312},
                             {3, 3, 1.566406},   {-3, -3, .1972656}, {10, .5, .2935547},  {.5, 10, .9153646}};
    const double column[][3] = {{.5, .5, 1.436198},  {0, 0, 1.566406},    {.5, 1.4, 1.201823}, {.5, 2.5, .9153646},
                                {2.5, .5, 1.436198}, {.5, -.3, 1.644531}, {-3, -3, .9785156},  {.5, 10, .05917969}};
    for (const auto& [x, y, want] : row)
        CHECK(at("-Y 1 +X 3", "\x64\x96\xc8", float(x), float(y)) == doctest::Approx(want).epsilon(1e-5));
    for (const auto& [x, y, want] : column)
        CHECK(at("-Y 3 +X 1", "\x64\x96\xc8", float(x), float(y)) == doctest::Approx(want).epsilon(1e-5));
}

TEST_CASE("mistakes are named with the primitive's place") {
    CHECK(trouble("brightfunc", {"1"}) == "a.rad:3: bad arguments: too few strings for brightfunc");
    CHECK(trouble("brightfunc", {"1", "nix.cal"}) == "a.rad:3: cannot find function file \"nix.cal\"");
    CHECK(trouble("brightfunc", {"1", ".", "extra"}).find("after the function file") != std::string::npos);
    CHECK(trouble("brightdata", {"noop", "nix.dat", ".", "Px"}).find("nix.dat") != std::string::npos);
    CHECK(trouble("brightdata", {"noop", "grid.dat", ".", "Px"}) ==
          "a.rad:3: data file \"grid.dat\" has 2 dimensions, 1 coordinates are given");
    CHECK(trouble("brightdata", {"nope", "ramp.dat", ".", "Px"}) == "a.rad:3: function \"nope\" is not defined");
    CHECK(trouble("brighttext", {"tri2.fnt", "."}, {1, 2}) == "a.rad:3: bad number of real arguments");
    CHECK(trouble("brighttext", {"tri2.fnt", ".", "A"}, {0, 0, 0, 1, 0, 0, 2, 0, 0, 1, 0}) ==
          "a.rad:3: text vectors are parallel or zero");
    CHECK(trouble("colorfunc", {"1", "2", "3", ".", "-rx"}).find("a.rad:3") == 0);
    CHECK(trouble("brightfunc", {"1", ".", "-s", "0"}).find("a.rad:3") == 0);
    for (const char* bad : {"", "1", "1\n0 1 2000000000", "1\n0 1 1\n5", "1\n0 0 3 1 2 2\n1 2 3", "1\n0 1 2\n1 x",
                            "1\n0 1 2\n1", "9\n", "2\n0 1 60000\n0 1 60000\n1 2 3", "-1", "1e99"})
        CHECK_MESSAGE(
            trouble("brightdata", {"noop", temporary("bad.dat", bad), ".", "Px"}).find("a.rad:3: data file") == 0, bad);
    for (const char* bad : {"65", "65 3 0 0 1", "65 -1", "300 0", "65 0 65 0", "65 1 999 0", "x"})
        CHECK_MESSAGE(trouble("brighttext", {temporary("bad.fnt", bad), ".", "A"}, {0, 0, 0, 1, 0, 0, 0, -1, 0, 1, 0})
                              .find("a.rad:3: font") == 0,
                      bad);
}
