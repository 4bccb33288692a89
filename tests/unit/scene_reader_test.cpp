// SPDX-License-Identifier: BSD-3-Clause
// The scene language: words, numbers, names, aliases, argument counts, surfaces, commands - and what is refused, with
// file and line.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>
#include <cmath>
#include "scene_text.h"

using scene::Type;

namespace {
const std::string plastic = "void plastic m 0 0 5 .5 .5 .5 0 0\n";
const scene::Object& last(const scene::Scene& s) { return s.objects.back(); }
}  // namespace

TEST_CASE("words: white space, quotes, comments between primitives only") {
    const scene::Scene s = read_text(
        "# a comment\n\n\tvoid\n plastic 'my paint' 0\r\n0 5 .5 5. +1e-1 0 -0 # and\n"
        "void brightfunc f 2 \"if(Px, 1, 2)\" a'b c'd 0 0");
    REQUIRE(s.objects.size() == 2);
    CHECK(s.name(s.objects[0]) == "my paint");
    CHECK(s.reals(s.objects[0])[2] == .1);
    CHECK(s.strings(s.objects[1])[0] == "if(Px, 1, 2)");
    CHECK(s.strings(s.objects[1])[1] == "ab cd");
    CHECK(s.place(s.objects[0]) == "t.rad:3");
    CHECK(error_in(plastic + "void plastic # no comment here\n 0 0 5 1 1 1 0 0") ==
          "t.rad:2: plastic \"#\": number of strings expected, not \"no\"");
    CHECK(error_in("void brightfunc f 2 'a b . 0 0\n") == "t.rad:1: a quoted word does not end");
    CHECK(error_in("void plastic " + std::string(600, 'x')).find("t.rad:1: word \"xxx") == 0);
    CHECK(error_in("void plastic 'a\tb' 0 0 5 1 1 1 0 0") == "t.rad:1: a tab within the name \"a?b\"");
}

TEST_CASE("numbers are decimal and complete") {
    for (const char* good : {"5", "+5", "-5", ".5", "5.", "5e3", "5E-3", "1e-400"})
        CHECK(error_in("void light l 0 0 3 1 1 " + std::string(good)) == "");
    for (const char* bad : {"1e", "0x10", "nan", "inf", "1.2.3", "e5", ".", "-", "1e400", "1f"})
        CHECK(error_in("void light l 0 0 3 1 1 " + std::string(bad)) ==
              "t.rad:1: light \"l\": \"" + std::string(bad) + "\" is not a number");
    CHECK(error_in("void light l 0 1 7 3 1 1 1") == "t.rad:1: light \"l\" has integer arguments");
    CHECK(error_in("void light l 0 0 -3 1 1 1") == "t.rad:1: light \"l\": number of reals expected, not \"-3\"");
}

TEST_CASE("a modifier is the last definition before its user; surfaces are no modifiers") {
    const scene::Scene s = read_text(
        "void plastic m 0 0 5 .1 .1 .1 0 0\nm sphere m 0 0 4 0 0 0 1\n"
        "void plastic m 0 0 5 .2 .2 .2 0 0\nm sphere b 0 0 4 0 0 0 1\n");
    CHECK(s.objects[1].modifier == 0);
    CHECK(s.objects[3].modifier == 2);
    CHECK(s.lookup_modifier("m", 2) == 0);
    CHECK(s.lookup_modifier("m", 3) == 2);
    CHECK(s.lookup_modifier("void", 3) == scene::VOID);
    CHECK(error_of([&] { s.lookup_modifier("glas", 3); }) == "t.rad:4: modifier \"glas\" is not defined");
    CHECK(error_in("\n\nglas polygon p 0 0 9 0 0 0 1 0 0 0 1 0") == "t.rad:3: modifier \"glas\" is not defined");
    CHECK(error_in("void plastick p 0 0 0") == "t.rad:1: unknown type \"plastick\"");
    CHECK(error_in("void light void 0 0 3 1 1 1") == "t.rad:1: a modifier cannot be named \"void\"");
}

