// SPDX-License-Identifier: BSD-3-Clause
// Reads both inputs, records or pictures, and prints a line for each metric (difference_inputs.h).
#include "difference_inputs.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "base/edit_distance.h"
#include "base/error.h"
#include "base/file_status.h"
#include "base/run.h"
#include "base/split.h"
#include "base/text_file.h"
#include "image/header.h"
#include "image/stream.h"
#include "measure_stream.h"
#include "report/compare.h"
#include "report/table.h"
#include "run.h"
#include "uncertainty/difference.h"

namespace {
using namespace glare;
using namespace report;

// Values without bias where it is known.
struct Side {
    NumberTable table;
    std::vector<Column> columns;                                     // empty: a record's
    std::vector<std::optional<uncertainty::Replicates>> replicates;  // of the rows of sums
};

// Rules as typed, or the lines of a file (# begins a comment).
std::vector<Tolerance> rules_of(const std::string& text) {
    if (text == "default") return {};
    if (base::status_of(text).kind == base::FileKind::none) return parse_tolerances(text, "-tolerance");
    std::istringstream in(base::read_text_file(text));
    std::vector<Tolerance> out;
    int number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        line = line.substr(0, line.find('#'));
        if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
        for (const Tolerance& t : parse_tolerances(line, text + ":" + std::to_string(number))) out.push_back(t);
    }
    return out;
}

// A typing error shall not pass as a wide tolerance; metrics that other -metrics would compare are none.
void require_known(const std::vector<Tolerance>& rules, const NumberTable& compared) {
    std::vector<std::string> names = base::split_words(glare::column_names());
    names.insert(names.end(), compared.names.begin(), compared.names.end());
    names.push_back("all");
    for (const Tolerance& rule : rules)
        if (std::find(names.begin(), names.end(), rule.metric) == names.end())
            base::fail("-tolerance",
                       "there is no metric \"" + rule.metric + "\" here" + base::question(rule.metric, names));
}

bool begins(const image::Header& before, const image::Header& next) {
    return image::label(next) != image::label(before) || !next.frames || !before.frames ||
           *next.frames <= *before.frames;
}

// What is measured in each picture of both sides: ordinary ones, or those of one action.
struct Compared {
    std::string illuminance;  // of the action; empty: ordinary pictures
    SharedPlan measured;
    std::vector<Column> columns;
};
Compared compared_in(const RunPlan& plan) {
    const ActionPlan& of = plan.actions;
    if (of.empty()) return {"", plan.measured, plan.columns};
    const auto is_printed = [](const Column& c) { return c.printed; };
    const std::vector<Column> ordinary = ordinary_columns(plan);
    if (of.kinds.size() > 1 || of.has_ratio() || std::any_of(ordinary.begin(), ordinary.end(), is_printed))
        base::fail("-difference", "compares pictures of one action, or ordinary ones: -metrics names columns of these");
    Compared out{of.kinds[0].name, of.kinds[0].measured, {}};
    for (const ActionPlan::Cell& cell : of.cells) {
        out.columns.push_back(of.kinds[0].columns[cell.place]);
        out.columns.back().name = cell.column.name;
    }
    return out;
}

// Rows are the last sum of each picture, or every one.
Side measured(const Options& o, const std::string& file, bool every) {
    const std::string place = place_of(file, 0).text;
    const RunPlan plan = plan_run(o);
    const Compared compared = compared_in(plan);
    Side out{{place, {}, {every ? "frame" : "picture"}, {}, {}, {}}, compared.columns, {}};
    for (const Column& c : compared.columns) out.table.names.push_back(c.name);
    Reading reading;
    Sum sum;
    image::Picture last;  // which `reading` is of
    long index = 0;
    const auto finish = [&] {
        const Measurement m = measure(reading);
        sum.ends = true;
        if (!every) sum = look(std::move(sum), reading, m, compared.columns, 0);
        std::vector<double> values;
        for (const Column& c : compared.columns) {
            const double unbiased = sum.looked ? sum.look.estimate(values.size()).value : std::nan("");
            const bool unknown = every && c.printed_unbiased && !c.of_filled;
            values.push_back(std::isnan(unbiased) && !unknown ? c.value(m) : unbiased);
        }
        const auto frame = [&] { return std::to_string(frame_number(last.header, place_of(file, index - 1))); };
        out.table.add_row(values, {every ? frame() : image::label(last.header)});
        out.replicates.emplace_back();
        if (sum.looked) out.replicates.back() = sum.look.replicates;
    };
    image::StreamReader reader(file, pixels_for(o));
    for (image::Picture next; reader.next(next); last = std::move(next), ++index) {
        require_pairs(plan);
        require_measurable(next, place_of(file, index).text);
        require_pictures_of(compared.illuminance, next.header, place_of(file, index).text);
        if (index && (every || begins(last.header, next.header))) finish();
        reading = read(compared.measured, next, place, o.view, std::move(reading));
        if (!every) sum = add(std::move(sum), next, reading, place, true);
    }
    if (index) finish();
    end_input(std::move(sum), place, !every);
    return out;
}

