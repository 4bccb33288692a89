// SPDX-License-Identifier: BSD-3-Clause
// Pictures from files or stdin, one line each, until the rule holds or there are no more (measure_stream.h).
#include "measure_stream.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include "actions.h"
#include "base/command_pipe.h"
#include "base/error.h"
#include "base/run.h"
#include "base/shutdown.h"
#include "base/split.h"
#include "evalglare/check_picture.h"
#include "evalglare/output.h"
#include "display/file.h"
#include "drawing.h"
#include "grids.h"
#include "image/header.h"
#include "image/stream.h"
#include "report_file.h"
#include "row.h"
#include "run.h"

namespace {
using namespace glare;
using namespace report;

// On a terminal each line begins with an empty one: programs upstream show their progress there.
void print(const std::string& text) {
    if (base::stdout_is_terminal()) base::write_stdout("\r\033[K", 4);
    base::write_stdout(text.data(), text.size());
    base::flush_stdout();
}

void write_check_picture(const Options& o, const image::Picture& measured, const RunState& run, const Row& row) {
    image::Picture check;
    check.width = measured.width;
    check.height = measured.height;
    check.rgb = evalglare::draw_check_picture(run.reading, row.measurement, o.evalglare);
    check.header.lines = measured.header.lines;
    check.header.view = o.view ? o.view : measured.header.view;
    image::add_history(check.header, o.command);
    display::write_file(o.check_file, check, {});
}

// Prints what evalglare prints before it gives up on a picture.
[[noreturn]] void refuse(const Options& o, const base::Error& refusal) {
    const std::string text = o.mode == OutputMode::evalglare ? evalglare::stdout_text(refusal) : "";
    if (!text.empty()) print(text);
    throw;
}

// Only the first picture tells whether the names are numbers of its grids.
bool may_measure_grids(const Options& o) {
    std::vector<std::string> names = o.metrics;
    for (const std::string& part : base::split_list(o.until, ','))
        for (const std::string& word : base::split_words(part)) names.push_back(word);
    return std::any_of(names.begin(), names.end(), may_be_of_grid);
}

// Says and sends what was decided; whether the run ends.
bool follow(const Options& o, const Verdict& v) {
    if (!v.says.empty()) base::say(v.says);
    if (!v.stops && !v.command.empty()) base::send_command(o.control, v.command);
    return v.stops;
}

struct Printed {
    Heading heading;
    std::optional<Row> held_back;  // with -last, until the pictures of its actions have come
};

// With another row; null: the last one has come.
Printed with_row(const Options& o, const RunState& run, Printed p, const Row* row) {
    const auto print_row = [&](const Row& r) {
        RowText out = text_of(o, std::move(p.heading), run, r);
        p.heading = std::move(out.heading);
        if (!out.names.empty()) print(out.names);
        print(out.lines);
    };
    if (p.held_back && !(row && row->group == p.held_back->group)) print_row(*p.held_back);
    p.held_back.reset();
    if (row && o.last && !row->complete) p.held_back = *row;
    else if (row) print_row(*row);
    return p;
}

// Whether the run ends.
bool measures(const Options& o, GridState& state, image::Picture& picture, const PicturePlace& place,
              const RunState& run) {
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - run.start).count();
    GridStep next = step(o, std::move(state), picture, frame_number(picture.header, place), seconds);
    state = std::move(next.state);
    if (!next.text.empty()) print(next.text);
    if (!o.over_file.empty()) draw_map(o, state);
    return follow(o, next.verdict);
}

// Said of the last sum of a picture: frame 0 alone may lack all of its light.
void tell_if_black(const Row& last, const Row* next) {
    const bool same = next && next->file == last.file && next->view == last.view && next->sky == last.sky &&
                      next->state == last.state && next->edit == last.edit && next->frame > last.frame;
    if (same || last.may_be_black || !is_black(last.measurement)) return;
    image::Header names;
    names.view_name = last.view, names.sky_name = last.sky, names.state = last.state;
    std::string place = image::label(names);
    if (place.empty()) place = last.file == "-" ? "stdin" : last.file;
    base::warn(place, std::string("the picture is black: ") + why_black);
}

