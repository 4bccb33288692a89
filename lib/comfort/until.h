// SPDX-License-Identifier: BSD-3-Clause
// A first stopping rule: "DGP 1%, Ev 0.5%" holds when, over the last `window` lines, every named metric stayed within
// its tolerance of the window's mean:  |v - mean| <= tolerance (% of |mean|, or plain in the metric's own unit).
#pragma once
#include <deque>
#include <string>
#include <vector>

namespace comfort {

struct Tolerance {
    std::string metric;
    double amount = 0;
    bool relative = false;  // amount is a fraction of the mean
};

// Throws Error on a rule that cannot be read; place: which option, or which line of which file, says it.
std::vector<Tolerance> parse_tolerances(const std::string& rule, const std::string& place = "-until");

class StoppingRule {
public:
    StoppingRule(std::vector<Tolerance> tolerances, int window);
    const std::vector<Tolerance>& tolerances() const { return tolerances_; }
    // Values in the order of tolerances().
    void add(const std::vector<double>& values);
    void restart() { lines_.clear(); }  // a new frame 0: the scene changed
    bool holds() const;

private:
    std::vector<Tolerance> tolerances_;
    size_t window_;
    std::deque<std::vector<double>> lines_;
};

}  // namespace comfort
