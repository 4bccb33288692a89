// SPDX-License-Identifier: BSD-3-Clause
// Messages of the programs of the pipe: their standard error is a FIFO that they share.  Its lines go on to our own
// standard error, and to the page.
#pragma once
#include <atomic>
#include <string>
#include <thread>
#include "live/fifo.h"
#include "live/live.h"

namespace live {

// A line to our standard error and to the page.
void pass_on(const std::string& line, Live& live);

class Messages {
public:
    Messages(const std::string& fifo, Live& live);  // throws base::Error (system)
    ~Messages();                                    // what has been written is passed on before
    Messages(const Messages&) = delete;
    int descriptor() const { return lines_.descriptor(); }  // for a program that we start

private:
    void listen();
    void take_lines();
    void take(const std::string& line);
    Live& live_;
    FifoLines lines_;
    std::atomic<bool> ends_{false};
    std::thread thread_;
};

}  // namespace live
