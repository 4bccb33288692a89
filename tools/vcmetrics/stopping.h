// SPDX-License-Identifier: BSD-3-Clause
// When a run ends by itself, and the line on stderr that says why: -until (widths of intervals, or with -window values
// that stay), -max-frames, -max-seconds.
#pragma once
#include <optional>
#include <string>
#include <vector>
#include "comfort/precision.h"
#include "options.h"

class Stopping {
public:
    // Throws Error if a rule names a column that the run does not have.
    Stopping(const Options& options, const std::vector<comfort::Column>& columns);
    bool has_rule() const { return window_rule_ || precision_rule_; }

    struct Line {
        const std::vector<double>& values;  // by column
        int64_t frames;
        bool first_frame;                  // a new frame 0
        double seconds;                    // since the start
        const comfort::Certainty* looked;  // its estimates are new; else null
    };
    // True: stop here.  Status 0 if the rule holds or there is none, else 4.
    bool after(const Line& line);
    void at_end() const;  // of the input, without a stop
    int status() const { return has_rule() && !held_ ? 4 : 0; }

private:
    size_t column_of(const std::string& name, const std::string& why = "") const;
    bool window_holds(const Line& line);
    bool precision_holds(const Line& line, std::string& reason);
    const Options& options_;
    const std::vector<comfort::Column>& columns_;
    std::optional<comfort::StoppingRule> window_rule_;
    std::optional<comfort::PrecisionRule> precision_rule_;
    std::vector<size_t> watched_;  // columns of the rule, in its order
    size_t dgp_ = 0;               // for the class
    int64_t frames_ = 0;           // of the last line
    bool held_ = false;
};
