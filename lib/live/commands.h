// SPDX-License-Identifier: BSD-3-Clause
// Commands of the page for ptrace: written to its FIFO, and kept in the design once ptrace has them.
#pragma once
#include "live/answers.h"

namespace live {

struct Commanded {
    Live& live;
    const Files& files;
    const std::string& fifo;  // of ptrace -control; empty: none
};

// POST /control, /overlay, /undo and /back (server.h).
Answer answer_command(const Commanded& to, const std::string& path, const Arguments& asked, const std::string& body);

// A line for ptrace and, behind it, the text that stands for a file; nothing: the one on the disk.
std::string overlaying(const TextFile& f, const std::optional<std::string>& text);

// GET /what: what ptrace says of a place of the newest picture.  Nothing: it has not answered yet.
std::optional<Answer> answer_what(const Commanded& to, const Arguments& asked);

// Asks for the full picture where a window has asked for small ones and says no more: it may be gone.
void end_preview(const Commanded& to);

// Gives ptrace all texts of a design that was opened, once it reads its FIFO.
void give_opened(const Commanded& to);

}  // namespace live
