// SPDX-License-Identifier: BSD-3-Clause
// Lines that arrive at ptrace -control, in pieces, and what they change of the view and the options.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>

#include "../../tools/ptrace/edits.h"
#include "fuzz_try.h"
#include "render/command_reader.h"

namespace {

const std::string& fifo() {
    static const std::string path = [] {
        std::string made = "/tmp/fuzz_control." + std::to_string(getpid());
        mkfifo(made.c_str(), 0600);
        return made;
    }();
    return path;
}

Run run() {
    Run run;
    Options& opt = run.opt;
    opt.control = fifo();
    opt.view.vh = opt.view.vv = 180;
    opt.view.type = 'a';
    opt.nx = opt.ny = 16;
    opt.views.push_back({"", {opt.view, opt.nx, opt.ny}});
    return run;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    render::CommandReader reader(fifo());
    const int out = open(fifo().c_str(), O_WRONLY | O_NONBLOCK);
    if (out < 0) return 0;
    Run now = run();
    for (size_t at = 0; at < size;) {
        const size_t piece = std::min(size - at, size_t(1 + (data[at] & 63) * 16));
        if (write(out, data + at, piece) != ssize_t(piece)) break;
        at += piece;
        bool more = true;
        while (more) {
            more = false;
            try_to([&] {
                const auto command = reader.next();
                more = bool(command);
                if (command && command->word != "next" && command->word != "pause")
                    now = edited(now, {*command}, 0).run;
            });
        }
    }
    close(out);
    return 0;
}
