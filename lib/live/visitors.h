// SPDX-License-Identifier: BSD-3-Clause
// The open connections of the web server.  A connection that has not shown the token is a stranger: of these only the
// newest stay, and each has a few seconds for a whole question, so that no crowd of them shuts out those who know the
// token.
#pragma once
#include <chrono>
#include <cstddef>
#include <list>
#include <mutex>

namespace live {

class Visitors {
public:
    using Clock = std::chrono::steady_clock;
    static constexpr size_t most_strangers = 200;
    static constexpr auto patience = std::chrono::seconds(5);  // for a stranger's question, from its first byte or none

    struct Visitor {
        int socket;
        Clock::time_point since;  // came, or had its last answer
        bool stranger = true;
    };
    using Place = std::list<Visitor>::iterator;

    Place come(int socket);
    void answer(Place visitor);  // its question is answered
    void know(Place visitor);    // it has shown the token
    void leave(Place visitor);   // before its socket is closed
    void look();                 // ends strangers whose time is over

private:
    void end_first();
    std::mutex mutex_;
    std::list<Visitor> strangers_;  // by their time
    std::list<Visitor> others_;     // known, or ended and not gone yet
};

}  // namespace live
