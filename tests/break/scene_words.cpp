// SPDX-License-Identifier: BSD-3-Clause
// Words and primitives: see scene_words.h.
#include "scene_words.h"

#include <cctype>
#include <cstdlib>

namespace breaking {
namespace {

bool is_space(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

}  // namespace

std::vector<Stretch> words_of(const std::string& bytes) {
    std::vector<Stretch> words;
    for (size_t i = 0; i < bytes.size();) {
        const size_t begin = i;
        while (i < bytes.size() && !is_space(bytes[i])) ++i;
        if (i > begin) words.push_back({begin, i - begin});
        while (i < bytes.size() && is_space(bytes[i])) ++i;
    }
    return words;
}

std::vector<Primitive> primitives_of(const std::string& b) {
    std::vector<Primitive> all;
    std::vector<Stretch> words;
    for (const Stretch& w : words_of(b)) {
        const size_t line = b.rfind('\n', w.from) + 1;
        if (b[line] != '!' && b[line] != '#') words.push_back(w);
    }
    const auto text = [&](size_t i) { return b.substr(words[i].from, words[i].length); };
    for (size_t i = 0; i + 3 < words.size();) {
        Primitive p{words[i], words[i + 1], words[i + 2], {}, {}};
        i += 3;
        if (b.compare(p.type.from, p.type.length, "alias") == 0) p.strings.push_back(words[i++]);
        else
            for (int list = 0; list < 3 && i < words.size(); ++list) {
                const size_t count = std::strtoul(text(i++).c_str(), nullptr, 10);
                if (count > words.size() - i) return all;
                auto& arguments = list == 0 ? p.strings : p.reals;
                arguments.insert(arguments.end(), words.begin() + long(i), words.begin() + long(i + count));
                i += count;
            }
        all.push_back(std::move(p));
    }
    return all;
}

}  // namespace breaking
