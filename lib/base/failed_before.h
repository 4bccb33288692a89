// SPDX-License-Identifier: BSD-3-Clause
// One error gives one line: a program of the pipe that fails says why and marks its stream; the programs behind it take
// the mark for an error that has been told, and pass it on.
#pragma once
#include "base/error.h"

namespace base {

struct FailedBefore : Error {
    explicit FailedBefore(std::string place)
        : Error(Kind::input, std::move(place), "the program before it in the pipe has failed") {}
};

// In main(): what this program writes to a pipe are pictures, whose header may be the mark (luxpipe-stream(5)).
void mark_failure();

}  // namespace base
