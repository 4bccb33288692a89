// SPDX-License-Identifier: BSD-3-Clause
// Maps of points, such as the sensors of a desk, beside the picture.  A second pipe of the same programs renders the
// points of the model that the page has, and rests until the picture of a change has its first lines; ptaccum keeps
// their sum in a file, and vcmetrics draws it when the page asks.
#pragma once
#include <atomic>
#include <chrono>
#include <optional>
#include <string>
#include <vector>
#include "base/file_stamp.h"
#include "live/answers.h"
#include "live/asked.h"
#include "live/fifo.h"
#include "live/files.h"
#include "live/live.h"

namespace live {

struct PlanOptions {
    std::string control;               // FIFO of its ptrace; the first line is the sign to begin; empty: no pipe
    std::string lines;                 // FIFO of what the pipe says
    std::string sum;                   // file of ptaccum (-batches, .exr)
    std::vector<std::string> points;   // its point files and folders of them
    std::vector<std::string> measure;  // vcmetrics with these
};

class Plan {
public:
    Plan(const PlanOptions& options, const Files& files, Live& live);
    void look(bool asked = false);          // at the clock's pace; asked: the page has asked the renderer for something
    Answer limit(const std::string& text);  // of the line in the map and of the share, lx
    Asked::Found draw();                    // text: numbers of the grids and the map, as JSON
    bool is_there() const { return lines_.has_value(); }
    struct Drawing {
        size_t number;
        int status;            // of vcmetrics
        std::string row, map;  // its line (jsonl) and the map (SVG)
        bool is_old;           // of the model or the points before a change
    };
    Drawing draw(const std::string& map);  // a file of this name

private:
    bool rests() const;
    void send(const std::vector<std::optional<std::string>>& texts);
    void take(const std::string& line);
    void show();

    const PlanOptions& options_;
    const Files& files_;
    Live& live_;
    std::optional<FifoLines> lines_;
    base::FileStamp stamp_;  // of the sum
    std::vector<base::FileStamp> points_;
    std::atomic<size_t> points_changes_{0}, points_drawn_{0};  // points_drawn_: so many of them are in what was drawn
    std::atomic<size_t> number_{0};                            // of what can be drawn
    std::atomic<double> limit_lx_{300};
    std::vector<std::optional<std::string>> given_;  // texts that stand for the files in that pipe
    bool resting_ = true, begun_ = false, ended_ = false;
    size_t unanswered_ = 0;  // questions for the number of the edit that texts have become
    std::atomic<long long> edit_{0};
    std::atomic<bool> waits_{false};
    // what the page asked the renderer for, and the edit of the picture then
    std::chrono::steady_clock::time_point asked_;
    std::optional<int64_t> before_;
    std::string shown_;
};

}  // namespace live