// Of numbers alone.
bool is_table(const Options& o) {
    return o.mode == OutputMode::vcmetrics && !o.list_sources && o.check_file.empty() && o.over_file.empty() &&
           o.report_file.empty();
}

int end_of(const Options& o, const GridState& s) {
    if (const std::string text = rows_of_points(o, s); !text.empty()) print(text);
    tell_if_alone(o, s);
    return status(o, s.progress);
}

}  // namespace

// evalglare knows neither PRIMARIES= nor COLORCORR=.
image::Pixels pixels_for(const Options& o) {
    return o.evalglare_bug_compatible ? image::Pixels::exposed : image::Pixels::radiance;
}

int measure_all(const Options& asked) {
    Options o = asked;
    const bool from_files = !o.files.empty();
    if (!from_files && base::stdin_is_terminal())
        base::say_on_terminal("vcmetrics: waits for pictures on the standard input; vcmetrics -help tells more");
    RunState run;
    bool planned = !may_measure_grids(o);
    if (planned) run.plan = plan_run(o);
    Printed printed;
    GridState grids;
    image::Picture picture, copy, shown;  // measuring uses up a picture's pixels; shown: that of the last row
    std::optional<Row> last;
    const bool shows = !o.over_file.empty() || !o.report_file.empty();
    const auto end = [&](int status) {
        printed = with_row(o, run, std::move(printed), nullptr);
        if (last) tell_if_black(*last, nullptr);
        if (last && shows && shown.rgb.empty())
            base::fail(last->file == "-" ? "stdin" : last->file,
                       "-report and -over show the ordinary picture, which is not there");
        if (last && !o.report_file.empty()) write_report(o, shown, run, *last);
        return status;
    };
    for (const std::string& file : from_files ? o.files : std::vector<std::string>{"-"}) {
        image::StreamReader reader(file, pixels_for(o), o.scene_options.opener(""));
        for (long index = 0; reader.next(picture); ++index) {
            base::finish_on_signal();  // from the first picture on: its line is finished
            if (!picture.header.grids.empty() || !grids.kinds.empty()) {
                if (picture.header.grids.empty()) base::fail(place_of(file, index).text, "is not a picture of points");
                if (!o.report_file.empty()) base::fail("-report", "is of pictures of a view");
                require_measurable(picture, place_of(file, index).text);
                if (measures(o, grids, picture, place_of(file, index), run)) return end_of(o, grids);
                if (base::shutdown_requested()) return 0;
                continue;
            }
            if (!o.over_file.empty() && image::ending_of(o.over_file) != ".png")
                base::fail("-over", "writes a .png of pictures of a view");
            if (is_table(o) && o.metrics.empty() && picture.header.action && !last)
                o.metrics = default_columns_of(*picture.header.action), planned = false;
            if (!planned) run.plan = plan_run(o);
            planned = true;
            const bool is_shown = shows && !run.plan.actions.kind_of(picture.header);
            if (is_shown) copy = picture;
            std::optional<Row> row;
            try {
                std::tie(run, row) = step(o, std::move(run), picture, place_of(file, index));
            } catch (const base::Error& refusal) {
                refuse(o, refusal);
            }
            if (row) {
                if (!o.check_file.empty()) write_check_picture(o, picture, run, *row);
                printed = with_row(o, run, std::move(printed), &*row);
                if (last) tell_if_black(*last, &*row);
                if (is_shown) std::swap(shown, copy);
                if (is_shown && !o.over_file.empty()) draw_measured(o, shown, run, row->measurement);
                last = std::move(row);
                if (follow(o, last->verdict)) return end(status(o, run.progress));
            }
            if (base::shutdown_requested()) return end(0);
        }
        run.sum = end_input(std::move(run.sum), place_of(file, 0).text, run.plan.needs_looks && run.plan.reports);
    }
    run.group = end_group(run.plan, std::move(run.group), true);
    say_end(o, grids.kinds.empty() ? run.progress : grids.progress);
    if (!grids.kinds.empty()) return end_of(o, grids);
    if (!planned) plan_run(o);                                             // says what is wrong
    if (o.mode == OutputMode::evalglare && o.evalglare.ev_only) return 1;  // as evalglare -V
    return end(status(o, run.progress));
}
