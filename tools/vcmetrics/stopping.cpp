// SPDX-License-Identifier: BSD-3-Clause
// See stopping.h.
#include "stopping.h"

#include <fmt/format.h>

#include <cstdio>

#include "base/error.h"

using namespace comfort;

Stopping::Stopping(const Options& options, const std::vector<Column>& columns) : options_(options), columns_(columns) {
    if (options.until.empty()) return;
    if (options.window) window_rule_.emplace(parse_tolerances(options.until), *options.window);
    else precision_rule_.emplace(options.until);
    for (const Tolerance& t : window_rule_ ? window_rule_->tolerances() : precision_rule_->tolerances())
        watched_.push_back(column_of(t.metric));
    if (precision_rule_ && precision_rule_->asks_class()) dgp_ = column_of("DGP", "class is that of DGP, but ");
}

size_t Stopping::column_of(const std::string& name, const std::string& why) const {
    for (size_t k = 0; k < columns_.size(); ++k)
        if (columns_[k].name == name) return k;
    base::fail("-until", why + "there is no column \"" + name + "\" in this run");
}

bool Stopping::window_holds(const Line& line) {
    if (line.first_frame) {
        window_rule_->restart();
        return false;
    }
    std::vector<double> watched;
    for (size_t k : watched_) watched.push_back(line.values[k]);
    window_rule_->add(watched);
    return window_rule_->holds();
}

bool Stopping::precision_holds(const Line& line, std::string& reason) {
    if (!line.looked) return false;
    std::vector<Estimate> estimates;
    for (size_t k : watched_) estimates.push_back(line.looked->estimate(k));
    const Estimate dgp = line.looked->estimate(dgp_);
    if (!precision_rule_->holds(line.looked->looks(), line.frames, estimates, dgp)) return false;
    reason = precision_rule_->reason(estimates, dgp);
    return true;
}

bool Stopping::after(const Line& line) {
    std::string reason;
    frames_ = line.frames;
    if (window_rule_ && window_holds(line)) {
        held_ = true;
        reason = fmt::format("{} held over {} lines", options_.until, *options_.window);
    } else if (precision_rule_ && precision_holds(line, reason)) {
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
