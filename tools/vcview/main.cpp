// SPDX-License-Identifier: BSD-3-Clause
// vcview - shows the pictures of a stream and the lines of metrics in a browser while they pass.  The bytes go on as
// they came: to the program after "--", whose output and status become vcview's, or to the standard output. See
// man/vcview.1.
#include <unistd.h>

#include <cerrno>
#include <optional>
#include <thread>

#include "base/descriptor.h"
#include "base/error.h"
#include "base/run.h"
#include "base/shutdown.h"
#include "live/child.h"
#include "live/framer.h"
#include "live/live.h"
#include "live/messages.h"
#include "live/outbox.h"
#include "live/programs.h"
#include "live/server.h"
#include "options.h"
#include "own.h"

namespace {

constexpr size_t block_size = 1 << 18;

// The child's output to ours, and line by line to the page.
void pass_lines(int from, live::Live& page) {
    bool open = true;  // is our own output read?
    live::read_lines(from, [&](const std::string& line) {
        const std::string whole = line + "\n";
        open = open && base::write_all(1, whole.data(), whole.size());
        page.put_line(live::Which::picture, line);
        return true;
    });
}

// False: nothing more is to be passed on.
bool wait_for_pictures() {
    try {
        return base::wait_for_input(0);
    } catch (const base::ClosedPipe&) {
        return false;
    }
}

// Standard input to the descriptor until either ends; what passes is looked at afterwards.
void pass_pictures(int to, live::Framer& framer, live::Live& page) {
    std::vector<char> block(block_size);
    base::ends_with_reader(to);
    bool told = false;
    while (wait_for_pictures()) {
        const ssize_t n = base::read_some(0, block.data(), block.size());
        if (n < 0) base::fail_system("stdin", "cannot be read");
        if (n == 0) return;
        errno = 0;
        if (!base::write_all(to, block.data(), size_t(n))) {
            if (errno == EPIPE) return;
            base::fail_system("stdout", "cannot be written");
        }
        framer.pass(block.data(), size_t(n));
        if (told || framer.stopped().empty()) continue;
        told = true;
        const std::string why = framer.stopped() + ": the page shows no more";
        base::warn("stdin", why);
        page.put(live::Said{live::Which::picture, "vcview: warning: stdin: " + why});
    }
}

// A stream that others render.
int show_stream(const Options& options) {
    live::Live page(options.files);
    live::Outbox commands;
    page.begin([&](live::State& s) {
        if (!options.server.control.empty()) s.pipe(live::Which::picture).stage = live::Pipe::Stage::asleep;
        s.control = options.server.control;
    });
    page.set_against(options.against);
    page.on_effect([&](const live::Effect& e) {
        if (const auto* to = std::get_if<live::ToPipe>(&e)) commands.put(to->bytes);
    });
    std::optional<live::Messages> messages;
    if (!options.messages.empty()) messages.emplace(options.messages, page);
    std::optional<live::Child> child;
    if (!options.command.empty()) child.emplace(options.command, messages ? messages->descriptor() : 2);
    const live::Server server(page, commands, options.server);
    const Shown shown(server, options.open);
    live::Framer framer([&](image::Picture p) { page.put_picture(live::Which::picture, std::move(p)); });

    int status = 0;
    if (!child) {
        pass_pictures(1, framer, page);
    } else {
        std::thread lines([&] { pass_lines(child->output(), page); });
        try {
            pass_pictures(child->input(), framer, page);
        } catch (...) {
            child->close_input();
            lines.join();
            throw;
        }
        child->close_input();
        lines.join();
        status = child->wait();
    }
    close(0);  // a program that still writes to us may end
    page.put_end(status);
    if (options.stay && page.state().picture && !base::shutdown_requested()) {
        base::leave_stdout();
        base::say_on_terminal("vcview: the pipe has ended; ^C ends the page");
        Wake().wait();
    }
    return status;
}

}  // namespace

int main(int argc, char** argv) {
    bool own = false;
    const int status = base::run("vcview", [&] {
        auto options = parse_options(argc, argv);
        if (!options) return 0;
        own = options->server.own;
        base::finish_on_signal();
        return own ? show_scene(std::move(*options)) : show_stream(*options);
    });
    return own && base::shutdown_requested() ? 0 : status;  // ended as people end it
}
