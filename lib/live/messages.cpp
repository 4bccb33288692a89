// SPDX-License-Identifier: BSD-3-Clause
// See messages.h.
#include "live/messages.h"

#include <poll.h>

#include "base/descriptor.h"
#include "base/split.h"

namespace live {

void pass_on(const std::string& line, Live& live) {
    const std::string whole = line + "\n";
    base::write_all(2, whole.data(), whole.size());
    live.change([&](Design& d) { d.tell(line); });
}

Messages::Messages(const std::string& fifo, Live& live) : live_(live), lines_(fifo), thread_([this] { listen(); }) {}

Messages::~Messages() {
    ends_ = true;
    thread_.join();
    take_lines();
    take(lines_.rest());
}

void Messages::listen() {
    while (!ends_) {
        pollfd one{lines_.descriptor(), POLLIN, 0};
        if (poll(&one, 1, 200) > 0) take_lines();
    }
}

void Messages::take_lines() {
    for (const std::string& line : lines_.read()) take(line);
}

void Messages::take(const std::string& line) {
    if (base::begins_with(line, "ptrace: what ")) return live_.put_seen(line);
    if (!line.empty()) pass_on(line, live_);
}

}  // namespace live
