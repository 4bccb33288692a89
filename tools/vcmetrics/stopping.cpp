// SPDX-License-Identifier: BSD-3-Clause
// See stopping.h.
#include "stopping.h"

#include <fmt/format.h>

#include "base/edit_distance.h"
#include "base/error.h"
#include "base/run.h"
#include "base/split.h"
#include "glare/actions.h"
#include "uncertainty/stopping.h"

using namespace glare;
using namespace report;

namespace {

std::optional<size_t> pixels_of(const std::vector<Column>& columns, const std::string& metric) {
    const std::string name = pixels_column(metric);
    for (size_t k = 0; k < columns.size() && !name.empty(); ++k)
        if (columns[k].name == name) return k;
    return std::nullopt;
}

bool is_metric(const Options& o, const std::string& name) {
    if (action_column(name)) return true;
    ColumnChoice choice;
    choice.names = {name};
    Requirements ignored;
    try {
        return !choose_columns(choice, o.settings, ignored).empty();
    } catch (const base::Error&) {
        return false;
    }
}

size_t column_of(const Options& o, const std::vector<Column>& columns, const std::string& name,
                 const std::string& why = "") {
    for (size_t k = 0; k < columns.size(); ++k) {
        if (columns[k].name != name) continue;
        if (!columns[k].has_interval())
            base::fail("-until", name + " has no interval, as none has been shown to hold the truth (vcmetrics(1))");
        return k;
    }
    std::vector<std::string> names;
    std::string list;
    for (const Column& c : columns)
        if (c.printed && c.has_interval()) names.push_back(c.name), list += (list.empty() ? " " : ", ") + c.name;
    base::fail("-until", why + "there is no column \"" + name + "\" in this run" +
                             (list.empty() ? "" : ", which has" + list) +
                             (is_metric(o, name) ? "; -metrics adds it" : base::question(name, names)));
}

}  // namespace

RuleState rule_state(const StopRule& rule, const MeasuredSum& sum) {
    if (!sum.moments && !rule.of_filled.empty())
        return {false, "", "there is no " + rule.of_filled + " without moments of pixels, which the pictures lack"};
    if (!rule.rule || !sum.looked || sum.frames < uncertainty::least_frames) return {};
    const auto estimate = [&](size_t k) { return sum.looked->estimate(k); };
    const auto of_pixels = [&](std::optional<size_t> k) {
        return k && sum.moments ? std::optional(estimate(*k)) : std::nullopt;
    };
    std::vector<uncertainty::Estimate> estimates;
    PixelErrors pixels{{}, of_pixels(rule.dgp_pixels)};
    for (size_t k : rule.watched) estimates.push_back(estimate(k));
    for (const auto& k : rule.pixels) pixels.of_tolerances.push_back(of_pixels(k));
    const uncertainty::Estimate dgp = estimate(rule.dgp);
    RuleState out{rule.rule->holds(estimates, dgp, pixels), "",
                  rule.rule->out_of_reach(estimates, dgp, pixels, sum.width, sum.height)};
    if (out.holds) out.reason = rule.rule->reason(estimates, dgp, pixels);
    return out;
}

std::string parts_of_rule(const std::string& until, const std::function<bool(const std::string& column)>& counts) {
    std::string out;
    for (const std::string& part : base::split_list(until, ',')) {
        const std::vector<std::string> words = base::split_words(part);
        if (!words.empty() && counts(words[0])) out += (out.empty() ? "" : ",") + part;
    }
    return out;
}

StopRule stop_rule(const Options& o, const std::string& until, const std::vector<Column>& columns) {
    StopRule out;
    if (until.empty()) return out;
    out.rule.emplace(until);
    for (const Tolerance& t : out.rule->tolerances()) {
        out.watched.push_back(column_of(o, columns, t.metric));
        out.pixels.push_back(pixels_of(columns, t.metric));
        if (columns[out.watched.back()].of_filled) out.of_filled = t.metric;
    }
    const std::string& dgp = out.rule->class_of();
    if (dgp.empty()) return out;
    out.dgp =
        column_of(o, columns, dgp, std::string(dgp == "DGP" ? "class" : "classf") + " is that of " + dgp + ", but ");
    out.dgp_pixels = pixels_of(columns, dgp);
    if (columns[out.dgp].of_filled) out.of_filled = dgp;
    return out;
}

Progress begin(const Options& o, Progress p, const std::string& label, int64_t n) {
    if (o.control.empty() && !o.go_on) return p;
    const bool first = p.frames < 0;
    if (first || label != p.label || n <= p.frames) {
        if (!first) say_end(o, p);
        p.missed = p.missed || (!first && !o.until.empty() && !p.held);
        p.held = p.done = false;
        p.label = label;
    }
    p.frames = n;
    return p;
}

std::pair<Progress, Verdict> decide(const Options& o, const RuleState& state, Progress p, const MeasuredSum& sum) {
    std::string reason;
    bool ends_all = o.control.empty();
    p.frames = sum.frames;
    if (!p.done && state.holds) {
        p.held = true;
        reason = state.reason;
    } else if (!p.done && !state.out_of_reach.empty()) {
        reason = state.out_of_reach;
    } else if (o.max_frames && sum.frames + 1 >= *o.max_frames) {
        reason = "-max-frames is reached";
    } else if (o.max_seconds && sum.seconds >= *o.max_seconds) {
        reason = "-max-seconds is reached";
        ends_all = true;
    } else return {p, {}};
    const bool of_rule = !p.done && (p.held || !state.out_of_reach.empty());
    if (of_rule && o.go_on) ends_all = false;
    else if (!p.held && !o.until.empty() && state.out_of_reach.empty()) reason += ", -until does not hold yet";

    const std::string what = p.label.empty() ? "" : p.label + ": ";
    const char* const how = ends_all || !o.go_on ? "stopped" : p.held ? "settled" : "cannot settle";
    Verdict out{ends_all, fmt::format("vcmetrics: {}{} after {} frames: {}", what, how, sum.frames, reason), ""};
    p.done = p.done || !ends_all;
    if (!ends_all && !sum.last && !o.control.empty()) out.command = p.label.empty() ? "next" : "next " + p.label;
    return {p, out};
}

void say_end(const Options& o, const Progress& p) {
    if (o.until.empty() || p.held || p.done || o.go_on) return;
    const std::string what = p.label.empty() ? "the input" : p.label;
    base::say(
        fmt::format("vcmetrics: {} ended after {} frames: -until does not hold", what, std::max<int64_t>(p.frames, 0)));
}

int status(const Options& o, const Progress& p) {
    return !o.until.empty() && !o.go_on && (!p.held || p.missed) ? 4 : 0;
}
