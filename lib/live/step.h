// SPDX-License-Identifier: BSD-3-Clause
// The live page as a function: what happens makes the next state, and says what is to be done.  Without threads,
// descriptors or a clock, so that any order of events can be tried (tests/unit/live_step_test.cpp); live.h is the loop
// around it.
#pragma once
#include <functional>
#include <variant>
#include "live/rows.h"
#include "live/state.h"

namespace live {

struct Answer {
    unsigned status = 200;
    std::string type = "application/json";
    std::string body = {};
    std::string tag = {};  // of a file
};
Answer plain(unsigned status, const std::string& text);

// The value of an argument of the question; empty if it is not there.
using Arguments = std::function<std::string(const char* name)>;
std::string place_of(const Arguments& arguments);  // "0.25 1": x and y, fractions of the picture; empty: they are none

// ---- what happens

struct Request {  // POST, or PUT of a file
    std::string path;
    Arguments arguments;
    std::string body = {}, tag = {};
    bool put = false;
    std::optional<Answer> deaf = {};  // why no program can be told anything
};
struct Came {
    Which which;
    std::shared_ptr<const image::Picture> picture;
};
struct Measured {
    Which which;
    Row row;
};
struct Said {  // on the standard error
    Which which;
    std::string line;
};
struct FileIs {
    size_t n;
    FileNow now;
};
struct PointsChanged {};
struct Drawn {  // the plan, with so many changes of its points
    size_t points;
};
struct Saved {
    std::string trouble;  // empty: the design is in its file
};
struct Listens {  // somebody reads, or nobody any more
    Which which;
    bool yes;
};
struct Ended {
    Which which;
    std::string what;  // "ptrace was ended by signal 9"; empty: they have said why
    int status;        // of the last that failed
};
struct Tick {
    bool watched = false;  // a window waits for news
};
struct Event {
    double at;  // seconds
    std::variant<Request, Came, Measured, Said, FileIs, PointsChanged, Drawn, Saved, Listens, Ended, Tick> what;
};

// ---- what is to be done

struct ToPipe {
    Which which;
    std::string bytes;
};
struct Write {
    enum class To { file, against } to;
    size_t n;  // of the file, which is as this tag says
    std::string text, tag;
};
struct Start {
    Which which;
};
using Effect = std::variant<Answer, ToPipe, Write, Start>;
using Effects = std::vector<Effect>;

std::pair<State, Effects> step(State state, const Event& event);

}  // namespace live
