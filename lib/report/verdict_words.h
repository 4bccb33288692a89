// SPDX-License-Identifier: BSD-3-Clause
// What may be said of a glare probability and its interval.  lib/live/page/judge.js has the same words for the live
// page; tests/golden/verdicts.tsv holds both to them.
#pragma once
#include <string>

namespace report {

struct VerdictWords {
    int worst = -1;      // class; -1: the interval holds more than two
    std::string words;   // "perceptible to disturbing"; empty: none
    std::string people;  // a sentence on what that means
};
// low, high: nan without an interval; then the class is that of the value.
VerdictWords verdict_words(double dgp, double low, double high);

}  // namespace report
