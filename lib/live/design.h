// SPDX-License-Identifier: BSD-3-Clause
// The design: what the page has changed, and what it is told of the programs.  It is held here, so that every browser,
// also one that comes later, shows the same.  A change names the version of the text that it was made from.
#pragma once
#include <cstdint>
#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>
#include "image/picture.h"

namespace live {

// The edit by which ptrace takes a design that was opened again.
inline const std::string words_of_opening = "design opened";

struct Design {
    // A file of -edit.  Nothing: its text is the one on the disk.
    struct Text {
        std::optional<std::string> now;
        std::vector<std::optional<std::string>> before;  // what Undo brings back, the latest last
        size_t version = 0;
        bool going = false;  // a slider still moves: further texts are a part of the same change
    };
    std::vector<Text> texts;                                  // by the file's number
    std::vector<std::pair<int64_t, std::string>> edits;       // number and words (EDIT=) of what has been rendered
    std::vector<std::string> views;                           // options of the views of full pictures, the latest last
    std::deque<std::string> messages;                         // of the programs
    std::vector<std::pair<std::string, std::string>> places;  // views by name
    std::vector<std::string> earlier;                         // words of the edits before this design was opened again
    size_t current = 0;                                       // so many of the last of them came since the last change
    bool paused = false;
    bool reopened = false;  // from a file: the view is that one, not the first that ptrace renders
    bool given = true;      // ptrace has been given the texts and the view of that file

    void change(size_t n, std::string text, bool goes_on);
    void undo(size_t n);
    void replaced(size_t n, const std::string& on_disk);  // another program has written the file
    bool back();                                          // the view before this one is asked for; false: there is none
    void obey(const std::string& commands);               // lines of the page to ptrace
    bool note(const image::Header& header);               // of a picture that has come; true: it says something new
    void tell(std::string message);
    std::string json() const;  // without the texts
};

}  // namespace live
