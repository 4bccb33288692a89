// SPDX-License-Identifier: BSD-3-Clause
// Messages of the programs of a pipe that we have not started: their standard error is a FIFO that they share.
#pragma once
#include <string>
#include <thread>
#include "live/child.h"
#include "live/live.h"

namespace live {

class Messages {
public:
    Messages(const std::string& fifo, Live& live);  // throws base::Error (system)
    ~Messages();                                    // what has been written is passed on before
    Messages(const Messages&) = delete;
    int descriptor() const { return fifo_.fd; }  // for a program that we start

private:
    const End fifo_;
    std::thread thread_;
};

}  // namespace live
