// SPDX-License-Identifier: BSD-3-Clause
// See stopping.h.
#include "stopping.h"

#include <fmt/format.h>

#include <cstdio>

#include "base/command_pipe.h"
#include "base/error.h"
#include "base/run.h"
#include "uncertainty/stopping.h"

using namespace glare;
using namespace report;

Stopping::Stopping(const Options& options, const std::vector<Column>& columns) : options_(options), columns_(columns) {
    if (options.until.empty()) return;
    rule_.emplace(options.until);
    find_columns();
}

void Stopping::find_columns() {
    if (!rule_) return;
    watched_.clear(), pixels_.clear();
    for (const Tolerance& t : rule_->tolerances()) {
        watched_.push_back(column_of(t.metric));
        pixels_.push_back(pixels_of(t.metric));
    }
    const std::string& dgp = rule_->class_of();
    if (dgp.empty()) return;
    dgp_ = column_of(dgp, std::string(dgp == "DGP" ? "class" : "classf") + " is that of " + dgp + ", but ");
    dgp_pixels_ = pixels_of(dgp);
}

std::optional<size_t> Stopping::pixels_of(const std::string& metric) const {
    const std::string name = pixels_column(metric);
    for (size_t k = 0; k < columns_.size() && !name.empty(); ++k)
        if (columns_[k].name == name) return k;
    return std::nullopt;
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

bool Stopping::rule_holds(const Line& line, std::string& reason, std::string& out_of_reach) const {
    if (!rule_ || !line.looked) return false;
    const auto estimate = [&](size_t k) { return line.looked->estimate(k); };
    const auto of_pixels = [&](std::optional<size_t> k) {
        return k && line.moments ? std::optional(estimate(*k)) : std::nullopt;
    };
    std::vector<uncertainty::Estimate> estimates;
    PixelErrors pixels{{}, of_pixels(dgp_pixels_)};
    for (size_t k : watched_) estimates.push_back(estimate(k));
    for (const auto& k : pixels_) pixels.of_tolerances.push_back(of_pixels(k));
    const uncertainty::Estimate dgp = estimate(dgp_);
    if (line.frames < uncertainty::least_frames) return false;
    out_of_reach = rule_->out_of_reach(estimates, dgp, pixels, line.width, line.height);
    if (!rule_->holds(estimates, dgp, pixels)) return false;
    reason = rule_->reason(estimates, dgp, pixels);
    return true;
}

bool Stopping::passes_over(const std::string& label, int64_t n) {
    if (options_.control.empty() && !options_.go_on) return false;
    const bool begins = frames_ < 0 || label != label_ || n <= frames_;
    if (begins) {
        missed_ = missed_ || (frames_ >= 0 && has_rule() && !held_);
        if (frames_ >= 0) at_end();
        held_ = done_ = false;
        label_ = label;
    }
    frames_ = n;
    return done_ && !options_.go_on;
}

void Stopping::look(const Line& line) {
    std::string out_of_reach;
    reason_.clear();
    ends_all_ = options_.control.empty();
    frames_ = line.frames;
    if (!done_ && rule_holds(line, reason_, out_of_reach)) {
        held_ = true;
    } else if (!done_ && !out_of_reach.empty()) {
        reason_ = out_of_reach;
    } else if (options_.max_frames && line.frames >= *options_.max_frames) {
        reason_ = "-max-frames is reached";
    } else if (options_.max_seconds && line.seconds >= *options_.max_seconds) {
        reason_ = "-max-seconds are over";
        ends_all_ = true;
    } else return;
    const bool of_rule = !done_ && (held_ || !out_of_reach.empty());
    if (of_rule && options_.go_on) ends_all_ = false;
    else if (!held_ && has_rule() && out_of_reach.empty()) reason_ += ", -until does not hold yet";
}

bool Stopping::after(const Line& line) {
    if (reason_.empty()) return false;
    const std::string what = label_.empty() ? "" : label_ + ": ";
    const char* const how = ends_all_ || !options_.go_on ? "stopped" : held_ ? "settled" : "cannot settle";
    base::say(fmt::format("vcmetrics: {}{} after {} frames: {}", what, how, line.frames, reason_));
    if (ends_all_) return true;
    done_ = true;
    if (!line.last && !options_.control.empty())
        base::send_command(options_.control, label_.empty() ? "next" : "next " + label_);
    return false;
}

void Stopping::at_end() const {
    if (!has_rule() || held_ || done_ || options_.go_on) return;
    const std::string what = label_.empty() ? "the input" : label_;
    base::say(
        fmt::format("vcmetrics: {} ended after {} frames: -until does not hold", what, std::max<int64_t>(frames_, 0)));
}
