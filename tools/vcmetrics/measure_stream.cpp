// SPDX-License-Identifier: BSD-3-Clause
// Pictures from files or stdin, one line each, until the rule holds or there are no more (measure_stream.h).
#include "measure_stream.h"
#include <fmt/format.h>
#include <chrono>
#include <cmath>
#include "base/error.h"
#include "base/run.h"
#include "base/shutdown.h"
#include "certain.h"
#include "evalglare/check_picture.h"
#include "evalglare/output.h"
#include "display/file.h"
#include "drawing.h"
#include "image/header.h"
#include "image/stream.h"
#include "measured.h"
#include "row.h"
#include "stopping.h"
#include "uncertainty/stopping.h"

namespace {
using namespace glare;
using namespace report;
using uncertainty::least_frames;

// On a terminal each line begins with an empty one: programs upstream show their progress there.
void print(const std::string& text) {
    if (base::stdout_is_terminal()) base::write_stdout("\r\033[K", 4);
    base::write_stdout(text.data(), text.size());
    base::flush_stdout();
}

// Diffuse frames in a sum, else the number of a single frame, else the place in the stream.
int64_t frame_number(const image::Header& header, long index) {
    return header.frames.value_or(header.frame.value_or(index));
}

// What one run prints: a table of metrics, a table of sources, or evalglare's lines.
class Printer {
public:
    explicit Printer(const Options& o)
        : o_(o),
          start_(std::chrono::steady_clock::now()),
          measured_(o),
          stopping_(o, measured_.columns()),
          against_(o.against) {
        const bool shown_intervals = o.ci || o.against != EarlierEdit::none;
        bool shown = shown_intervals, needs_steps = shown || !o.until.empty();
        for (const Column& c : measured_.columns()) {
            shown |= c.printed && c.printed_unbiased;
            needs_steps |= c.printed_unbiased && !c.of_filled;
        }
        const int64_t first_look = shown ? 0 : least_frames;
        if (shown || !o.until.empty())
            steps_ = std::make_unique<Steps>(measured_.analyzer(), measured_.columns(), first_look, needs_steps);
    }

    // Values of one picture, and the names they have.
    std::vector<double> values(image::Picture& p, const std::string& place) {
        measured_.require_pairs();
        require_measurable(p, place);
        const Measurement m = measured_.analyzer().measure(p, place, o_.view);
        std::vector<double> out;
        for (const Column& c : measured_.columns())
            out.push_back(c.printed_unbiased && !c.of_filled ? std::nan("") : c.value(m));
        return out;
    }
    std::vector<std::string> value_names() const {
        std::vector<std::string> out;
        for (const Column& c : measured_.columns()) out.push_back(c.name);
        return out;
    }

    // True: stop here.
    bool picture(image::Picture& p, const std::string& place, const std::string& file, long index) {
        if (p.header.edited == "preview") return false;
        require_measurable(p, place);
        const int64_t frame = frame_number(p.header, index);
        const std::string edit = p.header.edit && o_.go_on ? fmt::format("edit {}", *p.header.edit) : "";
        if (stopping_.passes_over(edit.empty() ? image::label(p.header) : edit, frame)) return false;
        if (p.header.edit) follow_edits(*p.header.edit);
        else measured_.require_pairs();
        image::Picture whole;  // measuring uses up the picture's pixels
        if (!o_.over_file.empty()) whole = p;
        Luminance lum;
        Measurement m;
        try {
            lum = measured_.analyzer().read(p, place, o_.view);
            if (steps_) steps_->add(p, lum, place);
            m = measured_.analyzer().measure(lum, place);
        } catch (const base::Error& refusal) {
            const std::string text = o_.mode == OutputMode::evalglare ? evalglare::stdout_text(refusal) : "";
            if (!text.empty()) print(text);
            throw;
        }
        if (!o_.check_file.empty()) write_check_picture(p, lum, m);
        const bool looked = steps_ && steps_->look(lum, m);
        if (looked && o_.against != EarlierEdit::none)
            against_.look(steps_->estimates().replicates(), measured_.keys(), steps_->estimates().quantities());
        if (o_.mode == OutputMode::evalglare) {
            print(evalglare::lines(m, o_.evalglare, measured_.analyzer()));
            return false;
        }
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
        const Stopping::Line line{frame,
                                  seconds,
                                  looked ? &steps_->estimates() : nullptr,
                                  bool(lum.moments),
                                  lum.width,
                                  lum.height,
                                  p.header.last_frame == frame};
        stopping_.look(line);
        print_picture(p.header, m, file, line);
        if (!o_.over_file.empty()) draw_measured(o_, whole, measured_, m);
        return !o_.list_sources && stopping_.after(line);
    }
    void end_input(const std::string& place) {
        if (steps_) steps_->end_input(place);
    }
    int status() const { return stopping_.status(); }
    void at_end() const { stopping_.at_end(); }

private:
    // A picture of a stream whose scene or view, or region file, changes meanwhile.
    void follow_edits(int64_t edit) {
        against_.begin(edit);
        measured_.go_live();
        const auto accept = [&](const std::vector<Column>& columns) { Stopping(o_, columns); };
        if (!measured_.read_regions_again(accept)) return;
        stopping_.find_columns();
        if (steps_) steps_->columns_changed();
    }
    // Names stand before the first line, and again where the columns have changed.
    void print_picture(const image::Header& header, const Measurement& m, const std::string& file,
                       const Stopping::Line& line) {
        if (names_.empty()) named_ = named_pictures(header);
        std::vector<std::string> names = start_names(o_, named_);
        const std::vector<std::string> more = o_.list_sources ? source_names(o_) : row_names(o_, measured_.columns());
        names.insert(names.end(), more.begin(), more.end());
        if (names != names_) print(header_line(names, o_.format));
        names_ = names;
        std::string text;
        const auto add = [&](const std::vector<Cell>& numbers) {
            std::vector<Cell> cells = start_cells(o_, named_, header, file, line.frames, line.seconds);
            cells.insert(cells.end(), numbers.begin(), numbers.end());
            text += table_line(names_, cells, o_.format);
        };
        const ColumnEstimates* const estimates = steps_ ? &steps_->estimates() : nullptr;
        if (!o_.list_sources)
            add(row_cells(o_, measured_.columns(), {m, line.frames, estimates, against_, stopping_.held()}));
        else
            for (const std::vector<Cell>& source : source_rows(o_, m, measured_.analyzer().geometry())) add(source);
        print(text);
    }
    void write_check_picture(const image::Picture& measured, const Luminance& lum, const Measurement& m) {
        image::Picture check;
        check.width = measured.width;
        check.height = measured.height;
        check.rgb = evalglare::draw_check_picture(lum, m, measured_.analyzer().geometry(), o_.settings, o_.evalglare);
        check.header.lines = measured.header.lines;
        check.header.view = o_.view ? o_.view : measured.header.view;
        image::add_history(check.header, o_.command);
        display::write_file(o_.check_file, check, {});
    }

