// SPDX-License-Identifier: BSD-3-Clause
// See shutdown.h.  Windows calls the handler in a thread of its own, for ^C and for a console that closes.  ^C reaches
// all programs of a pipe, so that whoever waits for input gets its end.
#include "base/shutdown.h"

#include <windows.h>

#include <atomic>
#include <cstdlib>

#include "base/tempfile.h"

namespace base {
namespace {

enum Phase { at_once, finish, asked };
std::atomic<int> phase{at_once};

BOOL WINAPI on_event(DWORD) {
    int expected = finish;
    if (phase.compare_exchange_strong(expected, asked)) return TRUE;
    remove_temp_files();
    std::_Exit(3);
}

}  // namespace

void handle_signals() { SetConsoleCtrlHandler(on_event, TRUE); }
void finish_on_signal() {
    int expected = at_once;
    phase.compare_exchange_strong(expected, finish);
}
bool shutdown_requested() { return phase == asked; }

EndsSoon::EndsSoon() {}
EndsSoon::~EndsSoon() {}

bool wait_for_input(int) { return !shutdown_requested(); }
void ends_with_reader(int) {}

}  // namespace base
