// SPDX-License-Identifier: BSD-3-Clause
// Commands that arrive while frames are made: which end a picture, which wait, and that two threads share them cleanly
// (make test-sanitize runs this under the thread sanitizer).
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <thread>

#include "base/files_read.h"
#include "render/control.h"
#include "temp_folder.h"

using render::Command;
using render::Control;

namespace {

struct Fifo {
    TempFolder folder;
    std::string path = folder.name("ctl");
    int out;
    Fifo() {
        REQUIRE(mkfifo(path.c_str(), 0600) == 0);
        out = open(path.c_str(), O_RDWR);
    }
    ~Fifo() { close(out); }
    void send(const std::string& text) const { REQUIRE(write(out, text.data(), text.size()) == ssize_t(text.size())); }
};

// The edits that come within two seconds; the frames go on until there are some.
std::vector<Command> edits(Control& control, const std::string& label = "") {
    for (int k = 0; k < 200 && !control.edited(); ++k) {
        control.ends_picture(label);
        usleep(10000);
    }
    return control.take_edits();
}

}  // namespace

TEST_CASE("words of a line, and the text of an overlay that comes in pieces") {
    const Fifo fifo;
    Control control(fifo.path, false);
    fifo.send("  view  -vp 1 2 3 \n");
    auto all = edits(control);
    REQUIRE(all.size() == 1);
    CHECK(all[0].word == "view");
    CHECK(all[0].rest == "-vp 1 2 3");
    fifo.send("overlay a file.rad 6\nvoi");
    usleep(50000);
    CHECK(!control.ends_picture(""));
    CHECK(!control.edited());
    fifo.send("d\n\nnext\n");
    all = edits(control);
    REQUIRE(all.size() == 1);
    CHECK(all[0].rest == "a file.rad");
    CHECK(all[0].text == "void\n\n");
    for (int k = 0; k < 200 && !control.ends_picture("desk"); ++k) usleep(10000);  // "next" is of the picture after it
}

TEST_CASE("an edit waits from its arrival until it is taken; next with another label is not for this picture") {
    const Fifo fifo;
    Control control(fifo.path, false);
    CHECK(!control.edit_waits());
    fifo.send("next other\nset -ab 3\n");
    for (int k = 0; k < 200 && !control.edited(); ++k) {
        CHECK(!control.ends_picture("desk"));
        usleep(10000);
    }
    CHECK(control.take_edits().size() == 1);
    CHECK(!control.edit_waits());
}

TEST_CASE("a next behind an edit is of the picture that goes on, where the edit fails") {
    const Fifo fifo;
    Control control(fifo.path, false);
    fifo.send("view 1\nview 2\nnext\nview 3\n");
    CHECK(edits(control).size() == 2);
    usleep(300000);
    CHECK(control.take_edits().empty());
    CHECK(control.ends_picture(""));
}

TEST_CASE("edits are not heard while a preview is made for the one before, but for a time, or when go ends them") {
    const Fifo fifo;
    Control control(fifo.path, false);
    const auto soon = Control::Clock::now() + std::chrono::milliseconds(600);
    const auto late = Control::Clock::now() + std::chrono::hours(1);
    control.set_preview(true, soon);
    fifo.send("view 1\n");
    usleep(200000);
    if (Control::Clock::now() < soon) CHECK_FALSE(control.edit_waits());
    for (int k = 0; k < 500 && !control.edit_waits(); ++k) usleep(10000);
    CHECK(control.edit_waits());
    CHECK(edits(control).size() == 1);
    control.set_preview(true, late);
    fifo.send("view 2\n");
    usleep(200000);
    CHECK_FALSE(control.edit_waits());
    control.ends_picture("");  // its first frame
    CHECK_FALSE(control.edited());
    CHECK(control.edit_waits());
    control.set_preview(true, late);
    fifo.send("go\n");
    for (int k = 0; k < 500 && !control.edit_waits(); ++k) usleep(10000);
    CHECK(edits(control).size() == 2);
}

TEST_CASE("files need not be read to the end where others are asked for, which an equal text does not") {
    const Fifo fifo;
    TempFolder folder;
    const std::string name = folder.holding("a.rad", "void"), other = folder.holding("b.rad", "void");
    Control control(fifo.path, false);
    control.set_preview(false, {}, base::with_overlay({}, name, "text"));
    fifo.send("overlay " + name + " 4\ntextoverlay " + other + " -\nview 1\n");
    for (int k = 0; k < 500 && !control.edit_waits(); ++k) usleep(10000);
    usleep(100000);
    CHECK_FALSE(control.files_wait());
    fifo.send("overlay " + name + " 4\nelse");
    for (int k = 0; k < 500 && !control.files_wait(); ++k) usleep(10000);
    CHECK(control.files_wait());
}

TEST_CASE("pause holds a frame at once, and a picture until go; go makes an edit of a preview") {
    const Fifo fifo;
    Control control(fifo.path, false);
    const auto wishes = [&](device::Wish wish) {
        for (int k = 0; k < 500 && control.wish() != wish; ++k) usleep(10000);
        return control.wish() == wish;
    };
    fifo.send("pause\n");
    CHECK(wishes(device::Wish::wait));  // of the frame in work
    fifo.send("what .5 .5\n");
    CHECK(wishes(device::Wish::go_on));
    std::thread later([&] {
        usleep(200000);
        fifo.send("go\n");
    });
    CHECK(!control.ends_picture(""));
    later.join();
    CHECK(!control.edited());
    control.set_preview(true);
    fifo.send("go\n");
    const auto all = edits(control);
    REQUIRE(all.size() == 1);
    CHECK(all[0].word == "go");
}

TEST_CASE("a file that was read and has changed is the command scene, once") {
    const Fifo fifo;
    TempFolder folder;
    const std::string name = folder.holding("a.rad", "void");
    base::FilesRead files;
    base::note_file_read(files, name);
    Control control(fifo.path, true);
    control.watch(files);
    usleep(100000);
    std::ofstream(name) << "void glow";
    const auto all = edits(control);
    REQUIRE(all.size() == 1);
    CHECK(all[0].word == "scene");
    usleep(200000);
    control.ends_picture("");
    CHECK(!control.edited());
}

TEST_CASE("a file that an editor has emptied, to write it, counts as gone; one that was always empty does not") {
    base::FilesRead files;
    TempFolder folder;
    const std::string name = folder.holding("a.rad", "void"), empty = folder.holding("b.rad", "");
    base::note_file_read(files, name);
    base::note_file_read(files, empty);
    CHECK(!base::files_now(files).gone);
    std::ofstream(name).close();
    CHECK(base::files_now(files).gone);
    std::ofstream(name) << "void glow";
    CHECK(!base::files_now(files).gone);
    CHECK(base::files_now(files).changed);
}

TEST_CASE("a storm of commands loses none and keeps their order") {
    const Fifo fifo;
    Control control(fifo.path, true);
    constexpr int count = 2000;
    std::thread writer([&] {
        for (int k = 0; k < count; ++k) fifo.send("view " + std::to_string(k) + "\n");
    });
    int seen = 0;
    for (int k = 0; seen < count && k < 20000; ++k) {
        control.set_preview(k % 3 == 0);
        control.ends_picture("");
        (void)control.edit_waits();
        for (const Command& c : control.take_edits()) CHECK(c.rest == std::to_string(seen++));
        usleep(500);
    }
    writer.join();
    CHECK(seen == count);
}
