// SPDX-License-Identifier: BSD-3-Clause
// See run.h.
#include "run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "actions.h"
#include "base/error.h"
#include "base/split.h"
#include "glare/formulas.h"
#include "image/header.h"
#include "shared_paths.h"

using namespace glare;
using namespace report;

namespace {

// ptrace -wea states the illuminances of each hour that has light (ptrace(1)).
bool is_dark_hour(const image::Header& header) {
    const auto states = [&](const char* name) {
        return std::any_of(header.lines.begin(), header.lines.end(),
                           [&](const std::string& line) { return base::begins_with(line, name); });
    };
    return states("IRRADIANCE= ") && !states("ILLUMINANCE= ");
}

Row ordinary_row(const Options& o, const RunState& run, const image::Header& header, const PicturePlace& place,
                 Measurement m) {
    Row out = row_of(run, header, place);
    out.may_be_black =
        !header.unknown.empty() || is_dark_hour(header) || (header.frames == 0 && header.last_frame != 0);
    for (size_t k = 0; k < run.plan.ordinary; ++k) {
        const Column& c = run.plan.columns[k];
        const uncertainty::Estimate& e = run.sum.look.estimate(k);
        out.numbers.push_back(header.unknown.empty() ? number_of(o, c, e, c.value(m), out.frame) : unknown_number(c));
        if (prints_halves(o, header)) out.numbers.back().error.halves = halves_of(run.sum.look, k, c.noise);
        if (!o.against.empty()) out.differences.push_back(difference_of(o, run.edits.difference(k)));
        if (c.printed && e.unreliable) out.heavy_tailed += (out.heavy_tailed.empty() ? "" : " ") + c.name;
    }
    out.measurement = std::move(m);
    return out;
}

}  // namespace

Row row_of(const RunState& run, const image::Header& header, const PicturePlace& place) {
    Row out;
    out.file = place.file, out.view = header.view_name, out.sky = header.sky_name, out.state = header.state,
    out.edit = header.edit;
    out.paths = paths_of(header);
    out.hour = hour_of(header);
    out.frame = frame_number(header, place);
    out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - run.start).count();
    return out;
}

PicturePlace place_of(const std::string& file, long index) {
    const std::string name = file == "-" ? "stdin" : file;
    return {index ? fmt::format("{}: picture {}", name, index + 1) : name, file, index};
}

// Diffuse frames in a sum, else the number of a single frame, else the place in the stream.
int64_t frame_number(const image::Header& header, const PicturePlace& place) {
    return header.frames.value_or(header.frame.value_or(place.index));
}

bool is_followed(const image::Header& header, int64_t frame) {
    return header.last_frame && *header.last_frame != frame;
}

void require_measurable(const image::Picture& p, const std::string& place) {
    image::require_complete(p, place);
    if (p.header.tabbed_exposure)
        base::fail(
            place,
            "an EXPOSURE= line of the header holds a tab, as pcomb and pcompos leave it: the pixels' scale is unknown "
            "(remove the line, or divide the exposure out with pfilt -1 or ra_xyze -r -u)");
}

std::pair<RunState, std::optional<Row>> step(const Options& o, RunState run, image::Picture& p,
                                             const PicturePlace& place) {
    if (p.header.edited == "preview") return {std::move(run), std::nullopt};
    require_measurable(p, place.text);
    run.group = with_picture(run.plan, std::move(run.group), p.header, place);
    if (is_passed_over(run.plan, run.group, p.header, place)) return {std::move(run), std::nullopt};
    const std::string edit = p.header.edit && o.go_on ? fmt::format("edit {}", *p.header.edit) : "";
    run.progress =
        begin(o, std::move(run.progress), edit.empty() ? image::label(p.header) : edit, frame_number(p.header, place));
    if (run.progress.done && !o.go_on) return {std::move(run), std::nullopt};
    if (p.header.edit) {
        const int reading = run.plan.reading;
        run.plan = with_present_regions(o, std::move(run.plan));
        if (run.plan.reading != reading) run.sum = without_look(std::move(run.sum));
    } else {
        require_pairs(run.plan);
    }
    if (const auto kind = run.plan.actions.kind_of(p.header)) return step_of_action(o, std::move(run), *kind, p, place);
    const RunPlan& plan = run.plan;
    run.reading = read(plan.measured, p, place.text, o.view, std::move(run.reading));
    const bool passes = o.last && is_followed(p.header, frame_number(p.header, place));
    if (plan.needs_looks) run.sum = add(std::move(run.sum), p, run.reading, place.text, plan.reports, passes);
    if (passes) return {std::move(run), std::nullopt};
    Measurement m = measure(run.reading);
    const std::vector<Column> columns = ordinary_columns(plan);
    if (plan.needs_looks) {
        run.sum = look(std::move(run.sum), run.reading, m, columns, plan.first_look);
    }
    if (!o.against.empty()) {
        run.edits = begin(std::move(run.edits), o.against, p.header.edit.value_or(0));
        if (run.sum.looked)
            run.edits = add(std::move(run.edits), {run.sum.look.replicates, plan.keys, quantities_of(columns)});
    }
    run.group.ordinary = ordinary_row(o, run, p.header, place, std::move(m));
    run.group.estimates = run.sum.look.estimates, run.group.moments = bool(run.reading.lum.moments);
    Row row = with_actions(o, run, p.header, *run.group.ordinary);
    if (o.mode == OutputMode::evalglare || o.list_sources) return {std::move(run), std::move(row)};
    const Luminance& lum = run.reading.lum;
    const MeasuredSum sum{
        row.frame, row.seconds, nullptr, bool(lum.moments), lum.width, lum.height, p.header.last_frame == row.frame};
    std::tie(run.progress, row.verdict) = judge(o, run, std::nullopt, sum, run.sum.looked);
    row.settled = run.progress.held && !plan.waits;
    return {std::move(run), std::move(row)};
}
