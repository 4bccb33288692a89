// SPDX-License-Identifier: BSD-3-Clause
// Options of ptrace for ten frames of a square picture, from words as a row of golden/bits.tsv holds them.
#pragma once
#include <sstream>
#include <string>
#include <vector>

#include "options.h"

namespace parity {

inline Options options_of(const std::string& arguments, int size) {
    std::vector<std::string> words = {"ptrace",  "-w-", "-x", std::to_string(size), "-y", std::to_string(size),
                                      "-frames", "10",  "-o", "unused%d.hdr"};
    std::istringstream in(arguments);
    for (std::string word; in >> word;) words.push_back(word);
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    Options opt;
    parse_options(int(argv.size()), argv.data(), opt);
    opt.files.raypath = {".", LUXPIPE_TESTS "/golden/vectors"};
    return opt;
}

}  // namespace parity
