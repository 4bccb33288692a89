// SPDX-License-Identifier: BSD-3-Clause
// See tokens.h.
#include "region/tokens.h"
#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fmt/format.h>
#include "base/error.h"

namespace region {
namespace {

// The words of one line.
std::vector<Token> split_line(const std::string& line, int number, const std::string& file) {
    std::vector<Token> tokens;
    for (size_t i = 0; i < line.size();) {
        if (line[i] == ' ' || line[i] == '\t' || line[i] == '\r') {
            ++i;
            continue;
        }
        if (line[i] == '#') break;
        Token t{"", false, number};
        if (line[i] == '"') {
            const size_t close = line.find('"', i + 1);
            if (close == std::string::npos) base::fail(fmt::format("{}:{}", file, number), "a quote is not closed");
            t = {line.substr(i + 1, close - i - 1), true, number};
            i = close + 1;
        } else if (std::strchr("()&!", line[i])) {
            t.text = line[i++];
        } else {
            const size_t end = line.find_first_of(" \t\r()&!\"", i);
            t.text = line.substr(i, end - i);
            i = end == std::string::npos ? line.size() : end;
        }
        tokens.push_back(t);
    }
    return tokens;
}

}  // namespace

std::vector<std::vector<Token>> split_regions(const std::string& text, const std::string& file) {
    std::vector<std::vector<Token>> regions;
    int number = 0;
    for (size_t at = 0; at < text.size();) {
        ++number;
        const size_t stop = std::min(text.find('\n', at), text.size());
        const std::string line = text.substr(at, stop - at);
        at = stop + 1;
        const std::vector<Token> tokens = split_line(line, number, file);
        if (tokens.empty()) continue;
        const bool indented = line[0] == ' ' || line[0] == '\t';
        if (!indented) regions.emplace_back();
        if (regions.empty())
            base::fail(fmt::format("{}:{}", file, number),
                       "an indented line continues the region above, but there is none");
        regions.back().insert(regions.back().end(), tokens.begin(), tokens.end());
    }
    return regions;
}

bool is_number(const std::string& word, double& value, std::string* rest) {
    char* end = nullptr;
    if (word.empty() || std::isspace((unsigned char)word[0])) return false;
    value = std::strtod(word.c_str(), &end);
    if (end == word.c_str() || !std::isfinite(value)) return false;
    if (rest) *rest = end;
    return rest || *end == 0;
}

}  // namespace region
