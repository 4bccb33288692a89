// SPDX-License-Identifier: BSD-3-Clause
// Options from one declaration: what is read, what is refused and in which words, what -help and -defaults say.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>

#include "base/error.h"
#include "base/edit_distance.h"
#include "base/options.h"
#include "base/value.h"
#include "temp_folder.h"

namespace {

using base::Arguments;
using Strings = std::vector<std::string>;

// One variable of each kind.
struct Values {
    int n = 512, level = 0;
    double share = 1, length = 1e-6, rgb[3] = {0, 0, 0};
    std::optional<double> limit;
    uint64_t seed = 1;
    bool irradiance = false, exec = false, peaks = true;
    base::Vec3 point{0, 0, 1};
    std::string device = "auto";
    Strings files;
    char type = 'v';
    enum class Format { tsv, csv } format = Format::tsv;
    std::string pair;
};

void declare(base::OptionTable& t, Values& v) {
    t.group("Some");
    t.add("-x n", "Size", v.n).within(1, 1000).from_scene();
    t.add("-level n", "Level", v.level);
    t.add("-pj f", "Jitter", v.share).within(0, 1).share().from_scene();
    t.add("-lw f", "Weight", v.length).at_least(0).unit("cd/m2");
    t.add("-av r g b", "Ambient", v.rgb);
    t.add("-Y lum", "Limit", v.limit).above(0);
    t.add("-seed n", "Seed", v.seed).at_least(0);
    t.add("-i[+-]", "Irradiance", v.irradiance).from_scene();
    t.add("-w[+-]", "Warnings", v.peaks).passed_over_in_scene();
    t.add("-exec", "Commands", v.exec);
    t.add("-vp x y z", "Point", v.point).from_scene();
    t.add("-vt T", "Type", base::one_of(v.type, {{"v", 'v'}, {"a", 'a'}})).joined().from_scene();
    t.add("-device name", "Device", v.device);
    t.add("-o file", "File", v.files).also_joined();
    t.add("-1", "Fast", base::set(v.peaks, false));
    t.add("-format name", "Format",
          base::one_of(v.format, {{"tsv", Values::Format::tsv}, {"csv", Values::Format::csv}}));
    t.add("-cr low high", "Pair", [&](Arguments& a) { v.pair = a.text() + "/", v.pair += a.text(); });
    t.ignored("-aa -ar", 1, base::OptionTable::Scenes::yes);
    t.ignored("-ap", 1, base::OptionTable::Scenes::no, 2);
    t.ignored("-pRGB", 0, base::OptionTable::Scenes::yes);
    t.refuse("-c file", "Not here: a picture", "writes a picture");
    t.group("other's", "other");
    t.add("-theirs n", "Theirs", v.level);
    t.examples("As here:\n  tool file\n");
}

struct Tool {
    Values v;
    base::OptionTable table{"tool", "1", "[options] file ..."};
    Tool() { declare(table, v); }

    // The operands.
    Strings parse(Strings words) {
        std::vector<char*> argv = {const_cast<char*>("tool")};
        for (std::string& word : words) argv.push_back(word.data());
        return table.parse(int(argv.size()), argv.data()).value_or(Strings{"(a question)"});
    }
    std::string error(const Strings& words) {
        try {
            parse(words);
        } catch (const base::Error& e) {
            return e.text;
        }
        return "";
    }
    std::string scene_error(const Strings& words) {
        try {
            table.read_scene_words(words, "room.rif");
        } catch (const base::Error& e) {
            return e.text;
        }
        return "";
    }
};

}  // namespace

TEST_CASE("values are read in one way") {
    CHECK(base::to_int("1e3", "") == 1000);
    CHECK(base::to_int("-12", "") == -12);
    CHECK(base::to_real("-.5e1", "") == -5);
    CHECK(base::parse_fraction("50%", "") == .5);
    CHECK(base::parse_fraction("-1", "") == -1);
    for (const char* bad : {"nan", "inf", "", " 1", "1e", "1 ", "50%"})
        CHECK_THROWS_AS(base::to_real(bad, ""), base::Error);
    for (const char* bad : {"99999999999999999999", " 1", "1.5", "1e-1", "%", "1e30"})
        CHECK_THROWS_AS(base::to_int(bad, ""), base::Error);
    CHECK_THROWS_AS(base::parse_fraction("%", ""), base::Error);
    Tool t;
    t.parse({"-lw", "0.12345678901234567"});
    CHECK(t.v.length == 0.12345678901234567);
    CHECK(base::number_text(1e-6) == "1e-6");
    CHECK(base::number_text(-0.0) == "0");
}

