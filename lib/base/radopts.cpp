// SPDX-License-Identifier: BSD-3-Clause
// See radopts.h.  Conventions of RADIANCE's programs for @file and $VAR: white space separates, no quotes,
// no comments; the expansion is looked at again, so a file may name a further file (1000 times at most).
#include "base/radopts.h"

#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
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

double to_real(const std::string& text, const std::string& where) {
    const char* begin = text.c_str();
    char* end = nullptr;
    const double value = std::strtod(begin, &end);
    if (end == begin || *end || std::isspace((unsigned char)*begin)) fail(where, '"' + text + "\" is not a number");
    if (!std::isfinite(value)) fail(where, '"' + text + "\" is not a finite number");
    return value;
}

long to_int(const std::string& text, const std::string& where) {
    const char* begin = text.c_str();
    char* end = nullptr;
    errno = 0;
    const long value = std::strtol(begin, &end, 10);
    if (end == begin || *end || std::isspace((unsigned char)*begin) || errno == ERANGE)
        fail(where, '"' + text + "\" is not an integer");
    return value;
}

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

bool Words::is(const char* option) {
    if (at_ >= words_.size() || words_[at_] != option) return false;
    ++at_;
    return true;
}

bool Words::is_switch(const char* option, bool& value) {
    const std::string& word = words_[at_];
    const size_t n = std::strlen(option);
    if (word.compare(0, n, option) != 0) return false;
    if (word.size() == n) value = !value;
    else if (word.size() == n + 1 && std::strchr("+1yYtT", word[n])) value = true;
    else if (word.size() == n + 1 && std::strchr("-0nNfF", word[n])) value = false;
    else return false;
    ++at_;
    return true;
}

std::string Words::next_string(const std::string& option) {
    if (at_ >= words_.size()) fail(option, "an argument is missing");
    return words_[at_++];
}
long Words::next_int(const std::string& option) { return to_int(next_string(option), option); }
double Words::next_real(const std::string& option) { return to_real(next_string(option), option); }
Vec3 Words::next_vec(const std::string& option) {
    const double x = next_real(option), y = next_real(option);
    return {x, y, next_real(option)};
}

}  // namespace base
