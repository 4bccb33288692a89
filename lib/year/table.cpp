// SPDX-License-Identifier: BSD-3-Clause
// See table.h.
#include "year/table.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.h"
#include "report/number_table.h"

namespace year {
namespace {

constexpr double normal_quantile = 1.959964;  // of 95 %

// The error of DGPf from pixels (docs/decisions/0038-a-year.md).  DGPf.px is what joined or parted sources change; the
// rest is some thousandths in round pictures of 64 x 64, half of it when the sides double, or a share of what filling
// the pixels adds.  Without DGPf.px it counts as all of that.
void add_error_of_pixels(Hour& h, double pixel_error, std::optional<double> joins) {
    const double at_64 = joins ? .0015 : .005, share = joins ? 1. / 3 : 1;
    h.dgp.bound = std::max(at_64 * std::sqrt(pixels_of_64 / h.pixels), share * std::fabs(pixel_error));
    h.dgp.jump = joins.value_or(0);
}

// Where a column stands; nothing if the table lacks it.
std::optional<size_t> column(const std::vector<std::string>& names, const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return std::nullopt;
    return size_t(found - names.begin());
}

// DGPf where it is there, else DGP; of sensors E, whose limits are called lo and hi.
struct Columns {
    std::optional<size_t> view, sky, frame, grid, point;  // among labels
    std::optional<size_t> value, low, high, pixel_error, joins, ev, pixels;

