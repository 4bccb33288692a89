// SPDX-License-Identifier: BSD-3-Clause
// See actions.h.
#include "actions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/run.h"
#include "glare/actions.h"
#include "image/header.h"
#include "shared_paths.h"
#include "uncertainty/ratio.h"

using namespace glare;
using namespace report;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double told_share = .02;  // of E by V: by how much the ordinary Ev is off

image::Header without_action(image::Header h) {
    h.action.reset();
    return h;
}

Group another(const Group& before, const RunPlan& plan) {
    Group out;
    out.number = before.number + 1;
    out.told_missing = before.told_missing, out.told_other_ev = before.told_other_ev;
    out.actions.resize(plan.actions.kinds.size());
    out.seen_ever = before.seen_ever;
    out.seen_ever.resize(plan.actions.kinds.size());
    for (size_t k = 0; k < std::min(before.actions.size(), out.actions.size()); ++k)
        out.actions[k].reading = before.actions[k].reading;
    return out;
}

bool has_actions(const Group& g) {
    return std::any_of(g.actions.begin(), g.actions.end(), [](auto& a) { return a.seen; });
}

// The first picture of another one with the same names.
bool comes_again(const Group& g, const image::Header& h, std::optional<size_t> kind, const PicturePlace& place) {
    if (!h.action) return has_actions(g);
    return kind && g.actions[*kind].seen && frame_number(h, place) <= g.actions[*kind].frames;
}

// Of what a column of actions consists.
std::vector<size_t> kinds_of(const ActionPlan& plan, const ActionPlan::Cell& cell) {
    if (!cell.ratio) return {cell.kind};
    return {cell.kind, plan.by_V.kind};
}

bool is_of(const ActionPlan& plan, const ActionPlan::Cell& cell, size_t kind) {
    const std::vector<size_t> kinds = kinds_of(plan, cell);
    return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

uncertainty::Measured look_at(const ActionPart& part, size_t place) {
    return {&part.look->replicates, place, part.look->estimate(place)};
}

// Both looks of a ratio, if they are there.
std::optional<std::pair<uncertainty::Measured, uncertainty::Measured>> both_of(const RunPlan& plan, const Group& g,
                                                                               const ActionPlan::Cell& cell) {
    const ActionPlan::Cell& v = plan.actions.by_V;
    const ActionPart &over = g.actions[cell.kind], &under = g.actions[v.kind];
    if (!cell.ratio || !over.look || !under.look) return std::nullopt;
    return std::pair{look_at(over, cell.place), look_at(under, v.place)};
}

std::vector<uncertainty::Estimate> ratios_of(const RunPlan& plan, const Group& g) {
    std::vector<uncertainty::Estimate> out;
    for (const ActionPlan::Cell& cell : plan.actions.cells) {
        const auto both = both_of(plan, g, cell);
        out.push_back(both ? uncertainty::ratio(both->first, both->second) : no_estimate);
    }
    return out;
}

Number cell_number(const Options& o, const RunState& run, const image::Header& header, size_t i) {
    const ActionPlan& plan = run.plan.actions;
    const ActionPlan::Cell& cell = plan.cells[i];
    const ActionPart& part = run.group.actions[cell.kind];
    if (!part.seen || part.numbers.empty()) return unknown_number(cell.column);
    if (!cell.ratio) return part.numbers[cell.place];
    const ActionPart& by_V = run.group.actions[plan.by_V.kind];
    if (!by_V.seen || by_V.numbers.empty()) return unknown_number(cell.column);
    const uncertainty::Estimate e = i < run.group.ratios.size() ? run.group.ratios[i] : no_estimate;
    Number out =
        number_of(o, cell.column, e, part.numbers[cell.place].value / by_V.numbers[plan.by_V.place].value, e.frames);
    const auto both = both_of(run.plan, run.group, cell);
    if (both && prints_halves(o, header))
        out.error.halves = uncertainty::halves_of(uncertainty::ratio_of_half_samples(both->first, both->second),
                                                  uncertainty::degrees_of_freedom(both->first.replicates->frames));
    return out;
}

uncertainty::Estimate cell_estimate(const RunState& run, size_t i) {
    const ActionPlan::Cell& cell = run.plan.actions.cells[i];
    const ActionPart& part = run.group.actions[cell.kind];
    if (cell.ratio) return i < run.group.ratios.size() ? run.group.ratios[i] : no_estimate;
    return part.look ? part.look->estimate(cell.place) : no_estimate;
}

bool all_ended(const Group& g) {
    return std::all_of(g.actions.begin(), g.actions.end(), [](const ActionPart& a) { return a.ended; });
}

// The parts of -until that a picture can meet: with -control each is ended by itself.
std::string own_rule(const Options& o, const RunState& run, std::optional<size_t> kind) {
    const ActionPlan& plan = run.plan.actions;
    return parts_of_rule(o.until, [&](const std::string& name) {
        const auto cell =
            std::find_if(plan.cells.begin(), plan.cells.end(), [&](auto& c) { return c.column.name == name; });
        if (cell == plan.cells.end()) return !kind;
        if (!kind || !is_of(plan, *cell, *kind)) return false;
        const std::vector<size_t> kinds = kinds_of(plan, *cell);
        return std::all_of(kinds.begin(), kinds.end(), [&](size_t k) { return run.group.actions[k].seen; });
    });
}

// Pictures of actions that the rule does not name are rendered to their end.
bool waits(const RunState& run) {
    const ActionPlan& plan = run.plan.actions;
    for (size_t k = 0; k < plan.kinds.size(); ++k) {
        const bool named = std::any_of(run.plan.rule.watched.begin(), run.plan.rule.watched.end(), [&](size_t c) {
            return c >= run.plan.ordinary && is_of(plan, plan.cells[c - run.plan.ordinary], k);
        });
        if (!named && !run.group.actions[k].ended) return true;
    }
    return false;
}

// The RGB of a picture has no say in what V weighs.
void tell_other_ev(const RunPlan& plan, Group& g) {
    const auto of_V = std::find_if(plan.actions.kinds.begin(), plan.actions.kinds.end(),
                                   [](auto& k) { return k.name == illuminance_by_V; });
    if (of_V == plan.actions.kinds.end() || !g.ordinary || g.told_other_ev) return;
    const auto ev_of = [](const std::vector<Column>& columns, const std::vector<Number>& numbers) {
        const auto ev = std::find_if(columns.begin(), columns.end(), [](const Column& c) { return c.name == "Ev"; });
        const size_t k = size_t(ev - columns.begin());
        return ev != columns.end() && k < numbers.size() ? numbers[k].value : nan;
    };
    const ActionPart& part = g.actions[size_t(of_V - plan.actions.kinds.begin())];
    const double by_V = ev_of(of_V->columns, part.numbers), ordinary = ev_of(plan.columns, g.ordinary->numbers);
    if (part.frames != g.ordinary->frame || !(std::fabs(ordinary - by_V) > told_share * by_V)) return;
    g.told_other_ev = true;
    base::warn(
        g.label.empty() ? part.place : g.label,
        fmt::format("illuminance by V is {:.4g} lx (EvV), of the ordinary picture's red, green and blue {:.4g} lx "
                    "(Ev), {:+.1f} %: light or materials have colours",
                    by_V, ordinary, 100 * (ordinary / by_V - 1)));
}

}  // namespace