// Of a chain of aliases the one used first says the modifier; "inherit" keeps that of the thing it points to.
TEST_CASE("aliases replace the modifier, or inherit it") {
    const scene::Scene s = read_text(
        "void brightfunc f 2 .5 . 0 0\nvoid brightfunc g 2 .2 . 0 0\nf plastic p 0 0 5 1 1 1 0 0\n"
        "void alias bare p\ng alias other p\ninherit alias same p\ninherit alias again other\nvoid alias top other\n"
        "void plastic p 0 0 5 0 0 0 0 0\ntop sphere ball 0 0 4 0 0 0 1\n");
    auto resolved = [&](const char* name) { return s.resolve(s.definitions.at(name).back()); };
    CHECK(resolved("bare").object == 2);
    CHECK(resolved("bare").modifier == scene::VOID);
    CHECK(resolved("other").modifier == 1);
    CHECK(resolved("same").modifier == 0);
    CHECK(resolved("again").object == 2);
    CHECK(resolved("again").modifier == 1);
    CHECK(resolved("top").modifier == scene::VOID);
    CHECK(s.material(last(s).modifier).object == 2);  // the later "p" does not matter
    CHECK(error_in("void alias a nothing") == "t.rad:1: alias \"a\" refers to \"nothing\", which is not defined");
    CHECK(error_in(plastic + "m sphere s 0 0 4 0 0 0 1 void alias a s") ==
          "t.rad:2: alias \"a\" refers to \"s\", which is not defined");
}

TEST_CASE("a chain of 100,000 aliases takes no more stack than one") {
    std::string text = plastic + "void alias a0 m\n";
    for (int i = 1; i < 100000; i++)
        text += "inherit alias a" + std::to_string(i) + " a" + std::to_string(i - 1) + "\n";
    const scene::Scene s = read_text(text);
    CHECK(s.resolve(100000).object == 0);
}

TEST_CASE("each type has its number of arguments") {
    CHECK(error_in("void plastic p 0 0 4 1 1 1 0") == "t.rad:1: plastic \"p\" needs 5 real arguments, has 4");
    CHECK(error_in("void glass g 0 0 5 1 1 1 1 1") == "t.rad:1: glass \"g\" needs 3 or 4 real arguments, has 5");
    CHECK(error_in("void brightfunc f 1 x 0 0") ==
          "t.rad:1: brightfunc \"f\" needs at least 2 string arguments, has 1");
    CHECK(error_in("void polygon p 0 0 10 0 0 0 1 0 0 0 1 0 7") ==
          "t.rad:1: polygon \"p\" needs 9 or more real arguments, a multiple of 3, has 10");
    CHECK(error_in("void plastic p 0 0 5 1 1 1") == "t.rad:1: the file ends within plastic \"p\"");
}

TEST_CASE("surfaces come out in canonical form") {
    auto type = [&](const std::string& text) { return std::string(type_name(last(read_text(plastic + text)).type)); };
    auto reals = [&](const std::string& text) {
        const scene::Scene s = read_text(plastic + text);
        const auto r = s.reals(last(s));
        return std::vector<double>(r.begin(), r.end());
    };
    CHECK(type("m sphere s 0 0 4 0 0 0 -1") == "bubble");
    CHECK(type("m cone c 0 0 8 0 0 0 0 0 1 2 2") == "cylinder");
    CHECK(type("m cup c 0 0 8 0 0 0 0 0 1 2 2") == "tube");
    CHECK(type("m cone c 0 0 8 0 0 0 0 0 1 -2 -1") == "cup");
    CHECK(type("m cone c 0 0 8 0 0 0 0 0 1 0 -1") == "cup");
    CHECK(type("m cylinder c 0 0 7 0 0 0 0 0 1 -2") == "tube");
    CHECK(reals("m ring r 0 0 8 0 0 0 0 0 1 3 2") == std::vector<double>{0, 0, 0, 0, 0, 1, 2, 3});
    CHECK(reals("m polygon p 0 0 12 0 0 0 1 0 0 1 1 0 0 0 0").size() == 9);
    // Unusable: left out with a warning, but an error as a light.
    for (const char* bad :
         {"ring r 0 0 8 0 0 0 0 0 1 2 2", "polygon p 0 0 9 0 0 0 1 0 0 2 0 0", "cylinder c 0 0 7 0 0 0 0 0 0 1",
          "cone c 0 0 8 0 0 0 0 0 1 -1 1", "ring r 0 0 8 0 0 0 0 0 0 1 2"}) {
        CHECK(read_text(plastic + "m " + bad).objects.size() == 1);
        CHECK(error_in("void light l 0 0 3 1 1 1\nl " + std::string(bad)).find("t.rad:2: light source ") == 0);
    }
    CHECK(error_in("void sphere s 0 0 4 0 0 0 1e-7") == "t.rad:1: a sphere without radius");
}

