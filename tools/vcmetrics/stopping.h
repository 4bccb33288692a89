// SPDX-License-Identifier: BSD-3-Clause
// When a run ends by itself, and the line on stderr that says why: -until, -max-frames, -max-seconds.  With -control
// each picture of the stream ends by itself: its renderer is sent "next", and its further sums are passed over.  With
// -go-on nothing ends where the rule holds: a column says so.
#pragma once
#include <optional>
#include <string>
#include <vector>
#include "report/estimates.h"
#include "report/until.h"
#include "options.h"

class Stopping {
public:
    // Throws Error if a rule names a column that the run does not have, or that has no interval.
    Stopping(const Options& options, const std::vector<glare::Column>& columns);
    void find_columns();  // again, where they have changed
    bool has_rule() const { return rule_.has_value(); }

    // Before a picture is measured: a sum of n frames of the picture `label`.  True: it is passed over.
    bool passes_over(const std::string& label, int64_t n);
    struct Line {
        int64_t frames;
        double seconds;                         // since the start
        const report::ColumnEstimates* looked;  // its estimates are new; else null
        bool moments = false;                   // the picture has moments of its pixels
        int width = 0, height = 0;
        bool last = false;  // its stream announces no more frames
    };
    // When it is measured: does the rule hold?
    void look(const Line& line);
    bool held() const { return held_; }  // for this picture
    // When its line is printed.  True: stop here.  Status 0 if the rule holds or there is none, else 4.
    bool after(const Line& line);
    void at_end() const;  // of the input or a picture, without a stop
    int status() const { return has_rule() && !options_.go_on && (!held_ || missed_) ? 4 : 0; }

private:
    size_t column_of(const std::string& name, const std::string& why = "") const;
    std::optional<size_t> pixels_of(const std::string& metric) const;
    bool rule_holds(const Line& line, std::string& reason, std::string& out_of_reach) const;
    const Options& options_;
    const std::vector<glare::Column>& columns_;
    std::optional<report::UntilRule> rule_;
    std::vector<size_t> watched_;                // columns of the rule, in its order
    std::vector<std::optional<size_t>> pixels_;  // their columns NAME.px
    size_t dgp_ = 0;                             // for the class
    std::optional<size_t> dgp_pixels_;
    int64_t frames_ = -1;  // of the last line; -1: there was none
    std::string label_;
    bool held_ = false, missed_ = false;  // of this picture; of one before it
    bool done_ = false;                   // all is said of this picture; without -go-on no more of it is measured
    std::string reason_;                  // why it ends or is settled with this line; empty: it is not
    bool ends_all_ = false;
};
