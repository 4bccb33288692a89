// SPDX-License-Identifier: BSD-3-Clause
// The lines of ptrace -control as commands.
#pragma once
#include <chrono>
#include <optional>
#include <string>

#include "base/command_pipe.h"

namespace render {

// One line.
struct Command {
    std::string word, rest;                          // the first word of the line, and what follows it
    std::optional<std::string> text = std::nullopt;  // of "overlay FILE BYTES", whose rest is FILE

    std::string file() const {  // of an overlay, also of one without a text: "FILE -"
        return text ? rest : rest.substr(0, rest.find_last_not_of(" \t", rest.size() - 2) + 1);
    }
    bool reads_files() const { return word == "scene" || word == "overlay"; }
};

class CommandReader {
public:
    explicit CommandReader(const std::string& fifo) : pipe_(fifo) {}
    // The next command of which all has arrived.  Throws Error for a line that is too long, and for a text of an
    // overlay that has not arrived for ten seconds; the lines after it are read.
    std::optional<Command> next();
    void wait(int ms) const { pipe_.wait(ms); }

private:
    base::CommandPipe pipe_;
    std::optional<Command> overlay_;  // whose text has not arrived yet
    long overlay_bytes_ = 0;
    std::chrono::steady_clock::time_point overlay_since_;
};

}  // namespace render