TEST_CASE("arguments are counted, whatever they look like") {
    Tool t;
    CHECK(t.parse({"-vp", "0", "-1", "2.5", "a", "-x", "1e2", "-pj", "50%", "-cr", "-x", "-1", "-o", "-i", "-"}) ==
          Strings{"a", "-"});
    CHECK(t.v.point == base::Vec3{0, -1, 2.5});
    CHECK(t.v.n == 100);
    CHECK(t.v.share == .5);
    CHECK(t.v.pair == "-x/-1");
    CHECK(t.v.files == Strings{"-i"});
    CHECK(t.v.peaks);
    CHECK_FALSE(t.v.irradiance);
}

TEST_CASE("switches toggle, + and - set; joined words, two dashes and = are read") {
    Tool t;
    for (const char* word : {"-i", "-i+", "-i1", "-iy", "-iT"}) {
        t.parse({word});
        CHECK(t.v.irradiance);
    }
    for (const char* word : {"-i", "-i-", "-i0", "-iN", "-if"}) {
        t.parse({word});
        CHECK_FALSE(t.v.irradiance);
    }
    t.parse(
        {"-vta", "--lw", "7", "--device", "cpu", "-seed=9", "--format=csv", "-ofile", "-o", "other", "-exec", "-1"});
    CHECK(t.v.type == 'a');
    CHECK(t.v.length == 7);
    CHECK(t.v.device == "cpu");
    CHECK(t.v.seed == 9);
    CHECK(t.v.format == Values::Format::csv);
    CHECK(t.v.files == Strings{"file", "other"});
    CHECK(t.v.exec);
    CHECK_FALSE(t.v.peaks);
    CHECK(t.table.given("-seed"));
    CHECK_FALSE(t.table.given("-pj"));
}

TEST_CASE("@file and $VARIABLE are replaced where an option may begin only, also inside each other") {
    TempFolder folder;
    const std::string path = folder.name("file");
    std::ofstream(path) << "-x 2\n$LUX_TEST_WORDS   \n -1";
    setenv("LUX_TEST_WORDS", "-lw 7", 1);
    Tool t;
    CHECK(t.parse({"@" + path, "-o", "@name", "scene.rad"}) == Strings{"scene.rad"});
    CHECK(t.table.command() == "tool -x 2 -lw 7 -1 -o @name scene.rad");
    CHECK(t.v.files == Strings{"@name"});
    CHECK(t.v.length == 7);
    std::ofstream(path) << "@" << path;
    CHECK(t.error({"@" + path}) == "@" + path + ": expands without end");
    CHECK(t.error({"@/no/such/file"}) != "");
    CHECK(t.error({"$LUX_TEST_NOT_SET"}) == "$LUX_TEST_NOT_SET: environment variable is not set");
}

TEST_CASE("the later of two options holds; -- ends options; options may have to come first") {
    Tool t;
    CHECK(t.parse({"-x", "1", "-x", "2", "--", "-x", "@file"}) == Strings{"-x", "@file"});
    CHECK(t.v.n == 2);
    t.table.options_come_before("the scene files");
    CHECK(t.error({"a", "-x", "1"}) == "-x: options must come before the scene files, but \"a\" came first");
}

TEST_CASE("what is wrong is said in one way") {
    Tool t;
    CHECK(t.error({"-vx"}) == "-vx: unknown option; did you mean -vp?");
    CHECK(t.error({"-devcie", "cpu"}) == "-devcie: unknown option; did you mean -device?");
    CHECK(t.error({"-form=tsv"}) == "-form=tsv: unknown option; did you mean -format?");
    CHECK(t.error({"-X"}) == "-X: unknown option; did you mean -x?");
    CHECK(t.error({"-zz"}) == "-zz: unknown option; tool -help lists them");
    CHECK(t.error({"-z"}) == "-z: unknown option; tool -help lists them");
    CHECK(t.error({"-vp", "1", "2"}) == "-vp: an argument is missing (-vp x y z)");
    CHECK(t.error({"-vt", "a"}) == "-vt: an argument is missing (-vtT)");
    CHECK(t.error({"-x", "1.5"}) == "-x: \"1.5\" is not an integer");
    CHECK(t.error({"-lw", "much"}) == "-lw: \"much\" is not a number");
    CHECK(t.error({"-lw", "50%"}) == "-lw: \"50%\" is not a number");
    CHECK(t.error({"-x", "1001"}) == "-x: 1001 is outside 1 to 1000");
    CHECK(t.error({"-lw", "-1"}) == "-lw: -1 is below 0");
    CHECK(t.error({"-Y", "0"}) == "-Y: 0 is not above 0");
    CHECK(t.error({"-o", ""}) == "-o: the name is empty");
    CHECK(t.error({"-lw", ""}) == "-lw: \"\" is not a number");
    CHECK(t.error({"-vp", "0,5", "0", "0"}) == "-vp: \"0,5\" is not a number");
    CHECK(t.error({"-level", "99999999999"}) == "-level: \"99999999999\" is too large");
    CHECK(t.error({"-format", "xml"}) == "-format: \"xml\" is not one of tsv, csv");
    CHECK(t.error({"-vtab"}) == "-vt: \"ab\" is not one of v, a");
    CHECK(t.error({"-c"}) == "-c: writes a picture");
    CHECK(t.v.n == 512);
}

