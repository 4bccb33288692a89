// SPDX-License-Identifier: BSD-3-Clause
// The words of a region file, one list for each region: an indented line goes on with the region above; # starts a
// comment; ( ) & ! stand alone; "..." is one word.
#pragma once
#include <string>
#include <vector>

namespace region {

struct Token {
    std::string text;
    bool quoted;
    int line;
};

// Throws Error with file:line.
std::vector<std::vector<Token>> split_regions(const std::string& text, const std::string& file);

// A whole word that is a finite number; `rest` takes what follows it (a unit), if wanted.
bool is_number(const std::string& word, double& value, std::string* rest = nullptr);

}  // namespace region
