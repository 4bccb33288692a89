// SPDX-License-Identifier: BSD-3-Clause
// See run.h.
#include "run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/split.h"
#include "glare/formulas.h"
#include "image/header.h"
#include "shared_paths.h"

using namespace glare;
using namespace report;

namespace {

// The interval lies around the value without bias, which the column itself may show or not.  Between looks this is
// the last look's value and interval; a value that has no bias is the present frame's, and its interval narrows as
// frames grow.
Number number_of(const Options& o, const Column& c, const uncertainty::Estimate& e, const Measurement& m,
                 int64_t frame) {
    const bool shows_estimate = c.printed_unbiased && !(c.of_filled && std::isnan(e.value));
    Number out{shows_estimate ? e.value : c.value(m), 0, {std::nan(""), std::nan("")}, {std::nan(""), 0}};
    out.middle = c.has_bias() ? e.value : out.value;
    const int64_t n = c.has_bias() ? e.frames : frame;
    if (o.ci) out.off = e.around(1 - *o.ci, n), out.error = {e.error_known_after(n), e.degrees};
    return out;
}

Number difference_of(const Options& o, const uncertainty::Estimate& d) {
    return {d.value, d.value, d.around(1 - o.ci.value_or(.95), d.frames), {d.error_known_after(d.frames), d.degrees}};
}

// Of a picture without values.
Number unknown_number(const Column& c) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    Number n{c.words ? double(dgp_class(nan)) : nan, nan, {nan, nan}, {}};
    n.error.error = nan;
    return n;
}

// ptrace -wea states the illuminances of each hour that has light (ptrace(1)).
bool is_dark_hour(const image::Header& header) {
    const auto states = [&](const char* name) {
        return std::any_of(header.lines.begin(), header.lines.end(),
                           [&](const std::string& line) { return base::begins_with(line, name); });
    };
    return states("IRRADIANCE= ") && !states("ILLUMINANCE= ");
}

Row row_of(const Options& o, const RunState& run, const image::Header& header, const PicturePlace& place,
           Measurement m) {
    Row out;
    out.file = place.file, out.view = header.view_name, out.sky = header.sky_name, out.state = header.state,
    out.edit = header.edit;
    out.paths = paths_of(header);
    out.hour = hour_of(header);
    out.frame = frame_number(header, place);
    out.may_be_black =
        !header.unknown.empty() || is_dark_hour(header) || (header.frames == 0 && header.last_frame != 0);
    out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - run.start).count();
    for (size_t k = 0; k < run.plan.columns.size(); ++k) {
        const Column& c = run.plan.columns[k];
        const uncertainty::Estimate& e = run.sum.look.estimate(k);
        out.numbers.push_back(header.unknown.empty() ? number_of(o, c, e, m, out.frame) : unknown_number(c));
        if (prints_halves(o, header)) out.numbers.back().error.halves = halves_of(run.sum.look, k, c.noise);
        if (!o.against.empty()) out.differences.push_back(difference_of(o, run.edits.difference(k)));
        if (c.printed && e.unreliable) out.heavy_tailed += (out.heavy_tailed.empty() ? "" : " ") + c.name;
    }
    out.measurement = std::move(m);
    return out;
}

}  // namespace

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
    const RunPlan& plan = run.plan;
    run.reading = read(plan.measured, p, place.text, o.view, std::move(run.reading));
    const bool passes = o.last && is_followed(p.header, frame_number(p.header, place));
    if (plan.needs_looks) run.sum = add(std::move(run.sum), p, run.reading, place.text, plan.reports, passes);
    if (passes) return {std::move(run), std::nullopt};
    Measurement m = measure(run.reading);
    if (plan.needs_looks) {
        run.sum = look(std::move(run.sum), run.reading, m, plan.columns, plan.first_look);
    }
    if (!o.against.empty()) {
        run.edits = begin(std::move(run.edits), o.against, p.header.edit.value_or(0));
        if (run.sum.looked)
            run.edits = add(std::move(run.edits), {run.sum.look.replicates, plan.keys, quantities_of(plan.columns)});
    }
    Row row = row_of(o, run, p.header, place, std::move(m));
    if (o.mode == OutputMode::evalglare || o.list_sources) return {std::move(run), std::move(row)};
    const Luminance& lum = run.reading.lum;
    const MeasuredSum sum{row.frame, row.seconds, run.sum.looked ? &run.sum.look : nullptr, bool(lum.moments),
                          lum.width, lum.height,  p.header.last_frame == row.frame};
    std::tie(run.progress, row.verdict) = decide(o, rule_state(plan.rule, sum), std::move(run.progress), sum);
    row.settled = run.progress.held && !plan.waits;
    return {std::move(run), std::move(row)};
}
