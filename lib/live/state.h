// SPDX-License-Identifier: BSD-3-Clause
// All that the page shows and changes, as a value: step() (step.h) makes the next one of it.  A change of the page is a
// Model; what a program renders, or was asked for, is a Look; both are compared, never marked.
#pragma once
#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>
#include "image/picture.h"
#include "live/files.h"

namespace live {

// Its bytes are shared by all values that hold it.  None: that of the file on the disk.
class Text {
public:
    Text() = default;
    Text(std::string text) : text_(std::make_shared<const std::string>(std::move(text))) {}
    explicit operator bool() const { return bool(text_); }
    const std::string& operator*() const { return *text_; }
    bool operator==(const Text& o) const { return text_ == o.text_ || (text_ && o.text_ && *text_ == *o.text_); }
    bool operator!=(const Text& o) const { return !(*this == o); }

private:
    std::shared_ptr<const std::string> text_;
};
using Texts = std::vector<Text>;  // by the file's number

// What a picture shows: texts of the scene (of a file of regions: none), and options of a view.
struct Look {
    Texts texts;
    std::string view;
    bool operator==(const Look& o) const { return view == o.view && texts == o.texts; }
    bool operator!=(const Look& o) const { return !(*this == o); }
};

struct Variant {
    std::string name;
    Look look;
};

struct Model {
    Texts texts;
    std::vector<std::string> views;  // options; the latest last, those before it are reached by Back
    std::vector<Variant> variants;
    std::string base;                                         // the variant that edits are compared with; empty: none
    std::vector<std::pair<std::string, std::string>> places;  // views by name
    std::string view() const { return views.empty() ? "" : views.back(); }
};

// A step of Undo or Redo: the model that it brings back, and a name for what it takes back.
struct Change {
    std::string words;
    Model model;
};

struct File {
    std::string path;
    TextFile::Kind kind = TextFile::Kind::scene;
    bool writable = false;
    Text text = {};  // on the disk, with its tag
    std::string tag = {}, trouble = {};
    size_t version = 0;  // of what stands for it
};

// Programs that render for the page.  Each edit that is sent has a number, which comes back in the header of the
// pictures that show it (note, ptrace(1)); an edit holds all that differs from what is known to have arrived.
enum class Which { picture, day, plan };
struct Pipe {
    enum class Stage { none, asleep, running, ended } stage = Stage::none;
    bool own = false;                   // its programs are ours, and can be started again
    Look look;                          // of the newest full picture; a text that is absent is not known
    int64_t edit = -1, first_edit = 0;  // of that picture; of this start of the programs
    struct Sent {
        size_t number;
        Look look;
    };
    std::vector<Sent> sent;          // and not seen yet, the latest last
    std::map<int64_t, size_t> same;  // by edits whose pictures are to come: what was sent later, and changes nothing
    bool rests = true;
    int starts = 0;
};

// What is known of a look that has a variant.
struct Result {
    Look look;
    int64_t edit = -1;
    std::shared_ptr<const image::Picture> picture;
    std::vector<std::string> numbers;  // a text a metric
};

// A line for people.  It stands in the page's head until it is dismissed or its cause is gone.
struct Message {
    enum class Cause { other, scene, command, regions, points, design, programs } cause = Cause::other;
    std::string text;
    size_t number = 0, sent = 0;  // so many edits had been sent
    bool stands = true;
};

// DGPf by the hour of the first sky's date; a pipe renders one hour after another.
struct Day {
    std::optional<size_t> sky;  // the file with the sky
    Look look;                  // at noon
    std::optional<int> asked;   // an hour, and its look
    Look asked_look;
    std::map<int, std::array<double, 4>> hours;  // DGPf, its interval, Ev
    bool ends[2] = {};                           // nothing is to come before, after these hours
};

// DGPf of the model of the page in a small picture, which has an interval long before the large one: the pipe of the
// day renders it before any hour.
struct First {
    Look look;
    bool asked = false, failed = false;
    int64_t frame = -1;  // of the row
    std::array<double, 4> row{};
};

// Maps of points; a pipe keeps their sum in a file, which is drawn when the page asks.
struct Plan {
    double limit_lx = 300;         // of the line in the map and of the share
    size_t number = 0;             // of what can be drawn
    size_t points = 0, drawn = 0;  // changes of the point files; so many of them are in what was drawn
};

struct State {
    std::vector<File> files;
    Model now;
    std::vector<Change> undo, redo;  // the latest last
    size_t changes = 0;              // of these lists
    int going = -1;                  // the file whose slider still moves: its texts are one change

    std::array<Pipe, 3> pipes;
    Pipe& pipe(Which which) { return pipes[size_t(which)]; }
    const Pipe& pipe(Which which) const { return pipes[size_t(which)]; }
    size_t sent = 0;  // number of the latest edit

    double at = 0, asked_at = -1e9;  // seconds: now, and when the page asked for a change
    std::optional<double> preview;   // small pictures are asked for: last at
    bool paused = false;
    struct {
        bool now = false;                              // the picture's programs wait, and end that with the next edit
        double seen = -1;                              // when a window last looked; none has yet: negative
        int64_t settled = -1;                          // the edit whose numbers are
        int64_t goes_on = -1;                          // the edit that the page wants to go on
        std::pair<int64_t, int64_t> measured{-1, -1};  // edit and frame, up to which old regions may have been measured
    } rest;
    std::shared_ptr<const image::Picture> picture, newest, before;  // the newest; no preview; of the edit before that
    std::vector<std::pair<int64_t, std::string>> edits;             // number and words of what has been rendered
    std::vector<std::string> earlier;                               // words of those before the design was opened again
    std::vector<Result> results;
    std::pair<int64_t, std::vector<std::string>> numbers{-1, {}};  // of the newest row: its edit
    std::deque<Message> messages;
    size_t told = 0;  // so many there have been
    Day day;
    First first;
    struct {
        int64_t edit = -1, frame = -1;
        std::array<double, 4> row{};  // DGPf, its interval, Ev
    } small;                          // the newest row of the pipe of the day
    Plan plan;
    std::string against = "previous";  // what edits are compared with where there is no base (vcmetrics -against)
    std::string said_against;
    std::string control;  // the place of ptrace's complaints about commands
    struct Question {
        double at = -1e9;
        std::string answer;  // the edit and what is there; empty: none yet
    };
    std::map<std::string, Question> questions;  // to ptrace, about the newest picture
    std::optional<int> ended;                   // status
};

// The edit by which ptrace takes a design that was opened again.
inline const std::string words_of_opening = "design opened";

// ---- what a state says

Text text_of(const State& s, const Texts& texts, size_t n);  // that counts for file N; no text is absent
Look look_of(const State& s, const Texts& texts, const std::string& view);
inline Look look_now(const State& s) { return look_of(s, s.now.texts, s.now.view()); }
const Variant* find_variant(const Model& model, const std::string& name);
const Result* result_of(const State& s, const Look& look);
std::string against_of(const State& s);  // for vcmetrics -against
bool plan_waits(const State& s);         // for the model of the page
bool has_ended(const State& s);          // a program that can be started again
bool picture_waits(const State& s);      // likewise, and nothing in the scene is wrong
std::optional<size_t> regions_file(const State& s);
// For the page, without the texts.  whole: with the numbers of variants, which change with each row.
std::string json_of(const State& s, bool whole = true);

}  // namespace live
