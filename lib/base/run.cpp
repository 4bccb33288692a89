// SPDX-License-Identifier: BSD-3-Clause
// What every main() shares: one place that catches, the exit status, signals, stdout that may close.
// A signal must not leave half-written files behind: writers register their temporary names here and
// the handler (async-signal-safe calls only) removes them before it leaves with status 3.
#include "base/run.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

#include "base/error.h"
#include "base/stop.h"
#include "base/tempfile.h"
#include "base/warnings.h"

namespace base {
namespace {

constexpr int slots = 16, longest = 4096;
char temp_names[slots][longest];
std::atomic<int> temp_state[slots];  // 0 free, 1 being written, 2 in use

void remove_temp_files() {
    for (int i = 0; i < slots; ++i)
        if (temp_state[i] == 2) unlink(temp_names[i]);
}

void on_signal(int) {
    if (take_stop_request()) return;
    remove_temp_files();
    _exit(3);
}

}  // namespace

void handle_signals() {
    struct sigaction act = {};
    act.sa_handler = on_signal;
    act.sa_flags = SA_RESTART;  // a program that finishes its frame reads and writes on
    for (int s : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction old = {};
        sigaction(s, nullptr, &old);
        if (old.sa_handler != SIG_IGN) sigaction(s, &act, nullptr);  // nohup stays nohup
    }
}

namespace {

void say(const char* tool, const std::string& text) { std::fprintf(stderr, "%s: %s\n", tool, text.c_str()); }

void say_counted_warnings(const char* tool, bool loud) {
    for (const auto& [fact, count] : take_warnings())
        if (loud && count > 1) say(tool, "warning: " + fact + " (" + std::to_string(count) + " times)");
}

int run_caught(const char* tool, const std::function<int()>& body) {
    try {
        const int status = body();
        flush_stdout();
        return stop_requested() ? 3 : status;
    } catch (const ClosedPipe&) {
        return stop_requested() ? 3 : 0;
    } catch (const Error& e) {
        say(tool, e.text);
        return int(e.kind);
    } catch (const std::bad_alloc&) {
        say(tool, "memory: not enough");
        return 2;
    } catch (const std::exception& e) {
        say(tool, std::string("internal: ") + e.what());
        return 2;
    }
}

}  // namespace

int run(const char* tool, const std::function<int()>& body) {
    handle_signals();
    signal(SIGPIPE, SIG_IGN);  // a closed reader is an EPIPE, handled where it happens
    set_warning_sink([tool](const std::string& text) { say(tool, "warning: " + text); });
    const int status = run_caught(tool, body);
    try {
        flush_stdout();  // what was printed before an error
    } catch (...) {
    }
    say_counted_warnings(tool, warnings_are_shown());
    return status;
}

TempFile::TempFile(const std::string& target) : target_(target) {
    struct stat info = {};
    if (stat(target.c_str(), &info) == 0) {
        if (!S_ISREG(info.st_mode)) {  // /dev/null, a FIFO: nothing to rename over
            path_ = target;
            direct_ = true;
            return;
        }
        if (char* real = realpath(target.c_str(), nullptr)) {  // keep a symbolic link, replace what it names
            target_ = real;
            free(real);
        }
    }
    name_temp(target_);
}

void TempFile::name_temp(const std::string& target) {
    const size_t slash = target.rfind('/');
    const std::string folder = slash == std::string::npos ? "" : target.substr(0, slash + 1);
    const std::string name = slash == std::string::npos ? target : target.substr(slash + 1);
    static std::atomic<int> serial{0};
    path_ = folder + "." + name + "." + std::to_string(getpid()) + "." + std::to_string(serial++) + ".tmp";
    for (int i = 0; i < slots && slot_ < 0 && path_.size() < longest; ++i) {
        int free = 0;
        if (!temp_state[i].compare_exchange_strong(free, 1)) continue;
        std::strcpy(temp_names[i], path_.c_str());
        temp_state[i] = 2;
        slot_ = i;
    }
}

TempFile::~TempFile() {
    if (!kept_ && !direct_) unlink(path_.c_str());
    if (slot_ >= 0) temp_state[slot_] = 0;
}

void TempFile::keep() {
    errno = 0;
    if (!direct_ && std::rename(path_.c_str(), target_.c_str()) != 0) fail_system(target_, "cannot be written");
    kept_ = true;
}

namespace {

std::string pending;  // for stdout; small pieces go together

// By write() itself: stdio loses bytes when a signal interrupts it, and a library's handler may (stop.h).
void write_all(const char* data, size_t bytes) {
    while (bytes) {
        const ssize_t n = write(1, data, bytes);
        if (n < 0 && errno == EINTR) continue;
        if (n < 0 && errno == EPIPE) throw ClosedPipe{};
        if (n < 0) fail_system("stdout", "cannot be written");
        data += n;
        bytes -= size_t(n);
    }
}

}  // namespace

void write_stdout(const void* data, size_t bytes) {
    const char* from = static_cast<const char*>(data);
    if (pending.size() + bytes <= 1 << 16) {
        pending.append(from, bytes);
        return;
    }
    flush_stdout();
    write_all(from, bytes);
}

void flush_stdout() {
    const std::string now = std::move(pending);
    pending.clear();  // whatever becomes of it
    write_all(now.data(), now.size());
}

bool stdout_is_terminal() { return isatty(1); }

void leave_stdout() {
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (nowhere < 0) return;
    dup2(nowhere, 1);
    close(nowhere);
}

bool stdout_is_closed() {
    struct pollfd out = {1, 0, 0};
    return poll(&out, 1, 0) > 0 && (out.revents & POLLERR);
}

std::string command_line(int argc, char** argv) {
    std::string line;
    for (int i = 0; i < argc; ++i) {
        const std::string word = argv[i];
        const bool plain = !word.empty() && word.find_first_not_of(
                                                "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                                "0123456789-_+=.,:/@%^") == std::string::npos;
        if (i) line += ' ';
        if (plain) {
            line += word;
            continue;
        }
        line += '\'';
        for (char c : word) {
            if (c == '\'') line += "'\\''";
            else line += c == '\n' || c == '\r' || c == '\t' ? ' ' : c;  // a header line is one line
        }
        line += '\'';
    }
    return line;
}

}  // namespace base
