// SPDX-License-Identifier: BSD-3-Clause
// The frame of every main(): one place that catches, the exit status, signals, stdout that may close.
// A signal must not leave half-written files or running commands behind: the handler (async-signal-safe calls only)
// removes the first and ends the others before it leaves with status 3.
#include "base/run.h"

#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <new>

#include "base/descriptor.h"
#include "base/error.h"
#include "base/failed_before.h"
#include "base/memory.h"
#include "base/printable.h"
#include "base/shell.h"
#include "base/shutdown.h"
#include "base/tempfile.h"
#include "base/warnings.h"

namespace base {
namespace {

// Buffer of write_stdout(), so that many small lines make one write.  Not stdio, which loses bytes when a
// signal interrupts it, and a library's handler may (shutdown.h).
std::string pending;
constexpr size_t most_pending = 1 << 16;

// Writes the buffer and then these bytes in one go, so that a picture and its header wake the reader once.
void write_now(const void* data, size_t bytes) {
    const std::string before = std::move(pending);
    pending.clear();  // whatever becomes of it
    if (write_all(1, before.data(), before.size(), data, bytes)) return;
    if (errno == EPIPE) throw ClosedPipe{};
    fail_system("stdout", "cannot be written");
}

void on_signal(int) {
    end_shell();
    if (take_shutdown_request()) return;
    remove_temp_files();
    _exit(3);
}

}  // namespace

void handle_signals() {
    struct sigaction act = {};
    act.sa_handler = on_signal;
    act.sa_flags = SA_RESTART;  // a program that finishes its frame reads and writes on
    for (int s : {SIGINT, SIGTERM, SIGHUP, SIGALRM}) {
        struct sigaction old = {};
        sigaction(s, nullptr, &old);
        if (old.sa_handler != SIG_IGN) sigaction(s, &act, nullptr);  // nohup stays nohup
    }
}

namespace {

void say(const char* tool, const std::string& text) { base::say(std::string(tool) + ": " + printable(text)); }

void say_counted_warnings(const char* tool, bool loud) {
    for (const auto& [fact, count] : take_warnings())
        if (loud && count > 1) say(tool, "warning: " + fact + " (" + std::to_string(count) + " times)");
}

bool marks_failure = false;

bool stdout_is_pipe() {
    struct stat info = {};
    return fstat(1, &info) == 0 && S_ISFIFO(info.st_mode);
}

// In place of a further picture.
void write_mark() {
    if (!marks_failure || !stdout_is_pipe()) return;
    constexpr char mark[] = "#?RADIANCE\nFAILED=\n\n";
    try {
        write_stdout(mark, sizeof mark - 1);
        flush_stdout();
    } catch (...) {}  // there is no reader
}

int run_caught(const char* tool, const std::function<int()>& body) {
    const auto failed = [&](const std::string& text, int status) {
        try {
            flush_stdout();  // what was right before the failure
        } catch (...) {}
        if (!text.empty()) say(tool, text);
        write_mark();
        return status;
    };
    try {
        const int status = body();
        flush_stdout();
        return shutdown_requested() ? 3 : status;
    } catch (const ClosedPipe&) {
        return shutdown_requested() ? 3 : 0;
    } catch (const FailedBefore& e) {
        return failed("", int(e.kind));
    } catch (const Error& e) {
        return failed(e.text, int(e.kind));
    } catch (const std::bad_alloc&) {
        return failed("memory: not enough", 2);
    } catch (const std::exception& e) {
        return failed(std::string("internal: ") + e.what(), 2);
    }
}

// The stack that the limits of our readers need (expressions nested a thousand deep): the usual default of systems.
constexpr size_t enough_stack = size_t(8) << 20;

void* call(void* body) {
    (*static_cast<const std::function<void()>*>(body))();
    return nullptr;
}

// Calls body here, or, where `ulimit -s` leaves less stack, in a thread with a stack of its own.  It must not throw.
void with_enough_stack(const std::function<void()>& body) {
    struct rlimit limit = {};
    if (getrlimit(RLIMIT_STACK, &limit) != 0 || limit.rlim_cur >= enough_stack) return body();
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, enough_stack);
    pthread_t thread;
    const bool started = pthread_create(&thread, &attributes, call, const_cast<std::function<void()>*>(&body)) == 0;
    pthread_attr_destroy(&attributes);
    if (started) pthread_join(thread, nullptr);
    else body();
}
}  // namespace

void mark_failure() { marks_failure = true; }

int run(const char* tool, const std::function<int()>& body) {
    keep_freed_memory();
    handle_signals();
    signal(SIGPIPE, SIG_IGN);  // a closed reader is an EPIPE, handled where it happens
    signal(SIGXFSZ, SIG_IGN);  // a file that may not grow further is an EFBIG
    set_warning_sink([tool](const std::string& text) { say(tool, "warning: " + text); });
    int status = 2;
    with_enough_stack([&] { status = run_caught(tool, body); });
    say_counted_warnings(tool, warnings_are_shown());
    return status;
}

void write_stdout(const void* data, size_t bytes) {
    if (bytes > most_pending) return write_now(data, bytes);
    if (pending.size() + bytes > most_pending) flush_stdout();
    pending.append(static_cast<const char*>(data), bytes);
}

bool stdout_is_terminal() { return isatty(1); }

bool stdin_is_terminal() { return isatty(0); }

void say(const std::string& text) { std::fprintf(stderr, "%s%s\n", isatty(2) ? "\r\033[K" : "", text.c_str()); }

void say_on_terminal(const std::string& text) {
    if (isatty(2)) say(text);
}

bool stdout_is_file() {
    struct stat info = {};
    return fstat(1, &info) == 0 && S_ISREG(info.st_mode);
}

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

void flush_stdout() { write_now(nullptr, 0); }

std::string command_line(const std::vector<std::string>& words) {
    std::string line;
    for (const std::string& word : words) {
        const bool plain = !word.empty() && word.find_first_not_of(
                                                "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                                "0123456789-_+=.,:/@%^") == std::string::npos;
        if (&word != words.data()) line += ' ';
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
