// SPDX-License-Identifier: BSD-3-Clause
// The live page as a function: lists of events, and what the state says after each.  Without a browser, a program or a
// clock.  live_pipes_test has those of its programs, live_random_test lists that are drawn.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include "live_page_model.h"

TEST_CASE("changes of texts by version, undone and made again one by one; a drag is one") {
    Page page;
    Tracer t = started(page);
    CHECK(page.type(1, "a") == 200);
    CHECK(page.type(1, "b", "b.rad: 1 to 2", true) == 200);
    CHECK(page.type(1, "c", "b.rad: 1 to 3", true) == 200);
    page.ask("/control", {}, "go\n");
    CHECK(page.type(1, "d") == 200);
    CHECK(page.s.files[1].version == 4);
    CHECK(page.s.files[0].version == 0);
    CHECK(page.ask("/overlay", {{"n", "1"}, {"version", "3"}}, "late") == 412);
    for (const char* want : {"c", "a", "disk of b.rad"}) {
        CHECK(page.undo() == 204);
        CHECK(page.text(1) == want);
    }
    CHECK(page.undo() == 409);
    CHECK(page.s.redo.size() == 3);
    for (const char* want : {"a", "c", "d"}) {
        CHECK(page.redo() == 204);
        CHECK(page.text(1) == want);
    }
    CHECK(page.s.undo[1].words == "b.rad: 1 to 3");
    CHECK(page.ask("/undo", {{"state", "0"}}) == 412);
    page.undo();
    page.type(1, "e");
    CHECK(page.redo() == 409);  // another way was taken
    page.run(t);
    CHECK(t.of("b.rad") == "e");
}

TEST_CASE("a variant has a name of its own") {
    Page page({"a.rad"});
    Tracer t = started(page);
    page.run(t);
    page.variant("keep", "A");
    page.variant("keep", "B");
    const auto call = [&](const std::string& to) {
        return page.ask("/variant", {{"do", "call"}, {"name", "B"}, {"to", to}});
    };
    for (const char* to : {"A", ""}) CHECK(call(to) == 409);
    CHECK(call("B") == 204);
    CHECK(page.s.now.variants[1].name == "B");
    CHECK(call("C") == 204);
    CHECK(page.s.now.variants[1].name == "C");
}

TEST_CASE("all that the page can change is undone and made again, and has a name") {
    Page page({"a.rad"}, "x.regions");
    Tracer t = started(page);
    page.run(t);
    page.variant("keep", "");
    page.type(0, "other", "a.rad: 20 to 32");
    page.variant("keep", "dark");
    page.variant("drop", "A");
    page.draw(1, "desk circle view 20\nwall circle view 30\n");
    page.draw(1, "wall circle view 30\n");
    page.ask("/control", {}, "view -vp 1 2 3\n");
    page.run(t);
    page.ask("/place", {{"do", "keep"}, {"name", "door"}});
    page.variant("show", "dark");
    const std::vector<std::string> names{"variant A kept",
                                         "a.rad: 20 to 32",
                                         "variant dark kept",
                                         "variant A deleted",
                                         "region desk added",
                                         "region desk deleted",
                                         "view",
                                         "view door kept",
                                         "variant dark shown"};
    REQUIRE(page.s.undo.size() == names.size());
    for (size_t k = 0; k < names.size(); ++k) CHECK(page.s.undo[k].words == names[k]);
    const std::string end = json_of(page.s);
    for (int k = 0; k < 3; ++k) page.undo();
    CHECK(page.s.now.views.size() == 1);
    page.undo();
    CHECK(page.written[1] == "desk circle view 20\nwall circle view 30\n");
    page.undo();
    CHECK(page.written[1].empty());
    page.undo();
    CHECK(page.s.now.variants.size() == 2);
    for (int k = 0; k < 3; ++k) page.undo();
    CHECK(page.text(0) == "disk of a.rad");
    CHECK(page.s.now.variants.empty());
    for (size_t k = 0; k < names.size(); ++k) CHECK(page.redo() == 204);
    CHECK(page.written[1] == "wall circle view 30\n");
    CHECK(page.s.now.view() == page.s.now.variants[0].look.view);
    page.run(t);
    CHECK(t.of("a.rad") == "other");
    CHECK(t.eye == std::vector<double>{0, 0, 0});
}

TEST_CASE("an edit that has not arrived is sent again with the next one") {
    Page page;
    Tracer t = started(page);
    page.type(0, "new");
    CHECK(page.take() == "note  [1]\noverlay a.rad 3\nnew");  // which is lost
    page.ask("/control", {}, "view -vp 1 2 3\n");
    CHECK(page.s.pipe(Which::picture).sent.size() == 2);
    page.run(t);
    CHECK(t.of("a.rad") == "new");
    CHECK(page.s.pipe(Which::picture).sent.empty());
    CHECK(page.s.pipe(Which::picture).look == look_now(page.s));
    page.type(1, "more");
    CHECK(page.take() == "note  [3]\noverlay b.rad 4\nmore");  // and no more
}

