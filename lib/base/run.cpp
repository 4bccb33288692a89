// SPDX-License-Identifier: BSD-3-Clause
// The frame of every main(): one place that catches, the exit status, signals, stdout that may close.
#include "base/run.h"

#include <cerrno>
#include <cstdio>
#include <new>

#include "base/descriptor.h"
#include "base/error.h"
#include "base/failed_before.h"
#include "base/file_status.h"
#include "base/memory.h"
#include "base/printable.h"
#include "base/process.h"
#include "base/shutdown.h"
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

void say(const char* tool, const std::string& text) { base::say(std::string(tool) + ": " + printable(text)); }

void say_counted_warnings(const char* tool, bool loud) {
    for (const auto& [fact, count] : take_warnings())
        if (loud && count > 1) say(tool, "warning: " + fact + " (" + std::to_string(count) + " times)");
}

bool marks_failure = false;

// In place of a further picture.
void write_mark() {
    if (!marks_failure || status_of(1).kind != FileKind::pipe) return;
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

}  // namespace

void mark_failure() { marks_failure = true; }

int run(const char* tool, const std::function<int()>& body) {
    keep_freed_memory();
    handle_signals();
    ready_standard_files();
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

bool stdout_is_terminal() { return is_terminal(1); }

bool stdin_is_terminal() { return is_terminal(0); }

void say(const std::string& text) { std::fprintf(stderr, "%s%s\n", is_terminal(2) ? "\r\033[K" : "", text.c_str()); }

void say_on_terminal(const std::string& text) {
    if (is_terminal(2)) say(text);
}

bool stdout_is_file() { return status_of(1).is_ordinary(); }

bool stdout_is_closed() { return has_no_reader(1); }

void leave_stdout() { lead_nowhere(1); }

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
