// SPDX-License-Identifier: BSD-3-Clause
// Pictures from files or stdin, one line each, until the rule holds or there are no more (measure_stream.h).
#include "measure_stream.h"
#include <algorithm>
#include <chrono>
#include "base/error.h"
#include "base/run.h"
#include "base/shutdown.h"
#include "certain.h"
#include "evalglare/output.h"
#include "evalglare/source_finder.h"
#include "glare/columns.h"
#include "display/file.h"
#include "image/header.h"
#include "image/stream.h"
#include "region/open.h"
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

// Diffuse frames in a sum, else the number of a single frame, else the place in the stream.
int64_t frame_number(const image::Header& header, long index) {
    return header.frames.value_or(header.frame.value_or(index));
}

// What pixels do to the metrics of a rule is measured, too.
std::vector<std::string> pixel_columns(const UntilRule& rule) {
    std::vector<std::string> out;
    for (const Tolerance& t : rule.tolerances()) out.push_back(pixels_column(t.metric));
    out.push_back(pixels_column(rule.class_of()));
    out.erase(std::remove(out.begin(), out.end(), ""), out.end());
    return out;
}

// What one run prints: a table of metrics, a table of sources, or evalglare's lines.
class Printer {
public:
    Printer(const Options& o, bool from_files)
        : o_(o), start_(std::chrono::steady_clock::now()), from_files_(from_files) {
        image::DrawRegions draw;
        if (!o.regions_file.empty()) regions_ = region::open(o.regions_file, draw, true);
        ColumnChoice choice;
        choice.names = o.metrics;
        choice.accelerad = o.mode == OutputMode::accelerad;
        if (regions_)
            for (const image::Mask& m : regions_->masks) choice.regions.push_back(m.name);
        if (!o.until.empty()) choice.hidden = pixel_columns(UntilRule(o.until));
        for (const std::string& p : o.contrast_pairs) choice.pairs.push_back(parse_pair(p, choice.regions));
        Requirements requirements;
        columns_ = choose_columns(choice, o.settings, requirements);
        stopping_ = std::make_unique<Stopping>(o, columns_);
        if (o.mode == OutputMode::evalglare)
            requirements = {true, false, o.evalglare.detailed || o.settings.mask_file, false};
        if (o.list_sources || !o.check_file.empty()) requirements.sources = true;
        if (o.evalglare_bug_compatible) requirements.filled = false;
        analyzer_ =
            std::make_unique<PictureAnalyzer>(o.settings, requirements, std::move(regions_), std::move(draw),
                                              o.evalglare_bug_compatible ? evalglare::methods(o.evalglare) : Methods{});
        bool shown = o.ci.has_value();
        bool watches_pixels = false, needs_steps = shown || !o.until.empty();
        for (const Column& c : columns_) {
            shown |= c.printed && c.printed_unbiased;
            needs_steps |= c.printed_unbiased && !c.of_filled;
            watches_pixels |= !c.printed;
        }
        const int64_t first_look = shown ? 0 : watches_pixels ? Stopping::least_frames_of_pixels : least_frames;
        if (shown || !o.until.empty()) steps_ = std::make_unique<Steps>(*analyzer_, columns_, first_look, needs_steps);
        if (o.mode == OutputMode::accelerad) names_ = {"Time", "Frame"};
        else names_ = from_files ? std::vector<std::string>{"file"} : std::vector<std::string>{"frame", "seconds"};
        if (o.list_sources)
            names_.insert(names_.end(), {"source", "pixels", "x", "y", "omega", "L", "P", "sigma", "xdir", "ydir",
                                         "zdir", "Edir", "zone", "DGPshare"});
        else add_column_names();
    }

    // Values of one picture, and the names they have.
    std::vector<double> values(image::Picture& p, const std::string& place) {
        require_measurable(p, place);
        const Measurement m = analyzer_->measure(p, place, o_.view);
        std::vector<double> out;
        for (const Column& c : columns_) out.push_back(c.printed_unbiased && !c.of_filled ? std::nan("") : c.value(m));
        return out;
    }
    std::vector<std::string> value_names() const {
        std::vector<std::string> out;
        for (const Column& c : columns_) out.push_back(c.name);
        return out;
    }

