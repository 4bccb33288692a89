// SPDX-License-Identifier: BSD-3-Clause
// See visitors.h.
#include "live/visitors.h"

#include <sys/socket.h>

namespace live {

Visitors::Place Visitors::come(int socket) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (strangers_.size() >= most_strangers) end_first();
    return strangers_.insert(strangers_.end(), {socket, Clock::now()});
}

void Visitors::answer(Place visitor) {
    const std::lock_guard<std::mutex> lock(mutex_);
    visitor->since = Clock::now();
    if (visitor->stranger) strangers_.splice(strangers_.end(), strangers_, visitor);
}

void Visitors::know(Place visitor) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (visitor->stranger) others_.splice(others_.end(), strangers_, visitor);
    visitor->stranger = false;
}

void Visitors::leave(Place visitor) {
    const std::lock_guard<std::mutex> lock(mutex_);
    (visitor->stranger ? strangers_ : others_).erase(visitor);
}

void Visitors::look() {
    const std::lock_guard<std::mutex> lock(mutex_);
    while (!strangers_.empty() && Clock::now() - strangers_.front().since > patience) end_first();
}

// The web server sees the end of the connection, and closes it.
void Visitors::end_first() {
    const Place first = strangers_.begin();
    shutdown(first->socket, SHUT_RDWR);
    first->stranger = false;
    others_.splice(others_.end(), strangers_, first);
}

}  // namespace live