TEST_CASE("another program's options are read past and remembered") {
    Tool t;
    CHECK(t.parse({"-aa", ".1", "-ap", "map", "40", "50", "-pRGB", "-ap", "map", "file", "-aa", "0"}) ==
          Strings{"file"});
    CHECK(t.table.ignored_ones() == Strings{"-aa", "-ap"});
}

TEST_CASE("a scene says what its options allow") {
    Tool t;
    t.table.read_scene_words({"-x", "3", "-i-", "-vta", "-aa", "1", "-w-", "-pj", "10%"}, "room.rif");
    CHECK(t.v.n == 3);
    CHECK(t.v.peaks);  // -w is the user's
    CHECK(t.table.parsed().empty());
    setenv("LUX_TEST_WORDS", "-x 3", 1);
    CHECK(t.scene_error({"$LUX_TEST_WORDS"}) == "room.rif: a scene's file may not ask for an environment variable");
    CHECK(t.scene_error({"@/dev/null"}) == "room.rif: \"/dev/null\" is not an ordinary file");
    const std::string refused = " is not a rendering or view option: a scene may not set it";
    for (const char* word : {"-exec", "-o", "-ap", "-help", "-c", "-seed", "--exec", "-exec=1"})
        CHECK(t.scene_error({word, "1"}).find(refused) != std::string::npos);
    CHECK(t.scene_error({"-password"}) == "room.rif: \"-passwor...\"" + refused);
    CHECK(t.scene_error({"word"}) ==
          "room.rif: holds a word where an option is expected: a scene may give options only");
}

TEST_CASE("-help and -defaults follow from the declarations") {
    Tool t;
    const std::string help = t.table.help();
    for (const char* line : {
             "usage: tool [options] file ...\nAs here:\n  tool file\nSome\n",
             "  -x n                Size (512).\n",
             "  -lw f               Weight in cd/m2 (1e-6).\n",
             "  -i[+-]              Irradiance (off).\n",
             "  -vtT                Type (v).\n",
             "  -vp x y z           Point (0 0 1).\n",
             "  -Y lum              Limit.\n",
             "  -format name        Format (tsv).\n",
             "Accepted and not needed:\n                      -aa -ar -ap -pRGB\n",
             "  -help               Print the options.\n",
         })
        CHECK_MESSAGE(help.find(line) != std::string::npos, line);

    const std::string theirs = "other's\n  -theirs n           Theirs (0).\n";
    CHECK(t.table.help("other") == theirs + "Described in tool(1).\n");
    CHECK(help.find(theirs) == std::string::npos);
    CHECK(t.table.help("all").find(theirs) != std::string::npos);

    t.parse({"-x", "3", "-i", "-exec", "-Y", "2"});
    const std::string defaults = t.table.defaults();
    for (const char* line : {"-x 3  ", "-i+  ", "-exec  ", "-Y 2  ", "-vtv  ", "-vp 0 0 1  ", "-device auto  "})
        CHECK_MESSAGE(("\n" + defaults).find("\n" + std::string(line)) != std::string::npos, line);
    CHECK(defaults.find("-c") == std::string::npos);
}

TEST_CASE("a slip of the finger is near") {
    CHECK(base::edit_distance("-vx", "-vp") == 1);
    CHECK(base::edit_distance("srceen", "screen") == 1);
    CHECK(base::largest_slip(3) == 1);
    CHECK(base::meant_by("dgp", {"Ev", "DGP"}) == "DGP");
    CHECK(base::question("UGrf", {"UGRf", "DGPf"}) == "; did you mean UGRf?");
    CHECK(base::question("other", {"UGRf", "DGPf"}).empty());
}