    // True: stop here.
    bool picture(image::Picture& p, const std::string& place, const std::string& file, long index) {
        require_measurable(p, place);
        const int64_t frame = frame_number(p.header, index);
        if (stopping_->passes_over(image::label(p.header), frame)) return false;
        Luminance lum;
        Measurement m;
        try {
            lum = analyzer_->read(p, place, o_.view);
            if (steps_) steps_->add(p, lum, place);
            m = analyzer_->measure(lum, place);
        } catch (const base::Error& refusal) {
            const std::string text = o_.mode == OutputMode::evalglare ? evalglare::stdout_text(refusal) : "";
            if (!text.empty()) print(text);
            throw;
        }
        if (!o_.check_file.empty()) write_check_picture(p, lum);
        const bool looked = steps_ && steps_->look(lum, m);
        if (o_.mode == OutputMode::evalglare) {
            print(evalglare::lines(m, o_.evalglare, *analyzer_));
            return false;
        }
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
        const Cell frame_cell = number_cell(double(frame), 15);
        const Cell seconds_cell = number_cell(from_files_ ? 0 : std::round(seconds * 1000) / 1000, 9);
        std::vector<Cell> cells = {frame_cell, seconds_cell};
        if (o_.mode == OutputMode::accelerad) cells = {seconds_cell, frame_cell};
        else if (from_files_) cells = {text_cell(file)};
        if (!header_printed_) {
            show_names(p.header, cells.size());
            print(header_line(names_, o_.format));
            header_printed_ = true;
        }
        if (shows_view_) cells.push_back(text_cell(p.header.view_name.empty() ? "-" : p.header.view_name));
        if (shows_sky_) cells.push_back(text_cell(p.header.sky_name.empty() ? "-" : p.header.sky_name));
        if (shows_edit_) cells.push_back(number_cell(double(p.header.edit.value_or(0))));
        if (o_.list_sources) {
            list_sources(m, cells);
            return false;
        }
        for (size_t k = 0; k < columns_.size(); ++k)
            if (columns_[k].printed) add_cells(k, printed_value(k, m), frame, cells);
        if (o_.ci) cells.push_back(text_cell(heavy_tailed()));
        print(table_line(names_, cells, o_.format));
        return stopping_->after({frame, seconds, looked ? &steps_->estimates() : nullptr, bool(lum.moments), lum.width,
                                 lum.height, p.header.last_frame == frame});
    }
    void end_input(const std::string& place) {
        if (steps_) steps_->end_input(place);
    }
    int status() const { return stopping_->status(); }
    void at_end() const { stopping_->at_end(); }

private:
    // Streams of several views, skies or edits name them (ptrace -views, -sky, -watch): columns of the table, from
    // this one on.
    void show_names(const image::Header& first, size_t column) {
        shows_view_ = !first.view_name.empty();
        shows_sky_ = !first.sky_name.empty();
        shows_edit_ = first.edit.has_value();
        const auto add = [&](bool shown, const char* name) {
            if (shown) names_.insert(names_.begin() + std::ptrdiff_t(column++), name);
        };
        add(shows_view_, "view");
        add(shows_sky_, "sky");
        add(shows_edit_, "edit");
    }
    bool has_interval(const Column& c) const { return o_.ci && !c.words; }
    void add_column_names() {
        for (const Column& c : columns_) {
            if (!c.printed) continue;
            names_.push_back(c.name);
            if (has_interval(c)) names_.insert(names_.end(), {c.name + ".lo", c.name + ".hi"});
        }
        if (o_.ci) names_.push_back("tails");
    }
    double printed_value(size_t k, const Measurement& m) const {
        const double unbiased = columns_[k].printed_unbiased ? steps_->estimates().estimate(k).value : std::nan("");
        const bool plain = !columns_[k].printed_unbiased || (columns_[k].of_filled && std::isnan(unbiased));
        return plain ? columns_[k].value(m) : unbiased;
    }
    // The interval lies around the value without bias, which the column itself may show or not.  Between looks that is
    // the last look's value with the interval it had; a value without bias is of the frame itself, and narrows as they
    // grow.
    void add_cells(size_t k, double value, int64_t frame, std::vector<Cell>& cells) const {
        const Column& c = columns_[k];
        if (c.words) {
            cells.push_back(text_cell(c.words[int(value)]));
        } else if (!o_.ci) {
            cells.push_back(number_cell(value));
        } else {
            const uncertainty::Estimate& e = steps_->estimates().estimate(k);
            const uncertainty::Interval off = e.around(1 - *o_.ci, c.has_bias() ? e.frames : frame);
            const double middle = c.has_bias() ? e.value : value;
            for (double v : {value, middle + off.low, middle + off.high}) cells.push_back(number_cell(v));
        }
    }
    std::string heavy_tailed() const {
        std::string out;
        for (size_t k = 0; k < columns_.size(); ++k)
            if (columns_[k].printed && steps_->estimates().estimate(k).unreliable)
                out += (out.empty() ? "" : " ") + columns_[k].name;
        return out.empty() ? "-" : out;
    }
    void write_check_picture(const image::Picture& measured, const Luminance& lum) {
        image::Picture check;
        check.width = measured.width;
        check.height = measured.height;
        check.rgb = evalglare::draw_check_picture(lum, *analyzer_, o_.evalglare);
        check.header.lines = measured.header.lines;
        check.header.view = o_.view ? o_.view : measured.header.view;
        image::add_history(check.header, o_.command);
        display::write_file(o_.check_file, check, {});
    }
    void list_sources(const Measurement& m, const std::vector<Cell>& start) {
        double sum = 0;
        for (const GlareSource& s : m.sources) sum += dgp_term({s.lum, s.omega, s.P, 0, 0, 0}, o_.settings.constants);
        std::string text;
        for (size_t k = 0; k < m.sources.size(); ++k) {
            const GlareSource& s = m.sources[k];
            std::vector<Cell> cells = start;
            const double share = dgp_term({s.lum, s.omega, s.P, 0, 0, 0}, o_.settings.constants) / sum;
            for (double v : {double(k + 1), s.pixels, s.x, s.y, s.omega, s.lum, s.P, s.sigma_deg, s.direction.x,
                             s.direction.y, s.direction.z, s.eye_lux, double(s.zone), share})
                cells.push_back(number_cell(v));
            text += table_line(names_, cells, o_.format);
        }
        print(text);
    }

    const Options& o_;
    std::chrono::steady_clock::time_point start_;
    bool from_files_, header_printed_ = false, shows_view_ = false, shows_sky_ = false, shows_edit_ = false;
    std::optional<image::MaskSet> regions_;
    std::unique_ptr<PictureAnalyzer> analyzer_;
    std::vector<Column> columns_;
    std::vector<std::string> names_;
    std::unique_ptr<Steps> steps_;  // where intervals or values from batches are asked for
    std::unique_ptr<Stopping> stopping_;
};

}  // namespace

int measure_all(const Options& o) {
    const bool from_files = !o.files.empty();
    if (!from_files && base::stdin_is_terminal())
        base::say_on_terminal("vcmetrics: waits for pictures on the standard input; vcmetrics -help tells more");
    Printer printer(o, from_files);
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
    Printer printer(o, true);
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
