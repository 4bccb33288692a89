// SPDX-License-Identifier: BSD-3-Clause
// The design: the changes of the page, and what the programs report to it.  It is held here, so that every browser,
// also one that comes later, shows the same.  A change names the version of the text that it was made from.
#pragma once
#include <chrono>
#include <cstdint>
#include <cstddef>
#include <deque>
#include <memory>
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
    std::vector<Text> texts;  // by the file's number
    // What an Undo takes back, the latest last: a text of -edit, the view, or the text of the region file.
    struct Step {
        enum class Of { text, view, regions } of;
        size_t file = 0;
        std::string before = {}, tag = {};  // of the region file: the text before, and the tag of that after
        bool joined = false;                // to the step before it, with which it is taken back
    };
    std::vector<Step> steps;
    size_t step_changes = 0;                             // of that list
    std::vector<std::pair<int64_t, std::string>> edits;  // number and words (EDIT=) of what has been rendered
    std::vector<std::string> views;                      // options of the views of full pictures, the latest last
    std::deque<std::string> messages;                    // of the programs
    // The texts and the view under a name.
    struct Variant {
        std::string name, view, numbers = {};  // numbers: a line each metric, of the newest picture
        std::vector<std::optional<std::string>> texts;
        int64_t edit = -1;  // whose pictures are its own; -1: none has come yet
        std::shared_ptr<const image::Picture> picture = {};
    };
    std::vector<Variant> variants;
    std::string base;                                         // the variant that edits are compared with; empty: none
    std::vector<std::pair<std::string, std::string>> places;  // views by name
    std::vector<std::string> earlier;                         // words of the edits before this design was opened again
    std::string day = "null";                                 // the hours of the date (day.h), as JSON
    std::string plan = "null";                                // of points (plan.h), as JSON
    std::shared_ptr<const image::Picture> before = {};        // of the edit before the newest one
    size_t current = 0;                                       // so many of the last of them came since the last change
    bool paused = false;
    std::optional<std::chrono::steady_clock::time_point> preview;  // small pictures are asked for: last at
    bool reopened = false;  // from a file: the view is that one, not the first that ptrace renders
    bool given = true;      // ptrace has been given the texts and the view of that file

    void change(size_t n, std::string text, bool goes_on);
    void undo(size_t n);
    void replaced(size_t n, const std::string& on_disk);           // another program has written the file
    void keep(const std::string& name);                            // as a variant, in place of one of that name
    void show(const Variant& variant);                             // its texts and view are asked for
    void call(const std::string& name, const std::string& other);  // a variant by another name; empty: it is dropped
    const Variant* variant(const std::string& name) const;
    void wrote(size_t n, std::string before, std::string tag);  // the region file
    void step(Step step);
    void take_back(Step::Of of, size_t n);   // its latest step is no more
    bool back();                             // the view before this one is asked for; false: there is none
    void obey(const std::string& commands);  // lines of the page to ptrace
    void measured(const std::string& line);  // of vcmetrics
    bool pictured(const std::shared_ptr<const image::Picture>& picture);  // true: a variant's edit is another one
    bool note(const image::Header& header);  // of a picture that has come; true: it says something new
    void tell(std::string message);
    std::string json() const;  // without the texts

private:
    bool shows(const Variant& variant) const;
    std::pair<size_t, std::string> shown_;              // state of the steps by which a variant's texts came; its view
    std::vector<std::optional<std::string>> rendered_;  // the texts when the newest edit's picture came
    std::vector<std::string> columns_;                  // of vcmetrics' lines
    std::shared_ptr<const image::Picture> newest_;      // no preview
};

}  // namespace live