Group with_picture(const RunPlan& plan, Group g, const image::Header& h, const PicturePlace& place) {
    const std::optional<size_t> kind = plan.actions.kind_of(h);
    const std::string label = image::label(without_action(h));
    const bool other = label != g.label || h.edit != g.edit || g.actions.size() != plan.actions.kinds.size();
    if (other || comes_again(g, h, kind, place)) g = another(end_group(plan, std::move(g), false), plan);
    g.label = label, g.edit = h.edit, g.of_hour = h.hour.has_value();
    if (kind) g.seen_ever[*kind] = true;
    if (!h.action) g.file = place.file;
    if (h.action && !kind && g.file != place.file) require_pictures_of("", h, place.text);
    return g;
}

bool is_passed_over(const RunPlan& plan, const Group& g, const image::Header& h, const PicturePlace& place) {
    return h.action && !plan.actions.kind_of(h) && g.file == place.file;
}

Group end_group(const RunPlan& plan, Group g, bool ends) {
    for (ActionPart& a : g.actions)
        if (a.seen) a.sum = end_input(std::move(a.sum), a.place, plan.needs_looks && plan.reports);
    if (!(g.ordinary || has_actions(g)) || g.told_missing) return g;
    for (const ActionPlan::Cell& cell : plan.actions.cells)
        for (const size_t k : kinds_of(plan.actions, cell)) {
            if (g.actions[k].seen || g.told_missing || (g.of_hour && (!ends || g.seen_ever[k]))) continue;
            const std::string renders = command_for(plan.actions.kinds[k].name);
            g.told_missing = true;
            base::warn(g.label.empty() ? place_of(g.file.empty() ? "-" : g.file, 0).text : g.label,
                       fmt::format("{} needs a picture of action {}, and there is none: {} renders it",
                                   cell.column.name, renders.substr(renders.rfind(' ') + 1), renders));
        }
    return g;
}