    const Options& o_;
    std::chrono::steady_clock::time_point start_;
    Measured measured_;
    Stopping stopping_;
    Against against_;
    std::unique_ptr<Steps> steps_;  // where intervals or values from batches are asked for
    NamedPictures named_;
    std::vector<std::string> names_;  // of the columns in the last line of names
};

}  // namespace

void require_measurable(const image::Picture& p, const std::string& place) {
    image::require_complete(p, place);
    if (p.header.tabbed_exposure)
        base::fail(
            place,
            "an EXPOSURE= line of the header holds a tab, as pcomb and pcompos leave it: the pixels' scale is unknown "
            "(remove the line, or divide the exposure out with pfilt -1 or ra_xyze -r -u)");
}

// evalglare knows neither PRIMARIES= nor COLORCORR=.
image::Pixels pixels_for(const Options& o) {
    return o.evalglare_bug_compatible ? image::Pixels::exposed : image::Pixels::radiance;
}

int measure_all(const Options& o) {
    const bool from_files = !o.files.empty();
    if (!from_files && base::stdin_is_terminal())
        base::say_on_terminal("vcmetrics: waits for pictures on the standard input; vcmetrics -help tells more");
    Printer printer(o);
    image::Picture picture;
    for (const std::string& file : from_files ? o.files : std::vector<std::string>{"-"}) {
        image::StreamReader reader(file, pixels_for(o));
        for (long index = 0; reader.next(picture); ++index) {
            base::finish_on_signal();  // from the first picture on: its line is finished
            const std::string place =
                (file == "-" ? "stdin" : file) + (index ? ": picture " + std::to_string(index + 1) : "");
            if (printer.picture(picture, place, file, index)) return printer.status();
            if (base::shutdown_requested()) return 0;
        }
        printer.end_input(file == "-" ? "stdin" : file);
    }
    printer.at_end();
    if (o.mode == OutputMode::evalglare && o.evalglare.ev_only) return 1;  // as evalglare -V
    return printer.status();
}

report::NumberTable measure_table(const Options& options, const std::string& file,
                                  const std::vector<std::string>& metrics) {
    Options o = options;
    o.metrics = metrics;
    if (o.mode == OutputMode::evalglare) o.mode = OutputMode::vcmetrics;  // its rounding stays, the columns are ours
    Printer printer(o);
    NumberTable table{file, printer.value_names(), {"frame"}, {}, {}};
    image::StreamReader reader(file, pixels_for(o));
    image::Picture picture;
    for (long index = 0; reader.next(picture); ++index) {
        const std::string place =
            (file == "-" ? "stdin" : file) + (index ? ": picture " + std::to_string(index + 1) : "");
        const std::vector<double> values = printer.values(picture, place);
        table.add_row(values, {std::to_string(frame_number(picture.header, index))});
    }
    return table;
}
