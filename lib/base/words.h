// SPDX-License-Identifier: BSD-3-Clause
// A cursor over the words of a command line in RADIANCE's spelling: @file and $VARIABLE stand for the words in them,
// but only where an option or an operand could begin, never where an argument stands.
#pragma once
#include <string>
#include <vector>

namespace base {

class Words {
public:
    // scene_file: where the words stand if a scene says them, not the user.  They see no environment, and an @file of
    // theirs must be an ordinary file.
    explicit Words(std::vector<std::string> words, std::string scene_file = "");

    // True if a word is left; replaces @file and $VARIABLE first.
    bool more();

    // The word at the cursor, after more() was true.
    const std::string& peek() const { return words_[at_]; }
    std::string take() { return words_[at_++]; }
    bool is_option() const;  // begins with '-' and is not "-" alone

    // As they stand, nothing replaced: the arguments of an option.
    size_t left() const { return words_.size() - at_; }
    size_t at() const { return at_; }
    void go_to(size_t at) { at_ = at; }
    std::vector<std::string> since(size_t from) const;

    const std::vector<std::string>& all() const { return words_; }  // what was replaced so far is

    const std::string& scene_file() const { return scene_file_; }

private:
    std::vector<std::string> expand(const std::string& word) const;

    std::vector<std::string> words_;
    std::string scene_file_;
    size_t at_ = 0;
    int expansions_ = 0;
};

}  // namespace base
