// SPDX-License-Identifier: BSD-3-Clause
// See run_plan.h.
#include "run_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <filesystem>

#include "base/error.h"
#include "base/printable.h"
#include "base/run.h"
#include "evalglare/source_finder.h"
#include "region/open.h"
#include "report/until.h"
#include "uncertainty/stopping.h"

using namespace glare;

namespace {

// The effect of pixels on the metrics of a rule is measured, too.
std::vector<std::string> pixel_columns(const report::UntilRule& rule) {
    std::vector<std::string> out;
    for (const report::Tolerance& t : rule.tolerances()) out.push_back(pixels_column(t.metric));
    out.push_back(pixels_column(rule.class_of()));
    out.erase(std::remove(out.begin(), out.end(), ""), out.end());
    return out;
}

void tell(const base::Error& e) { base::say("vcmetrics: " + base::printable(e.text)); }

// Regions that cannot be drawn for a view and size are out of sight: a warning, and no pixel.
// gone: names that the file does not have any more.
image::DrawRegions lenient(const image::MaskSet& masks, const image::DrawRegions& draw, const std::string& file,
                           const std::vector<std::string>& gone) {
    return [=](const view::View& view, int width, int height) {
        image::MaskSet out = masks;
        try {
            if (draw) out = draw(view, width, height);
            if (out.width != width || out.height != height)
                base::fail(file, fmt::format("the picture has {} x {} pixels, the masks {} x {}", width, height,
                                             out.width, out.height));
        } catch (const base::Error& e) {
            tell(e);
            for (image::Mask& m : out.masks) m.coverage.clear();
        }
        for (const std::string& name : gone) out.masks.push_back({name, {}});
        out.width = width, out.height = height;
        return out;
    };
}

// A file that is being written changes again at once.
bool is_quiet(const base::FileStamp& file) {
    timespec now{};
    clock_gettime(CLOCK_REALTIME, &now);
    const double age_s =
        double(now.tv_sec) - double(file.seconds) + 1e-9 * (double(now.tv_nsec) - double(file.nanoseconds));
    return age_s < 0 || age_s > .025;
}

std::vector<std::string> region_names(const glare::Plan& plan) {
    std::vector<std::string> out;
    if (plan.regions)
        for (const image::Mask& m : plan.regions->masks) out.push_back(m.name);
    return out;
}

// Part of a column of -metrics, of a rule, or of a pair.
bool is_named(const Options& o, const RunPlan& plan, const std::string& region) {
    std::vector<std::string> names = o.metrics;
    if (plan.rule.rule)
        for (const report::Tolerance& t : plan.rule.rule->tolerances()) names.push_back(t.metric);
    for (const ContrastPair& pair : plan.pairs) names.insert(names.end(), {pair.low + ".", pair.high + "."});
    return std::any_of(names.begin(), names.end(),
                       [&](const std::string& n) { return n.compare(0, region.size() + 1, region + ".") == 0; });
}

bool contains(const std::vector<std::string>& all, const std::string& one) {
    return std::find(all.begin(), all.end(), one) != all.end();
}

// Column, rule and looks for these regions.
void choose_columns(const Options& o, const std::vector<std::string>& regions, RunPlan& plan, glare::Plan& measured) {
    const bool table = o.mode == OutputMode::vcmetrics && !o.list_sources;
    const SplitNames names = table ? split_names(o.metrics) : SplitNames{o.metrics, {}};
    const bool none_ordinary = names.ordinary.empty() && !names.of_actions.empty();
    ColumnChoice choice;
    choice.names = none_ordinary ? std::vector<std::string>{"Ev"} : names.ordinary;
    choice.accelerad = o.mode == OutputMode::accelerad;
    choice.regions = regions;
    choice.regions_come = !o.regions_file.empty();
    if (!o.until.empty()) choice.hidden = pixel_columns(report::UntilRule(o.until));
    if (!o.report_file.empty()) choice.hidden.push_back("DGP");  // of a picture without moments
    for (const ContrastPair& pair : plan.pairs)
        if (contains(regions, pair.low) && contains(regions, pair.high)) choice.pairs.push_back(pair);
    choice.pairs_come = !plan.pairs.empty();
    if (!names.of_actions.empty()) choice.hidden.push_back("Ev");  // that by V is compared with it
    plan.columns = glare::choose_columns(choice, o.settings, measured.requirements);
    if (none_ordinary) plan.columns[0].printed = false;
    plan.ordinary = plan.columns.size();
    plan.actions = plan_actions(names.of_actions, measured, choice);
    for (const ActionPlan::Cell& cell : plan.actions.cells) plan.columns.push_back(cell.column);
    plan.rule = stop_rule(o, o.until, plan.columns);

    plan.keys.clear();
    bool shown = o.ci || !o.against.empty();
    plan.reports = shown || !o.until.empty();
    for (const Column& c : plan.columns) {
        const bool of_region = c.name.find('.') != std::string::npos && !c.of_filled;
        const bool by_reading = of_region || !o.settings.task_region.empty();
        plan.keys.push_back(by_reading ? fmt::format("{} {}", c.name, plan.reading) : c.name);
        shown |= c.printed && c.printed_unbiased;
        plan.reports |= c.printed_unbiased && !c.of_filled;
    }
    plan.keys.resize(plan.ordinary);
    plan.needs_looks = shown || !o.until.empty();
    plan.first_look = shown ? 0 : uncertainty::least_frames;
}

}  // namespace

