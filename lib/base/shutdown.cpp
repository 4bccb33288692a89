// SPDX-License-Identifier: BSD-3-Clause
// See shutdown.h.  The handler writes a byte into a pipe that waiting readers watch, so that no signal falls between
// the look at the flag and the wait.
// A signal must not leave half-written files or running commands behind: the handler (async-signal-safe calls only)
// removes the first and ends the others before it leaves with status 3.
#include "base/shutdown.h"

#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>

#include "base/descriptor.h"
#include "base/error.h"
#include "base/run.h"
#include "base/shell.h"
#include "base/tempfile.h"

namespace base {
namespace {

enum State { at_once, finish, asked };
std::atomic<int> state{at_once};
int wake[2] = {-1, -1};
int reader = -1;               // a descriptor that poll() passes over
std::atomic<int> end_soon{0};  // how many EndsSoon there are
constexpr unsigned patience_s = 2;

// The handler asks: true if the program will finish by itself.
bool take_shutdown_request() {
    int expected = finish;
    if (!state.compare_exchange_strong(expected, asked)) return false;
    if (end_soon > 0) alarm(patience_s);  // SIGALRM is a second signal
    const int code = errno;
    const ssize_t written = write(wake[1], "", 1);
    (void)written;  // one byte fits
    errno = code;
    return true;
}

void on_signal(int) {
    end_shell();
    if (take_shutdown_request()) return;
    remove_temp_files();
    _exit(3);
}

}  // namespace

void handle_signals() {
    signal(SIGPIPE, SIG_IGN);  // a closed reader is an EPIPE, handled where it happens
    signal(SIGXFSZ, SIG_IGN);  // a file that may not grow further is an EFBIG
    struct sigaction act = {};
    act.sa_handler = on_signal;
    act.sa_flags = SA_RESTART;  // a program that finishes its frame reads and writes on
    for (int s : {SIGINT, SIGTERM, SIGHUP, SIGALRM}) {
        struct sigaction old = {};
        sigaction(s, nullptr, &old);
        if (old.sa_handler != SIG_IGN) sigaction(s, &act, nullptr);  // nohup stays nohup
    }
}

void finish_on_signal() {
    if (wake[0] >= 0) return;
    handle_signals();
    errno = 0;
    if (!make_pipe(wake)) fail_system("pipe", "cannot be made");
    state = finish;
}

bool shutdown_requested() { return state == asked; }

EndsSoon::EndsSoon() {
    end_soon++;
    if (shutdown_requested()) alarm(patience_s);
}

EndsSoon::~EndsSoon() {
    if (--end_soon == 0) alarm(0);
}

bool wait_for_input(int descriptor) {
    if (state == at_once) return true;
    while (!shutdown_requested()) {
        struct pollfd all[3] = {{descriptor, POLLIN, 0}, {wake[0], POLLIN, 0}, {reader, 0, 0}};
        const int ready = poll(all, 3, -1);
        if (ready < 0 && errno != EINTR) return true;  // reading will tell
        if (ready < 0 || all[1].revents) continue;
        if (all[0].revents) return true;
        if (all[2].revents & POLLERR) throw ClosedPipe{};
    }
    return false;
}

void ends_with_reader(int pipe) { reader = pipe; }

}  // namespace base
