// SPDX-License-Identifier: BSD-3-Clause
// Edits as values (tools/ptrace/edits.h): lists of commands, and the run that they make.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include "edits.h"
#include "temp_folder.h"

namespace {

using Commands = std::vector<render::Command>;

Run run() {
    Run run;
    run.opt.control = "ctl";
    run.opt.nx = run.opt.ny = 64;
    run.opt.views = {{"", {run.opt.view, 64, 64}}};
    return run;
}

// Carried out, and the picture begins anew.
Run after(const Run& before, const Commands& commands) {
    const Edited e = edited(before, commands, 0);
    CHECK(e.refused.empty());
    CHECK(e.work != Work::nothing);
    return begun(e.run);
}

}  // namespace

TEST_CASE("no command is no work, and changes nothing") {
    const Edited e = edited(run(), {}, 0);
    CHECK(e.work == Work::nothing);
    CHECK(e.run.edits == 0);
    CHECK(e.run.edited == "start");
}

TEST_CASE("a view asks for a plan, a scene for its files, both for the files") {
    CHECK(edited(run(), {{"view", "-vp 1 2 3"}}, 0).work == Work::view);
    CHECK(edited(run(), {{"scene", ""}}, 0).work == Work::files);
    CHECK(edited(run(), {{"scene", ""}, {"set", "-ab 2"}}, 0).work == Work::files);
    CHECK(edited(run(), {{"note", "words"}}, 0).work == Work::nothing);
}

TEST_CASE("commands add up; the picture is named by the last one and counted") {
    const Run r = after(run(), {{"view", "-vp 1 2 3"}, {"set", "-ab 2"}, {"size", "20 10"}});
    CHECK(r.opt.views[0].render_view.view.vp.z == 3);
    CHECK(r.opt.render.ab == 2);
    CHECK(r.opt.views[0].render_view.ny == 10);
    CHECK(r.edits == 1);
    CHECK(r.edited == "size");
    CHECK(after(r, {{"view", "-vp 1 2 4"}}).edits == 2);
}

TEST_CASE("what is no command is said, and the others are carried out") {
    const Edited e = edited(run(), {{"jump", "up"}, {"view", "-vp 1 2 3"}, {"set", "-ab x"}, {"set", "-o x.hdr"}}, 0);
    REQUIRE(e.refused.size() == 3);
    CHECK(e.refused[0] == "ctl: \"jump up\" is not a command");
    CHECK(e.refused[2].find("a scene may not set it") != std::string::npos);
    CHECK(e.work == Work::view);
    CHECK(e.run.last == "view");
    CHECK(edited(run(), {{"jump", "up"}}, 0).work == Work::nothing);
}

TEST_CASE("a picture that does not begin with frame 0 is not edited") {
    Run late = run();
    late.opt.first = 5;
    const Edited e = edited(late, {{"view", "-vp 1 2 3"}}, 0);
    CHECK(e.work == Work::nothing);
    CHECK(e.refused.size() == 1);
}

TEST_CASE("a preview stays one until go, whose picture has the name of what was changed meanwhile") {
    Run r = after(run(), {{"preview", "-vp 1 2 3"}});
    CHECK(r.opt.preview);
    CHECK(r.edited == "preview");
    r = after(r, {{"preview", "-vp 1 2 4"}});
    const Run full = after(r, {{"go", ""}});
    CHECK(!full.opt.preview);
    CHECK(full.edited == "view");
    CHECK(full.edits == 3);
    Run changed = r;
    changed.changed = "overlay";
    CHECK(after(changed, {{"go", ""}}).edited == "overlay");
}

TEST_CASE("the words of a note are with the next full picture that begins, and with no other") {
    Run r = edited(run(), {{"note", "blind: 20 to 21"}}, 0).run;
    r = after(r, {{"preview", "-vp 1 2 3"}});
    CHECK(r.edited == "preview");
    r = after(r, {{"view", "-vp 1 2 3"}});
    CHECK(r.edited == "view blind: 20 to 21");
    CHECK(after(r, {{"view", "-vp 1 2 4"}}).edited == "view");
    CHECK(gone_on(edited(run(), {{"note", "nothing new"}}, 0).run).note.empty());
}

TEST_CASE("a text in place of a file is a part of the run; the run before has its own") {
    TempFolder folder;
    const std::string file = folder.holding("blind.rad", "void plastic m 0 0 5 1 1 1 0 0\n");
    const Run before = run();
    render::Command overlay{"overlay", file};
    overlay.text = "void glow m 0 0 4 1 1 1 0\n";
    const Run r = after(before, {overlay});
    REQUIRE(r.opt.files.overlays.size() == 1);
    CHECK(*r.opt.files.overlays[0].text == *overlay.text);
    CHECK(before.opt.files.overlays.empty());
    CHECK(after(r, {{"overlay", file + " -"}}).opt.files.overlays.empty());
    overlay.rest = folder.name("gone.rad");
    CHECK(edited(r, {overlay}, 0).refused.size() == 1);
    Run exec = before;
    exec.opt.files.exec = true;
    CHECK(edited(exec, {{"overlay", file, "!rm x"}}, 0).refused.size() == 1);
}
