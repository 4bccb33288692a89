// SPDX-License-Identifier: BSD-3-Clause
// Measures the last sum of each picture of both inputs, and prints a line for each metric (difference_inputs.h).
#include "difference_inputs.h"

#include <cmath>

#include "base/error.h"
#include "base/run.h"
#include "image/header.h"
#include "image/stream.h"
#include "measure_stream.h"
#include "report/table.h"
#include "run.h"
#include "uncertainty/difference.h"

namespace {
using namespace glare;
using namespace report;

struct Total {
    std::string label;
    std::vector<double> values;  // without bias where it is known
    std::optional<uncertainty::Replicates> replicates;
};

struct Side {
    std::string file;
    std::vector<Column> columns;
    std::vector<Total> totals;
};

bool begins(const image::Header& before, const image::Header& next) {
    return image::label(next) != image::label(before) || !next.frames || !before.frames ||
           *next.frames <= *before.frames;
}

Total total_of(const image::Header& last, const std::vector<Column>& columns, const Sum& sum, const Measurement& m) {
    Total out{image::label(last), {}, {}};
    if (sum.looked) out.replicates = sum.look.replicates;
    for (size_t k = 0; k < columns.size(); ++k) {
        const double unbiased = sum.looked ? sum.look.estimate(k).value : std::nan("");
        out.values.push_back(std::isnan(unbiased) ? columns[k].value(m) : unbiased);
    }
    return out;
}

Side read_side(const Options& o, const std::string& file) {
    const std::string place = place_of(file, 0).text;
    const RunPlan plan = plan_run(o);
    Side out{place, plan.columns, {}};
    Reading reading;
    Sum sum;
    std::optional<image::Picture> last;
    const auto finish = [&] {
        const Measurement m = measure(reading);
        sum.ends = true;
        sum = look(std::move(sum), reading, m, plan.columns, 0);
        out.totals.push_back(total_of(last->header, plan.columns, sum, m));
    };
    image::StreamReader reader(file, pixels_for(o));
    for (image::Picture next; reader.next(next); last = std::move(next)) {
        require_measurable(next, place);
        if (last && begins(last->header, next.header)) finish();
        reading = read(plan.measured, next, place, o.view, std::move(reading));
        sum = add(std::move(sum), next, reading, place, true);
    }
    if (last) finish();
    end_input(std::move(sum), place, true);
    return out;
}

void require_pairs(const Side& a, const Side& b) {
    if (a.totals.size() != b.totals.size())
        base::fail(b.file, "has " + std::to_string(b.totals.size()) + " pictures, " + a.file + " has " +
                               std::to_string(a.totals.size()));
    for (size_t k = 0; k < a.totals.size(); ++k)
        if (a.totals[k].label != b.totals[k].label)
            base::fail(b.file, "its picture " + std::to_string(k + 1) + " is \"" + b.totals[k].label + "\", that of " +
                                   a.file + " \"" + a.totals[k].label + "\"");
}

// Differences that have no interval are those of the values.
std::vector<uncertainty::Estimate> differences(const Side& a, const Side& b, size_t picture) {
    const Total &first = a.totals[picture], &second = b.totals[picture];
    if (first.replicates && second.replicates) {
        if (!uncertainty::same_frames(*first.replicates, *second.replicates))
            base::warn(b.file, "its parts hold other frames or seeds than those of " + a.file +
                                   ": both errors count as independent");
        return uncertainty::difference(*first.replicates, *second.replicates, quantities_of(b.columns));
    }
    std::vector<uncertainty::Estimate> out;
    for (size_t k = 0; k < first.values.size(); ++k)
        out.push_back({second.values[k] - first.values[k], std::nan(""), 0, 0, false, 0});
    return out;
}

// 1: the interval does not hold 0.
double told_apart(double low, double high) { return std::isnan(low + high) ? std::nan("") : low > 0 || high < 0; }

}  // namespace

int difference_inputs(const Options& o) {
    const Side a = read_side(o, o.files[0]), b = read_side(o, o.files[1]);
    require_pairs(a, b);
    const std::vector<std::string> names = {"row", "metric", "first", "second", "difference",
                                            "lo",  "hi",     "apart", "se",     "df"};
    std::string text = header_line(names, o.format);
    for (size_t row = 0; row < a.totals.size(); ++row) {
        const std::vector<uncertainty::Estimate> d = differences(a, b, row);
        const std::string& label = a.totals[row].label;
        for (size_t k = 0; k < d.size(); ++k) {
            if (a.columns[k].words) continue;
            const uncertainty::Interval off = d[k].around(1 - o.ci.value_or(.95), d[k].frames);
            std::vector<Cell> cells = {text_cell(label.empty() ? std::to_string(row + 1) : label),
                                       text_cell(a.columns[k].name)};
            const double low = d[k].value + off.low, high = d[k].value + off.high;
            for (double v : {a.totals[row].values[k], b.totals[row].values[k], d[k].value, low, high,
                             told_apart(low, high), d[k].error_known_after(d[k].frames), d[k].degrees})
                cells.push_back(number_cell(v));
            text += table_line(names, cells, o.format);
        }
    }
    base::write_stdout(text.data(), text.size());
    return 0;
}
