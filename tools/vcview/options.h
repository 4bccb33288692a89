// SPDX-License-Identifier: BSD-3-Clause
// vcview's options.
#pragma once
#include <optional>
#include <string>
#include <vector>
#include "live/server.h"

struct Options {
    live::ServerOptions server;
    live::Files files;  // that the page may show or change
    bool stay = false, open = false;
    std::string messages, regions;
    std::string against;               // file of vcmetrics -against; empty: none
    std::vector<std::string> command;  // after "--"
    std::vector<std::string> scene;    // after a second one: words of ptrace, which we start
};

// Nothing: a question (-help) was answered.
std::optional<Options> parse_options(int argc, char** argv);
