// SPDX-License-Identifier: BSD-3-Clause
// Lines of text that arrive over a FIFO while a program works (ptrace -control), and how one is sent.
#pragma once
#include <optional>
#include <string>

namespace base {

class CommandPipe {
public:
    // Throws Error (system) for what is not a FIFO that may be read and written.  It is opened for both, so that it
    // does not end when a writer leaves.
    explicit CommandPipe(const std::string& path);
    ~CommandPipe();
    CommandPipe(const CommandPipe&) = delete;

    // A whole line that has arrived, without its end; nothing: there is none yet.  Throws Error (place: the path) for
    // one of more than 64 KiB, which is lost.
    std::optional<std::string> line();
    // So many bytes behind the last line, if all of them have arrived.
    std::optional<std::string> bytes(size_t count);
    void wait(int ms) const;  // until something arrives, a signal comes or the time is over
    const std::string& path() const { return path_; }

private:
    bool read_more();
    std::string path_;
    int fd_;
    std::string waiting_;    // what has been read, and not yet taken
    bool too_long_ = false;  // the line whose end is awaited
};

// Sends one line to the reader of the FIFO.  Throws Error (system) where it has none.
void send_command(const std::string& path, const std::string& line);

}  // namespace base