Row with_actions(const Options& o, const RunState& run, const image::Header& header, Row row) {
    const std::vector<ActionPlan::Cell>& cells = run.plan.actions.cells;
    for (size_t i = 0; i < cells.size(); ++i) {
        const Column& c = cells[i].column;
        row.numbers.push_back(cell_number(o, run, header, i));
        if (!o.against.empty()) row.differences.push_back(difference_of(o, no_estimate));
        if (cell_estimate(run, i).unreliable) row.heavy_tailed += (row.heavy_tailed.empty() ? "" : " ") + c.name;
    }
    row.group = run.group.number;
    row.complete = all_ended(run.group);
    return row;
}

std::pair<RunState, std::optional<Row>> step_of_action(const Options& o, RunState run, size_t k, image::Picture& p,
                                                       const PicturePlace& place) {
    const RunPlan& plan = run.plan;
    const ActionPlan::Kind& kind = plan.actions.kinds[k];
    ActionPart& part = run.group.actions[k];
    part.frames = frame_number(p.header, place), part.place = place.text;
    part.seen = true, part.ended = !is_followed(p.header, part.frames);
    part.reading = read(kind.measured, p, place.text, o.view, std::move(part.reading));
    const bool passes = o.last && !part.ended;
    if (plan.needs_looks) part.sum = add(std::move(part.sum), p, part.reading, place.text, plan.reports, passes);
    if (passes) return {std::move(run), std::nullopt};
    const Measurement m = measure(part.reading);
    if (plan.needs_looks) part.sum = look(std::move(part.sum), part.reading, m, kind.columns, plan.first_look);
    if (part.sum.looked) part.look = part.sum.look, run.group.ratios = ratios_of(plan, run.group);
    part.numbers.clear();
    for (size_t c = 0; c < kind.columns.size(); ++c) {
        const Column& column = kind.columns[c];
        const uncertainty::Estimate e = part.look ? part.look->estimate(c) : no_estimate;
        part.numbers.push_back(p.header.unknown.empty() ? number_of(o, column, e, column.value(m), part.frames)
                                                        : unknown_number(column));
        if (part.look && prints_halves(o, p.header))
            part.numbers.back().error.halves = halves_of(*part.look, c, column.noise);
    }
    tell_other_ev(plan, run.group);

    Row row = row_of(run, p.header, place);
    if (run.group.ordinary) {
        const Row& ordinary = *run.group.ordinary;
        row.numbers = ordinary.numbers, row.differences = ordinary.differences;
        row.heavy_tailed = ordinary.heavy_tailed, row.measurement = ordinary.measurement;
    } else {
        for (size_t c = 0; c < plan.ordinary; ++c) {
            row.numbers.push_back(unknown_number(plan.columns[c]));
            if (!o.against.empty()) row.differences.push_back(difference_of(o, no_estimate));
        }
    }
    row.may_be_black = true;  // what there is to say of it is said of the ordinary picture
    row = with_actions(o, run, p.header, std::move(row));
    const bool looked = part.sum.looked;
    const MeasuredSum sum{
        row.frame, row.seconds, nullptr, run.group.moments, p.width, p.height, p.header.last_frame == row.frame};
    std::tie(run.progress, row.verdict) = judge(o, run, k, sum, looked);
    row.settled = run.progress.held && !plan.waits;
    return {std::move(run), std::move(row)};
}

std::pair<Progress, Verdict> judge(const Options& o, const RunState& run, std::optional<size_t> kind, MeasuredSum sum,
                                   bool looked) {
    Look all;
    all.estimates = run.group.estimates;
    all.estimates.resize(run.plan.ordinary, no_estimate);
    for (size_t i = 0; i < run.plan.actions.cells.size(); ++i) all.estimates.push_back(cell_estimate(run, i));
    sum.looked = looked ? &all : nullptr;
    Progress progress = run.progress;
    if (run.plan.actions.empty()) return decide(o, rule_state(run.plan.rule, sum), progress, sum);
    if (o.control.empty()) {
        RuleState state = rule_state(run.plan.rule, sum);
        state.holds = state.holds && !waits(run);
        return decide(o, state, progress, sum);
    }
    const std::string own = own_rule(o, run, kind);
    progress.held = progress.held || (own.empty() && !o.until.empty());
    return decide(o, rule_state(stop_rule(o, own, run.plan.columns), sum), progress, sum);
}