TEST_CASE("xform: layers, names, modifiers of surfaces only") {
    const Folder folder;
    Folder::write("ball.rad", "m sphere ball 0 0 4 1 0 0 1\nvoid brightfunc f 2 Px . 0 0\n");
    Folder::write("pair.rad", "!xform -n in -t 1 0 0 ball.rad\n");
    Folder::write("t.rad", plastic +
                               "void plastic red 0 0 5 1 0 0 0 0\n!xform -n out -m red -s 2 pair.rad\n"
                               "!genbox m box 1 1 1 | xform -a 2 -t 0 0 2 | xform -n b -rz 90\n");
    const scene::Scene s = scene::read_scene({"t.rad"}, {});
    REQUIRE(s.objects.size() == 4 + 12);
    const scene::Object& ball = s.objects[2];
    CHECK(s.name(ball) == "out.in.ball");
    CHECK(ball.modifier == 1);
    CHECK(s.reals(ball)[0] == 4);
    CHECK(s.reals(ball)[3] == 2);
    CHECK(s.place(ball) == "ball.rad:1");
    const auto words = s.strings(s.objects[3]);
    std::string joined;
    for (const std::string& w : words) joined += w + " ";
    CHECK(joined == "Px . -i 1 -t 1 0 0 -i 1 -s 2 ");
    CHECK(s.name(s.objects[4]) == "b.a0.box.1540");
    CHECK(s.name(last(s)) == "b.a1.box.6457");
    CHECK(s.place(last(s)) == "t.rad:4");
}

TEST_CASE("files beside the file that names them are found from anywhere") {
    const Folder folder;
    std::filesystem::create_directory("room");
    Folder::write("room/part.rad", plastic);
    Folder::write("room/all.rad", "!xform part.rad\n!cat part.rad | xform -t 0 0 1\n");
    CHECK(scene::read_scene({"room/all.rad"}, {}).objects.size() == 2);
    scene::ReadOptions options;
    CHECK(base::look_for_file("part.rad", options, "").empty());
    base::search_beside({"room/all.rad", "t.rad", "!cat x/y"}, options);
    CHECK(base::look_for_file("part.rad", options, "") == "room/part.rad");
    CHECK(error_in("!xform nowhere.rad").find("t.rad:1: cannot open \"nowhere.rad\"") == 0);
}

TEST_CASE("other commands need -exec, and the message says so") {
    CHECK(error_in("\n!obj2rad chair.obj\n") == "t.rad:2: command \"obj2rad\" is not built in; -exec would allow it");
    CHECK(error_in("!genbox m b 1 1 1; rm -rf x\n").find("needs a shell (;); -exec would allow it") !=
          std::string::npos);
    CHECK(error_in("!xform -t 0 0 $X a.rad\n").find("needs a shell ($)") != std::string::npos);
    scene::ReadOptions exec;
    exec.exec = true;
    const scene::Scene s = read_text(
        "!echo void sphere s 0 0 4 0 0 0 1; echo void sphere t 0 0 4 0 0 0 1\n"
        "!echo void sphere u 0 0 4 0 0 0 1 | xform -t 1 0 0\n",
        exec);
    REQUIRE(s.objects.size() == 3);
    CHECK(s.reals(s.objects[2])[0] == 1);
    CHECK(s.place(s.objects[1]) == "t.rad:1");
}

