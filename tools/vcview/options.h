// SPDX-License-Identifier: BSD-3-Clause
// vcview's options.
#pragma once
#include <optional>
#include <string>
#include <vector>
#include "live/server.h"

struct Options {
    live::ServerOptions server;
    bool stay = false, open = false;
    std::string messages;
    std::vector<std::string> command;  // after "--"
};

// Nothing: a question (-help) was answered.
std::optional<Options> parse_options(int argc, char** argv);