TEST_CASE("a text that is broken stays said until it is mended, and its view is of the text before") {
    Page page;
    Tracer t = started(page);
    page.type(0, "broken");
    page.run(t);
    CHECK(page.standing() == std::vector<std::string>{"ptrace: a.rad:1: broken"});
    page.come(t.picture(2));
    page.type(0, "still broken");
    page.run(t);
    CHECK(page.standing().size() == 1);
    page.ask("/control", {}, "view -vp 1 2 3\n");
    page.run(t);
    CHECK(page.standing().size() == 1);
    CHECK(*page.s.pipe(Which::picture).look.texts[0] == "disk of a.rad");
    page.variant("keep", "B");
    CHECK(result_of(page.s, page.s.now.variants[0].look) == nullptr);  // the picture is not its own
    page.undo(), page.undo(), page.undo();
    page.run(t);
    CHECK(page.standing().size() == 1);
    page.undo();
    page.run(t);
    CHECK(page.standing().empty());
}

TEST_CASE("messages stand until they are dismissed or their cause is gone") {
    Page page({"a.rad"}, "x.regions");
    Tracer t = started(page);
    page.happen(live::Saved{"vcview: x.design: No space left"});
    page.come(t.picture(2));
    page.type(0, "a");
    page.run(t);
    CHECK(page.standing().size() == 1);
    page.happen(live::Saved{""});
    CHECK(page.standing().empty());
    page.draw(1, "desk circle view 20\n");
    page.happen(live::Said{Which::picture, "vcmetrics: x.regions:1: cannot be read"});
    CHECK(page.standing().size() == 1);
    page.disk(1, "desk circle view 30\n");
    CHECK(page.standing().empty());
    page.happen(live::Said{Which::picture, "vcmetrics: warning: something else"});
    page.happen(live::Said{Which::picture, "ptrace: same 0 "});
    CHECK(page.standing().size() == 1);
    page.ask("/dismiss", {{"number", std::to_string(page.s.messages.back().number)}});
    CHECK(page.standing().empty());
}

TEST_CASE("a place that is asked about is two numbers from 0 to 1") {
    Page page;
    Tracer t = started(page);
    CHECK(page.ask("/what", {{"x", ".25"}, {"y", "1"}}) == 204);
    CHECK(page.take() == "what 0.25 1\n");
    for (const char* wrong : {"", "x", "nan", "-.1", "1.1", ".5\nset -o x", ".5 .5", "1e999"}) {
        CHECK(page.ask("/what", {{"x", wrong}, {"y", ".5"}}) == 400);
        CHECK(page.ask("/what", {{"x", ".5"}, {"y", wrong}}) == 400);
    }
    CHECK(page.take().empty());
    page.happen(live::Said{Which::picture, "ptrace: what 0.25 1\t0\twall\tpolygon"});
    const auto answer = live::answer_what(page.s, arguments({{"x", "0.25"}, {"y", "1.0"}}));
    REQUIRE(answer);
    CHECK(answer->body == "wall\tpolygon");
}

TEST_CASE("what is typed before the first picture is in the design; a design of nothing is not written") {
    Page page;
    page.ask("/start");
    CHECK(live::design_text(page.s).empty());
    page.type(0, "typed");
    CHECK(live::design_text(page.s).find("\ntext a.rad\n\ttyped") != std::string::npos);
}

TEST_CASE("a file that another program writes counts; what was typed, and what stood there, comes back") {
    Page page;
    Tracer t = started(page);
    page.type(0, "typed");
    page.variant("keep", "A");
    page.disk(0, "of an editor");
    CHECK_FALSE(page.s.now.texts[0]);
    CHECK(page.text(0) == "of an editor");
    page.undo();
    CHECK(page.text(0) == "typed");
    page.undo(), page.undo();
    CHECK(page.text(0) == "disk of a.rad");
    page.redo();
    live::Request save{"/file", arguments({{"n", "0"}}), "typed", page.s.files[0].tag};
    save.put = true;
    page.happen(save);
    CHECK(page.written[0] == "typed");
    page.undo();
    CHECK(page.text(0) == "disk of a.rad");
}

TEST_CASE("a variant has the edit that shows it with most frames, its numbers and its picture") {
    Page page;
    Tracer t = started(page);
    page.type(0, "a");
    page.run(t, 3);
    live::Row row{{{"frame", 3}, {"edit", 1}, {"Ev", 1000}, {"Ev.lo", 900}, {"Ev.hi", 1100}}};
    page.happen(live::Measured{Which::picture, row});
    page.variant("keep", "A");
    const auto edit = [&] { return result_of(page.s, page.s.now.variants[0].look)->edit; };
    CHECK(edit() == 1);
    CHECK(result_of(page.s, page.s.now.variants[0].look)->numbers[0] == "Ev 1000 (900 to 1100)");
    CHECK(page.s.said_against == "1");
    page.type(0, "b");
    page.run(t);
    page.type(0, "a");
    page.run(t, 2);
    CHECK(edit() == 1);
    page.come(t.picture(4));
    CHECK(edit() == 3);
    CHECK(page.s.said_against == "3");
    page.variant("base", "");
    CHECK(page.s.said_against == "previous");
}

TEST_CASE("a picture that comes late is not taken for the newer edit") {
    Page page;
    Tracer t = started(page);
    page.type(0, "a");
    const image::Picture late = t.picture(9);
    page.run(t);
    page.variant("keep", "A");
    page.come(late);
    CHECK(page.s.picture->header.edit == 1);
    CHECK(result_of(page.s, page.s.now.variants[0].look)->picture->header.edit == 1);
}