TEST_CASE("a file may be a command's standard input") {
    const Folder folder;
    std::filesystem::create_directory("room");
    Folder::write("room/outline.txt", "0 0  0 1\n1 1\n1 0\n");
    Folder::write("room/ball.rad", "void sphere s 0 0 4 0 0 0 1\n");
    const auto read = [](const std::string& command) {
        Folder::write("room/all.rad", plastic + "!" + command + "\n");
        return scene::read_scene({"room/all.rad"}, {});
    };
    const scene::Scene named = read("genprism m p 4 0 0 0 1 1 1 1 0 -l 0 0 2");
    for (const char* command : {"genprism m p - < outline.txt -l 0 0 2", "genprism m p - -l 0 0 2 <outline.txt",
                                "<room/outline.txt genprism m p - -l 0 0 2",
                                "genprism m p - -l 0 0 2 < \"outline.txt\"", "genprism m p outline.txt -l 0 0 2"}) {
        CAPTURE(command);
        const scene::Scene s = read(command);
        REQUIRE(s.objects.size() == named.objects.size());
        for (size_t i = 1; i < s.objects.size(); i++)
            for (size_t k = 0; k < s.objects[i].real_count; k++)
                CHECK(s.reals(s.objects[i])[k] == named.reals(named.objects[i])[k]);
    }
    CHECK(read("xform -t 0 0 5 < ball.rad").objects.size() == 2);
    CHECK(read("cat < ball.rad | xform -t 0 0 5").objects.size() == 2);
    const auto fault = [&](const std::string& command) { return error_of([&] { read(command); }); };
    CHECK(fault("genprism m p - -l 0 0 2") == "room/all.rad:2: genprism: \"-\" needs a file: genprism m p - < file");
    CHECK(fault("genprism m p - < nowhere").find("room/all.rad:2: cannot open \"nowhere\"") == 0);
    CHECK(fault("genprism m p nowhere").find("room/all.rad:2: cannot open \"nowhere\"") == 0);
    for (const char* command :
         {"genprism m p - <", "genprism m p - << end", "genprism m p - <& 3", "genprism m p - 0<outline.txt",
          "genbox m b 1 1 1 | xform < ball.rad", "genprism m p - < outline.txt > x", "cat <> ball.rad"})
        CHECK(fault(command).find("needs a shell") != std::string::npos);
}

TEST_CASE("a command stands for a file on the command line, as in octrees") {
    const scene::Scene s = scene::read_scene({"!gensky -ang 45 0 -c", "!genbox void b 1 1 1 | xform -t 0 0 1"}, {});
    CHECK(s.objects.size() == 1 + 6);
    CHECK(error_of([] { scene::read_scene({"!nonsense"}, {}); }) ==
          "command line:1: command \"nonsense\" is not built in; -exec would allow it");
}

TEST_CASE("quotes and continued lines in commands") {
    const scene::Scene s =
        read_text(plastic + "!genbox m \"the 'box'\" 1 \\\n 1 '1' # a comment\n" + "m sphere s 0 0 4 0 0 0 1");
    REQUIRE(s.objects.size() == 8);
    CHECK(s.name(s.objects[1]) == "the 'box'.1540");
    CHECK(s.objects[1].line == 2);
    CHECK(last(s).line == 4);
}

TEST_CASE("curved slats of no or negative depth are an error") {
    CHECK(error_in(plastic + "!genblinds m b -1 1 4 3 30 +r .2") ==
          "t.rad:2: genblinds: curved slats need a depth above 0");
}

TEST_CASE("errors of xform's command line") {
    CHECK(error_in("!xform -q 3 a.rad") == "t.rad:1: xform: unknown option -q");
    CHECK(error_in("!xform -t 1 0") == "t.rad:1: xform: option -t lacks its argument");
    CHECK(error_in("!xform -t 1 0 0") == "t.rad:1: xform: no file to transform");
    CHECK(error_in("!xform -t 1 0 0 -n late a.rad") == "t.rad:1: xform: option -n must come before the transform");
    CHECK(error_in("!genbox m b 1 1 1 | xform -s 0") == "t.rad:1: transform option -s: a scale of 0");
    CHECK(error_in("!genbox m b 1 1 1 | xform -rx abc") == "t.rad:1: transform option -rx: \"abc\" is not a number");
}

