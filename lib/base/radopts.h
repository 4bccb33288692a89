// SPDX-License-Identifier: BSD-3-Clause
// A cursor over a command line in RADIANCE's spelling: one dash, arguments as separate words whose number is
// fixed by the option, @file and $VAR replaced where an option could begin, -i -i+ -i- switches.
//   while (words.more()) {
//       if (words.is("-ab")) opt.ab = words.next_int("-ab");
//       else if (words.is_switch("-i", opt.i)) ;
//       else if (int n = view::parse_option(v, words.all(), words.at())) words.skip(n);
//       else ...
//   }
#pragma once
#include <string>
#include <vector>
#include "base/vec.h"

namespace base {

class Words {
public:
    // scene_file: where the words stand if a scene says them, not the user.  They see no environment, and an @file of
    // theirs must be an ordinary file.
    explicit Words(std::vector<std::string> words, std::string scene_file = "");

    // True if a word is left; expands @file and $VAR first: call it at option positions only.
    bool more();
    const std::string& peek() const { return words_[at_]; }  // after more() was true
    std::string take() { return words_[at_++]; }
    bool is_option() const;  // begins with '-' and is not "-" alone

    // If the word at the cursor equals the option, steps over it and says true.
    bool is(const char* option);
    // -i toggles, -i+ -i1 -iy -it on, -i- -i0 -in -if off (any case).
    bool is_switch(const char* option, bool& value);

    // Arguments of the option named (for the message); throw Error if missing or malformed.
    long next_int(const std::string& option);
    double next_real(const std::string& option);
    Vec3 next_vec(const std::string& option);
    std::string next_string(const std::string& option);

    // For readers that want the plain words (view::parse_option).
    const std::vector<std::string>& all() const { return words_; }
    size_t at() const { return at_; }
    void skip(size_t n) { at_ += n; }

private:
    std::vector<std::string> expand(const std::string& word) const;
    std::vector<std::string> words_;
    std::string scene_file_;
    size_t at_ = 0;
    int expansions_ = 0;
};

// The whole text as a number, or an Error that names the place: "-vh: "abc" is not a number".
double to_real(const std::string& text, const std::string& where);
long to_int(const std::string& text, const std::string& where);

}  // namespace base
