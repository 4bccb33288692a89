// SPDX-License-Identifier: BSD-3-Clause
// See words.h.  Conventions of RADIANCE's programs for @file and $VAR: white space separates, no quotes,
// no comments; the expansion is looked at again, so a file may name a further file (1000 times at most).
#include "base/words.h"

#include <cstdlib>
#include <iterator>
#include <sstream>

#include "base/error.h"
#include "base/text_file.h"

namespace base {
namespace {

constexpr size_t most_words = 1000000;

std::vector<std::string> split(const std::string& text) {
    std::istringstream in(text);
    return {std::istream_iterator<std::string>(in), std::istream_iterator<std::string>()};
}

}  // namespace

Words::Words(std::vector<std::string> words, std::string scene_file)
    : words_(std::move(words)), scene_file_(std::move(scene_file)) {}

std::vector<std::string> Words::expand(const std::string& word) const {
    const std::string name = word.substr(1);
    if (word[0] == '@') {
        if (!scene_file_.empty()) require_ordinary_file(name, scene_file_);
        return split(read_text_file(name));
    }
    if (!scene_file_.empty()) fail(scene_file_, "a scene's file may not ask for an environment variable");
    const char* value = std::getenv(name.c_str());
    if (!value) fail(word, "environment variable is not set");
    return split(value);
}

bool Words::more() {
    while (at_ < words_.size()) {
        const std::string& word = words_[at_];
        if (word.size() < 2 || (word[0] != '@' && word[0] != '$')) return true;
        if (++expansions_ > 1000) fail(word, "expands without end");
        const std::vector<std::string> more_words = expand(word);
        words_.erase(words_.begin() + long(at_));
        words_.insert(words_.begin() + long(at_), more_words.begin(), more_words.end());
        if (words_.size() > most_words) fail("", "more than a million words of options");
    }
    return false;
}

bool Words::is_option() const { return words_[at_].size() > 1 && words_[at_][0] == '-'; }

std::vector<std::string> Words::since(size_t from) const {
    return {words_.begin() + long(from), words_.begin() + long(at_)};
}

}  // namespace base