RunPlan plan_run(const Options& o) {
    RunPlan out;
    out.version = base::stamp_of(o.regions_file);
    glare::Plan measured;
    measured.settings = o.settings;
    if (!o.regions_file.empty())
        measured.regions = region::open(o.regions_file, measured.draw, region::Check::empty_and_small, true,
                                        o.scene_options.read.get());
    base::refuse_to_overwrite({o.over_file, o.check_file, o.report_file}, base::paths_of(*o.scene_options.read));
    const std::vector<std::string> regions = region_names(measured);
    if (measured.regions && regions.empty()) base::warn(o.regions_file, "holds no region");
    for (const std::string& text : o.contrast_pairs) out.pairs.push_back(parse_pair(text));
    if (o.regions_file.empty() || (!regions.empty() && !measured.draw))  // none come later
        for (const ContrastPair& pair : out.pairs) require_regions(pair, regions);
    choose_columns(o, regions, out, measured);
    Requirements& required = measured.requirements;
    if (o.mode == OutputMode::evalglare)
        required = require::sources | (o.evalglare.detailed || o.settings.mask_file ? require::medians : 0);
    if (o.list_sources || !o.check_file.empty() || !o.over_file.empty() || !o.report_file.empty())
        required |= require::sources;
    if (o.evalglare_bug_compatible) {
        required &= ~require::filled;
        measured.methods = evalglare::methods(o.evalglare);
    }
    out.measured = make_plan(std::move(measured));
    return out;
}

std::vector<Column> ordinary_columns(const RunPlan& plan) {
    return {plan.columns.begin(), plan.columns.begin() + std::ptrdiff_t(plan.ordinary)};
}

void require_pairs(const RunPlan& plan) {
    const std::vector<std::string> regions = region_names(*plan.measured);
    for (const ContrastPair& pair : plan.pairs) require_regions(pair, regions);
}

RunPlan with_present_regions(const Options& o, RunPlan plan) {
    std::error_code absent;
    const base::FileStamp now = base::stamp_of(o.regions_file);
    const bool is_there = std::filesystem::is_regular_file(o.regions_file, absent);
    const bool is_news = is_there && !(plan.again && now == plan.version);
    plan.waits = is_news && plan.again && !is_quiet(now);
    if (!is_news || plan.waits) return plan;
    plan.version = now, plan.again = true;
    try {
        glare::Plan measured = *plan.measured;
        image::DrawRegions draw;
        image::MaskSet masks = region::open(o.regions_file, draw, region::Check::none, true), all = masks;
        std::vector<std::string> gone;
        const auto lacks = [&](const std::string& r) {
            return std::none_of(all.masks.begin(), all.masks.end(), [&](const image::Mask& m) { return m.name == r; });
        };
        const auto keep = [&](const std::string& r) {
            if (lacks(r)) gone.push_back(r), all.masks.push_back({r, {}});
        };
        for (const std::string& r : region_names(*plan.measured))
            if (is_named(o, plan, r)) keep(r);
        for (const ContrastPair& pair : plan.pairs) keep(pair.low), keep(pair.high);  // which may not have come yet
        measured.draw = lenient(masks, draw, o.regions_file, gone);
        measured.regions = std::move(all);
        RunPlan next = plan;
        ++next.reading;
        const Requirements before = measured.requirements;
        choose_columns(o, region_names(measured), next, measured);
        measured.requirements =
            (before & ~require::regions_in_full) | (measured.requirements & require::regions_in_full);
        next.measured = make_plan(std::move(measured));
        return next;
    } catch (const base::Error& e) {
        tell(e);
        return plan;
    }
}
