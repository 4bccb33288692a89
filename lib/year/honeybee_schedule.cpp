// SPDX-License-Identifier: BSD-3-Clause
// See honeybee_schedule.h.
#include "year/honeybee_schedule.h"

#include "base/error.h"
#include "base/number.h"
#include "base/printable.h"
#include "base/split.h"
#include "base/text_file.h"

namespace year {
namespace {

// What stands between quotes from here on; `at` is then behind it.
std::string quoted(const std::string& text, size_t& at) {
    const size_t begin = ++at;
    while (at < text.size() && text[at] != '"') at += text[at] == '\\' ? 2 : 1;
    const std::string word = text.substr(begin, std::min(at, text.size()) - begin);
    ++at;
    return word;
}

std::vector<size_t> numbers_of(const std::string& list, const std::string& path) {
    constexpr double most = 63;  // states
    std::vector<size_t> numbers;
    for (const std::string& part : base::split_list(list, ',')) {
        const std::vector<std::string> words = base::split_words(part);
        double v = -1;
        if (words.size() != 1 || !base::parse_real(words[0], v) || v < 0 || v > most || v != double(size_t(v)))
            base::fail(path, "\"" + base::excerpt(part) + "\" is not the number of a state");
        numbers.push_back(size_t(v));
    }
    return numbers;
}

}  // namespace

std::optional<std::vector<size_t>> read_honeybee_schedule(const std::string& path, const std::string& group) {
    constexpr size_t longest = size_t(1) << 26;
    const std::string text = base::read_text_file(path, longest);
    const size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string::npos || text[first] != '{') return std::nullopt;
    std::string of;  // the group
    int depth = 0;
    for (size_t at = first; at < text.size();) {
        const char c = text[at];
        if (c == '"') {
            const std::string word = quoted(text, at);
            if (depth == 1) of = word;
        } else if (c == '[') {
            const size_t end = std::min(text.find(']', at), text.size());
            if (of == group) return numbers_of(text.substr(at + 1, end - at - 1), path);
            at = end;
        } else {
            depth += c == '{' ? 1 : c == '}' ? -1 : 0;
            ++at;
        }
    }
    base::fail(path, "has no schedule of the group \"" + group + "\"");
}

}  // namespace year