TEST_CASE("nesting, self-inclusion and array bombs end in an error, soon and in bounded memory") {
    const Folder folder;
    Folder::write("self.rad", "# round and round\n!xform -t 1 0 0 self.rad\n");
    CHECK(error_of([] { scene::read_scene({"self.rad"}, {}); }) == "self.rad:2: \"self.rad\" includes itself");
    for (int i = 0; i < 10000; i++) Folder::write("f" + std::to_string(i), "!cat f" + std::to_string(i + 1) + "\n");
    CHECK(error_of([] { scene::read_scene({"f0"}, {}); }) == "f64:1: commands and files are nested more than 64 deep");
    std::string pipe = "!genbox m b 1 1 1";
    for (int i = 0; i < 10000; i++) pipe += "|xform";
    CHECK(error_in(pipe).find("t.rad:1: a pipe of more than 100 commands") != std::string::npos);
    scene::Limits small;
    small.bytes = 10 << 20;
    CHECK(error_in(plastic + "!genbox m b 1 1 1 | xform -a 1000000", small)
              .find("the scene needs more memory than allowed (10 MB)") != std::string::npos);
    CHECK(error_in("!genbox m b 1 1 1 | xform -a 99999999 -a 99999999 -a 0").find("xform: more than 10000000 copies") !=
          std::string::npos);
    CHECK(error_in("void polygon p 0 0 4000000000 0 0 0") == "t.rad:1: the file ends within polygon \"p\"");
    CHECK(error_in("void brightfunc p 99999999999999999999").find("number of strings expected") != std::string::npos);
    CHECK(error_in("!xform " + std::string(2000000, 'a')) ==
          "t.rad:1: the command is longer than a million characters");
}

TEST_CASE("a reader looks up from its work often, and gives up where nobody wants the scene") {
    int looks = 0;
    scene::ReadOptions how;
    how.work = std::make_shared<base::WorkBudget>(base::WorkBudget::usual_limit, [&] {
        if (++looks == 3) throw base::GivenUp{};
    });
    CHECK_THROWS_AS(read_text(plastic + "!genbox m b 1 1 1 | xform -a 999999 -t 1 0 0", how), base::GivenUp);
    CHECK(looks == 3);
}

TEST_CASE("texts stand for files in the readings that have them, and each reading has its own list of files") {
    const Folder folder;
    Folder::write("a.rad", plastic + "!xform -t 0 0 0 b.rad\n");
    Folder::write("b.rad", "m sphere s 0 0 4 0 0 0 1\n");
    scene::ReadOptions disk, edited;
    edited.overlays = base::with_overlay({}, "./b.rad", "m sphere s 0 0 4 0 0 0 2\nm sphere t 0 0 4 9 0 0 1\n");
    CHECK(scene::read_scene({"a.rad"}, edited).objects.size() == 3);
    CHECK(scene::read_scene({"a.rad"}, disk).objects.size() == 2);
    CHECK(base::paths_of(*disk.read) == std::vector<std::string>{"a.rad", "b.rad"});
    CHECK(base::are_unchanged(*disk.read, disk.overlays));
    CHECK(!base::are_unchanged(*disk.read, edited.overlays));
    Folder::write("b.rad", "m sphere s 0 0 4 0 0 0 3\n\n");  // a saved file is another one
    CHECK(scene::read_scene({"a.rad"}, edited).objects.size() == 2);
}

TEST_CASE("unreadable files are errors") {
    CHECK(error_of([] { scene::read_scene({"/no/such.rad"}, {}); }).find("/no/such.rad: cannot be read: No such") == 0);
    CHECK(error_of([] { scene::read_scene({"/"}, {}); }) == "/: \"/\" is a directory");
}
