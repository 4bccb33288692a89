// SPDX-License-Identifier: BSD-3-Clause
// ptrace -state: which files a state has.
#include "scene/states.h"

#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include "base/error.h"

using scene::State;
using Files = std::vector<std::string>;

static const Files room{"room.rad", "south.rad", "desk.rad"};

static std::vector<State> states(const std::vector<std::string>& words) { return scene::states_of(words, room); }

static std::string fault(const std::vector<std::string>& words) {
    try {
        states(words);
    } catch (const base::Error& e) {
        return e.text;
    }
    return "";
}

TEST_CASE("without a word the scene has one state, which has no name") {
    const auto all = states({});
    REQUIRE(all.size() == 1);
    CHECK(all[0].name.empty());
    CHECK(all[0].files == room);
}

TEST_CASE("a state adds files, leaves files out, and puts them where those stood") {
    const auto all = states({"open", "half=half.rad", "shut=-south.rad +shut.rad", "bare=-south.rad -desk.rad",
                             "tilt=!genblinds a b .1 1 1 9 45", "quoted='with blank.rad' +'-odd.rad'"});
    REQUIRE(all.size() == 6);
    CHECK(all[0].files == room);
    CHECK(all[1].files == Files{"room.rad", "south.rad", "desk.rad", "half.rad"});
    CHECK(all[2].files == Files{"room.rad", "shut.rad", "desk.rad"});
    CHECK(all[3].files == Files{"room.rad"});
    CHECK(all[4].files.back() == "!genblinds a b .1 1 1 9 45");
    CHECK(all[5].files == Files{"room.rad", "south.rad", "desk.rad", "with blank.rad", "-odd.rad"});
}

TEST_CASE("the states of groups are combined, the last group's the fastest") {
    const auto all = states({"south/open", "west/open", "south/shut=-south.rad +s.rad", "west/shut=w.rad"});
    REQUIRE(all.size() == 4);
    CHECK(all[0].name == "south/open+west/open");
    CHECK(all[1].name == "south/open+west/shut");
    CHECK(all[2].name == "south/shut+west/open");
    CHECK(all[3].files == Files{"room.rad", "s.rad", "desk.rad", "w.rad"});
}

TEST_CASE("what cannot be a state is refused by name") {
    CHECK(fault({"shut=-none.rad"}) == "-state: shut: \"none.rad\" is not a file of the scene");
    CHECK(fault({"a=x.rad", "a"}) == "-state: two states are called \"a\"");
    CHECK(fault({"south/a", "b"}) == "-state: \"b\" is of no group, but others are");
    CHECK(fault({"=x.rad"}) == "-state: \"=x.rad\": \"\" is not a name");
    CHECK(fault({"a b"}) == "-state: \"a b\": \"a b\" is not a name");
    CHECK(fault({"x/y/z"}) == "-state: \"x/y/z\": \"y/z\" is not a name");
    CHECK(fault({"a=-"}) == "-state: \"-\": a name of a file follows + and -");
    CHECK(fault({"a=x.rad | y"}) == "-state: \"x.rad | y\" is neither names of files nor a command behind !");
}

TEST_CASE("64 states are the most") {
    std::vector<std::string> words;
    for (const char* group : {"a/", "b/"})
        for (int i = 0; i < 8; ++i) words.push_back(group + std::to_string(i));
    CHECK(states(words).size() == 64);
    words.push_back("b/8");
    CHECK(fault(words) == "-state: the states of all groups make more than 64 combinations");
}
