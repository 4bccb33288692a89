// SPDX-License-Identifier: BSD-3-Clause
// See stopping.h.
#include "stopping.h"

#include <fmt/format.h>

#include <cstdio>

#include "base/error.h"
#include "uncertainty/stopping.h"

using namespace glare;
using namespace report;

Stopping::Stopping(const Options& options, const std::vector<Column>& columns) : options_(options), columns_(columns) {
    if (options.until.empty()) return;
    rule_.emplace(options.until);
    for (const Tolerance& t : rule_->tolerances()) watched_.push_back(column_of(t.metric));
    if (rule_->asks_class()) dgp_ = column_of("DGP", "class is that of DGP, but ");
}

size_t Stopping::column_of(const std::string& name, const std::string& why) const {
    for (size_t k = 0; k < columns_.size(); ++k) {
        if (columns_[k].name != name) continue;
        if (!columns_[k].has_interval())
            base::fail("-until", name + " has no interval, as none has been shown to hold the truth (vcmetrics(1))");
        return k;
    }
    base::fail("-until", why + "there is no column \"" + name + "\" in this run");
}

bool Stopping::rule_holds(const Line& line, std::string& reason) const {
    if (!rule_ || !line.looked || line.frames < uncertainty::least_frames) return false;
    std::vector<uncertainty::Estimate> estimates;
    for (size_t k : watched_) estimates.push_back(line.looked->estimate(k));
    const uncertainty::Estimate dgp = line.looked->estimate(dgp_);
    if (!rule_->holds(estimates, dgp)) return false;
    reason = rule_->reason(estimates, dgp);
    return true;
}

bool Stopping::after(const Line& line) {
    std::string reason;
    frames_ = line.frames;
    if (rule_holds(line, reason)) {
        held_ = true;
    } else if (options_.max_frames && line.frames >= *options_.max_frames) {
        reason = "-max-frames is reached";
    } else if (options_.max_seconds && line.seconds >= *options_.max_seconds) {
        reason = "-max-seconds are over";
    } else return false;
    if (!held_ && has_rule()) reason += ", -until does not hold yet";
    fmt::print(stderr, "vcmetrics: stopped after {} frames: {}\n", line.frames, reason);
    return true;
}

void Stopping::at_end() const {
    if (status() != 0)
        fmt::print(stderr, "vcmetrics: the input ended after {} frames: -until does not hold\n", frames_);
}
