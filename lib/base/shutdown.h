// SPDX-License-Identifier: BSD-3-Clause
// Cooperative shutdown on SIGINT, SIGTERM and SIGHUP (base::run()).  At first a signal ends a program at once (status
// 3). A program that works frame by frame calls finish_on_signal(): from then on the first signal only asks.  It
// finishes the current frame, writes what there is and returns; run() gives status 3.  A second signal ends at once.
#pragma once

namespace base {

void finish_on_signal();
bool shutdown_requested();

// Waits until the descriptor has bytes or has ended; false: a signal asked to stop before that.  Throws ClosedPipe
// where the reader of ends_with_reader() has ended meanwhile.
bool wait_for_input(int descriptor);
// The program is of no use when nobody reads this pipe any more, also while nothing arrives that it could write.
void ends_with_reader(int pipe);

// While one lives the program may be where it cannot finish (inside a driver's call): it is then given two seconds from
// the first signal on, and ends at once.
class EndsSoon {
public:
    EndsSoon();
    ~EndsSoon();
    EndsSoon(const EndsSoon&) = delete;
};

// run() puts our handler in place by it.  finish_on_signal() does so again, for libraries bring their own (LLVM behind
// PoCL, which does without SA_RESTART and hands the signal on to the handler before it).
void handle_signals();

}  // namespace base
