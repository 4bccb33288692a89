// SPDX-License-Identifier: BSD-3-Clause
// See table.h.
#include "year/table.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.h"
#include "base/split.h"
#include "report/number_table.h"

namespace year {
namespace {

constexpr double normal_quantile = 1.959964;  // of 95 %

// The error of DGPf from pixels that DGP.px does not show: sources near the threshold, edges within a pixel.  About
// .005 in round pictures of 64 x 64, and half of it when the sides double.
double error_of_pixels(double pixels) {
    constexpr double at_64 = .005, pixels_of_64 = 3217;
    return at_64 * std::sqrt(pixels_of_64 / (pixels > 0 ? pixels : pixels_of_64));
}

// Where a column stands; nothing if the table lacks it.
std::optional<size_t> column(const std::vector<std::string>& names, const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return std::nullopt;
    return size_t(found - names.begin());
}

// DGPf where it is there, else DGP.
struct Columns {
    std::optional<size_t> view, sky, frame;  // among labels
    std::optional<size_t> value, low, high, pixel_error, ev, pixels;

    explicit Columns(const report::NumberTable& t) {
        view = column(t.labels, "view"), sky = column(t.labels, "sky"), frame = column(t.labels, "frame");
        const std::string dgp = column(t.names, "DGPf") ? "DGPf" : "DGP";
        value = column(t.names, dgp), low = column(t.names, dgp + ".lo"), high = column(t.names, dgp + ".hi");
        pixel_error = column(t.names, "DGP.px");
        ev = column(t.names, "Ev"), pixels = column(t.names, "pixels");
    }
};

// labels: of the row, in the order of the table's.
Hour hour_of(const Columns& c, const std::vector<double>& row, const std::vector<std::string>& labels,
             const std::string& place) {
    Hour h;
    const auto time = weather::parse_name(labels[*c.sky]);
    if (!time || time->hour < 0) base::fail(place, "\"" + labels[*c.sky] + "\" is not the name of an hour (0621_1430)");
    h.time = *time;
    h.dgp.value = row[*c.value];
    h.dark = c.ev && row[*c.ev] == 0;
    if (c.frame) h.frames = std::atof(labels[*c.frame].c_str());
    if (c.pixels) h.pixels = row[*c.pixels];
    if (h.dark) return h;
    if (c.low && c.high) {
        h.dgp.value = (row[*c.low] + row[*c.high]) / 2;
        h.dgp.error = (row[*c.high] - row[*c.low]) / 2 / normal_quantile;
    }
    if (!std::isfinite(h.dgp.value) || !(h.dgp.error >= 0)) {
        h.is_known = false;
        h.dgp = {row[*c.value], 0, 1};  // DGP is at most 1
        return h;
    }
    if (c.low) h.dgp.bound = std::max(error_of_pixels(h.pixels), c.pixel_error ? std::fabs(row[*c.pixel_error]) : 0);
    return h;
}

using Hours = std::map<int, Hour>;  // by minute of the year

void add_table(const std::string& path, std::vector<std::string>& names, std::vector<Hours>& hours, Tables& all) {
    const auto table = report::read_numbers(path == "-" ? "/dev/stdin" : path);
    if (!table) base::fail(path, "is not a table of vcmetrics");
    const Columns c(*table);
    if (!c.sky) base::fail(path, "has no column sky with the names of hours (ptrace -wea)");
    if (!c.value) base::fail(path, "has no column DGPf or DGP");
    all.exact = all.exact || !c.low;
    all.no_pixels = all.no_pixels || !c.pixels;
    for (size_t i = 0; i < table->rows.size(); ++i) {
        const std::vector<std::string> labels = base::split_words(table->row_names[i]);
        if (labels.size() != table->labels.size()) base::fail(path, "\"" + table->row_names[i] + "\" lacks a name");
        const Hour h = hour_of(c, table->rows[i], labels, path);
        const std::string view = c.view ? labels[*c.view] : "";
        const size_t k = size_t(std::find(names.begin(), names.end(), view) - names.begin());
        if (k == names.size()) names.push_back(view), hours.emplace_back();
        hours[k][h.time.minute_of_year()] = h;
    }
}

}  // namespace

double Hour::half_width() const { return normal_quantile * dgp.error; }

Tables read_tables(const std::vector<std::string>& paths) {
    Tables all;
    std::vector<std::string> names;
    std::vector<Hours> hours;
    for (const std::string& path : paths) add_table(path, names, hours, all);
    for (size_t k = 0; k < names.size(); ++k) {
        all.views.push_back({names[k], {}});
        bool is_known = false;
        for (const auto& [minute, h] : hours[k]) {
            if (!std::isfinite(h.dgp.value)) base::fail(weather::name_of(h.time), "has no value");
            is_known = is_known || h.is_known;
            all.views.back().hours.push_back(h);
        }
        if (!is_known)
            base::fail(weather::name_of(all.views.back().hours.front().time),
                       "has no interval: it needs two frames or more, and vcmetrics -ci 95");
    }
    return all;
}

}  // namespace year