    explicit Columns(const report::NumberTable& t) {
        view = column(t.labels, "view"), sky = column(t.labels, "sky"), frame = column(t.labels, "frame");
        grid = column(t.labels, "grid"), point = column(t.labels, "point");
        const std::string name = grid ? "E" : column(t.names, "DGPf") ? "DGPf" : "DGP", end = grid ? "" : name + ".";
        value = column(t.names, name), low = column(t.names, end + "lo"), high = column(t.names, end + "hi");
        pixel_error = column(t.names, "DGP.px"), joins = column(t.names, "DGPf.px");
        ev = column(t.names, "Ev"), pixels = column(t.names, "pixels");
        if (!sky) base::fail(t.name, "has no column sky with the names of hours (ptrace -wea)");
        if (!value) base::fail(t.name, grid ? "has no column E" : "has no column DGPf or DGP");
        if (grid && !point) base::fail(t.name, "has no column point (vcmetrics -each without -points)");
        if (grid && (!low || !high)) base::fail(t.name, "has no columns lo and hi");
    }
};

weather::Time time_of(const std::string& name, const std::string& place) {
    const auto time = weather::parse_name(name);
    if (!time || time->hour < 0) base::fail(place, "\"" + name + "\" is not the name of an hour (0621_1430)");
    return *time;
}

// labels: of the row, in the order of the table's.
Hour hour_of(const Columns& c, const std::vector<double>& row, const std::vector<std::string>& labels,
             const std::string& place) {
    Hour h;
    h.time = time_of(labels[*c.sky], place);
    h.dgp.value = row[*c.value];
    h.dark = c.ev && row[*c.ev] == 0;
    if (c.frame) h.frames = std::atof(labels[*c.frame].c_str());
    if (c.pixels && row[*c.pixels] > 0) h.pixels = row[*c.pixels];
    h.least_pixels = h.pixels;
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
    const auto cell = [&](const std::optional<size_t>& at) { return at ? std::optional(row[*at]) : std::nullopt; };
    if (c.low) add_error_of_pixels(h, cell(c.pixel_error).value_or(0), cell(c.joins));
    return h;
}

// Does a line count in place of an earlier one of its hour?  An interval comes first: where the sun is in view few
// frames of a larger picture say less than many of a small one.
bool replaces(const Hour& h, const Hour& earlier) {
    if (h.is_known != earlier.is_known) return h.is_known;
    return h.pixels > earlier.pixels || (h.pixels == earlier.pixels && h.frames >= earlier.frames);
}

// The item called so, a new one if there is none.
template <class Item>
Item& called(const std::string& name, std::vector<std::pair<std::string, Item>>& items) {
    const auto found = std::find_if(items.begin(), items.end(), [&](const auto& i) { return i.first == name; });
    return found != items.end() ? found->second : items.emplace_back(name, Item{}).second;
}

// By minute of the year.
using Hours = std::map<int, Hour>;
using GridHours = std::map<int, GridHour>;

struct Reading {
    std::vector<std::pair<std::string, Hours>> views;
    std::vector<std::pair<std::string, GridHours>> grids;
    size_t values = 0;  // of sensors
};

void add_sensor(const Columns& c, const std::vector<double>& row, const std::vector<std::string>& labels,
                const std::string& path, Reading& all) {
    constexpr size_t most_values = size_t(1) << 28;  // 2 GiB
    const weather::Time time = time_of(labels[*c.sky], path);
    GridHour& hour = called(labels[*c.grid], all.grids)[time.minute_of_year()];
    const std::string& word = labels[*c.point];
    if (word == "0") all.values -= hour.sensors.size(), hour.sensors.clear();
    if (word != std::to_string(hour.sensors.size()))
        base::fail(path, labels[*c.grid] + " at " + labels[*c.sky] + ": point " + word + " where " +
                             std::to_string(hour.sensors.size()) + " comes next");
    if (++all.values > most_values) base::fail(path, "more than 268,435,456 values of sensors");
    hour.time = time;
    const double e = row[*c.value], half = (row[*c.high] - row[*c.low]) / 2;
    hour.sensors.push_back({float(e), e == 0 && std::isnan(half) ? 0 : float(half / normal_quantile)});
}

void add_table(const std::string& path, Reading& all, Tables& tables) {
    std::optional<Columns> c;
    const auto add = [&](const report::NumberTable& t, const std::vector<double>& row,
                         const std::vector<std::string>& labels) {
        if (!c) {
            c.emplace(t);
            tables.exact = tables.exact || !c->low;
            tables.no_pixels = tables.no_pixels || (!c->grid && !c->pixels);
        }
        if (c->grid) return add_sensor(*c, row, labels, path, all);
        const Hour h = hour_of(*c, row, labels, path);
        Hour& known =
            called(c->view ? labels[*c->view] : "", all.views).try_emplace(h.time.minute_of_year(), h).first->second;
        const double least = std::min(known.least_pixels, h.least_pixels);
        if (replaces(h, known)) known = h;
        known.least_pixels = least;
    };
    if (!report::each_row(path == "-" ? "/dev/stdin" : path, add)) base::fail(path, "is not a table of vcmetrics");
}

void require_interval(const weather::Time& time, bool has_one) {
    if (!has_one)
        base::fail(weather::name_of(time), "has no interval: it needs two frames or more, and vcmetrics -ci 95");
}

Grid grid_of(const std::string& name, GridHours& hours) {
    Grid grid{name, {}};
    for (auto& [minute, h] : hours) {
        for (const Lux& e : h.sensors) require_interval(h.time, e.error >= 0 && std::isfinite(e.value));
        grid.hours.push_back(std::move(h));
        if (grid.hours.back().sensors.size() != grid.sensors())
            base::fail(name, weather::name_of(grid.hours.back().time) + " has other sensors than " +
                                 weather::name_of(grid.hours.front().time));
    }
    return grid;
}

}  // namespace

double Hour::half_width() const { return normal_quantile * dgp.error; }

bool is_dark(const GridHour& h) {
    return std::all_of(h.sensors.begin(), h.sensors.end(), [](const Lux& e) { return e.value == 0; });
}

Tables read_tables(const std::vector<std::string>& paths) {
    Tables all;
    Reading read;
    for (const std::string& path : paths) add_table(path, read, all);
    for (auto& [name, hours] : read.views) {
        all.views.push_back({name, {}});
        bool is_known = false;
        for (const auto& [minute, h] : hours) {
            if (!std::isfinite(h.dgp.value)) base::fail(weather::name_of(h.time), "has no value");
            is_known = is_known || h.is_known;
            all.views.back().hours.push_back(h);
        }
        require_interval(all.views.back().hours.front().time, is_known);
    }
    for (auto& [name, hours] : read.grids) all.grids.push_back(grid_of(name, hours));
    if (!all.grids.empty() && !all.views.empty()) base::fail(paths.front(), "views and sensors are counted apart");
    return all;
}

}  // namespace year