// Both with the same metrics: those of -metrics, or else of a record, or else all that have a tolerance.
std::pair<Side, Side> both_sides(Options o) {
    std::optional<NumberTable> records[2] = {read_numbers(o.files[0]), read_numbers(o.files[1])};
    const bool every = o.tolerances || records[0] || records[1], chosen = !o.metrics.empty();
    if (o.mode == OutputMode::evalglare) o.mode = OutputMode::vcmetrics;  // its rounding stays, the columns are ours
    for (const auto& record : records)
        if (record && !chosen) o.metrics = record->names;
    if (every && o.metrics.empty()) {
        o.metrics = compared_columns();
        if (!o.regions_file.empty()) o.metrics.push_back("TAL");
        if (!o.contrast_pairs.empty()) o.metrics.push_back("CR");
    }
    Side sides[2];
    for (int k = 0; k < 2; ++k)
        if (!records[k]) sides[k] = measured(o, o.files[size_t(k)], every);
        else sides[k].table = chosen ? only(*records[k], o.metrics, "-metrics") : *records[k];
    NumberTable &first = sides[0].table, &second = sides[1].table;
    only(first, second.names, second.name);
    second = only(second, first.names, first.name);
    return {std::move(sides[0]), std::move(sides[1])};
}

// Of these rows; differences that have no interval are those of the values.
std::vector<uncertainty::Estimate> differences(const Side& a, size_t row, const Side& b, size_t partner) {
    if (row < a.replicates.size() && partner < b.replicates.size() && a.replicates[row] && b.replicates[partner]) {
        const uncertainty::Replicates &first = *a.replicates[row], &second = *b.replicates[partner];
        if (!uncertainty::same_frames(first, second))
            base::warn(b.table.name, "its parts hold other frames or seeds than those of " + a.table.name +
                                         ": both errors count as independent");
        return uncertainty::difference(first, second, quantities_of(b.columns));
    }
    std::vector<uncertainty::Estimate> out;
    for (size_t k = 0; k < a.table.names.size(); ++k)
        out.push_back({b.table.rows[partner][k] - a.table.rows[row][k], std::nan(""), 0, 0, false, 0});
    return out;
}

// 1: the interval does not hold 0.
double told_apart(double low, double high) { return std::isnan(low + high) ? std::nan("") : low > 0 || high < 0; }

}  // namespace

int difference_inputs(const Options& o) {
    const std::vector<Tolerance> rules = rules_of(o.tolerances.value_or("default"));
    const auto [a, b] = both_sides(o);
    require_known(rules, a.table);
    std::vector<Line> lines;
    const std::vector<size_t> partner = pair_rows(a.table, b.table);
    bool all_within = true;
    for (size_t row = 0; row < partner.size(); ++row) {
        const std::vector<uncertainty::Estimate> d = differences(a, row, b, partner[row]);
        const std::string& label = a.table.row_names[row];
        for (size_t k = 0; k < d.size(); ++k) {
            if (k < a.columns.size() && a.columns[k].words) continue;
            const double first = a.table.rows[row][k], second = b.table.rows[partner[row]][k];
            Line line;
            add(line, "row", text_cell(label.empty() ? std::to_string(row + 1) : label));
            add(line, "metric", text_cell(a.table.names[k]));
            add(line, "first", first), add(line, "second", second), add(line, "difference", d[k].value);
            if (o.tolerances) {
                const Tolerance t = tolerance_for(a.table.names[k], rules);
                const bool is_within = within(t, first, second);
                add(line, "tolerance", text_cell(t.text())), add(line, "within", text_cell(is_within ? "yes" : "no"));
                all_within = all_within && is_within;
            } else {
                const uncertainty::Interval off = d[k].around(1 - o.ci.value_or(.95), d[k].frames);
                const double low = d[k].value + off.low, high = d[k].value + off.high;
                add(line, "lo", low), add(line, "hi", high), add(line, "apart", told_apart(low, high));
                add(line, "se", d[k].error_known_after(d[k].frames)), add(line, "df", d[k].degrees);
            }
            lines.push_back(std::move(line));
        }
    }
    const std::string text = table(lines, o.format);
    base::write_stdout(text.data(), text.size());
    return all_within ? 0 : 5;
}
