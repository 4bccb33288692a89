// SPDX-License-Identifier: BSD-3-Clause
// See table.h.
#include "year/table.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.h"
#include "uncertainty/student.h"
#include "year/table_row.h"

namespace year {
namespace {

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

void add_sensor(const Columns& c, const report::NumberRow& row, const std::string& path, Reading& all) {
    constexpr size_t most_values = size_t(1) << 28;  // 3 GiB
    const std::vector<std::string>& labels = row.labels;
    const weather::Time time = time_of(labels[*c.sky], path);
    GridHour& hour = called(labels[*c.grid], all.grids)[time.minute_of_year()];
    const std::string& word = labels[*c.point];
    if (word == "0") all.values -= hour.sensors.size(), hour.sensors.clear();
    if (word != std::to_string(hour.sensors.size()))
        base::fail(path, labels[*c.grid] + " at " + labels[*c.sky] + ": point " + word + " where " +
                             std::to_string(hour.sensors.size()) + " comes next");
    if (++all.values > most_values) base::fail(path, "more than 268,435,456 values of sensors");
    hour.time = time;
    hour.sensors.push_back(lux_of(c, row, path));
}

void add_table(const std::string& path, Reading& all, Tables& tables) {
    std::optional<Columns> c;
    const auto add = [&](const report::NumberTable& t, const report::NumberRow& row) {
        if (!c) {
            c.emplace(t);
            tables.exact = tables.exact || !c->low;
            tables.no_errors = tables.no_errors || (c->low && !c->errors);
            tables.no_pixels = tables.no_pixels || (!c->grid && !c->pixels);
        }
        if (c->grid) return add_sensor(*c, row, path, all);
        const Hour h = hour_of(*c, row, path);
        Hour& known = called(c->view ? row.labels[*c->view] : "", all.views)
                          .try_emplace(h.time.minute_of_year(), h)
                          .first->second;
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
        for (const Lux& e : h.sensors)
            if (!is_missing(h)) require_interval(h.time, e.error >= 0 && std::isfinite(e.value));
        grid.hours.push_back(std::move(h));
        if (grid.hours.back().sensors.size() != grid.sensors())
            base::fail(name, weather::name_of(grid.hours.back().time) + " has other sensors than " +
                                 weather::name_of(grid.hours.front().time));
    }
    return grid;
}

}  // namespace

double Hour::low() const { return dgp.at(-1, uncertainty::student_of_normal(normal_quantile, dgp.degrees)); }
double Hour::high() const { return dgp.at(1, uncertainty::student_of_normal(normal_quantile, dgp.degrees)); }

bool is_dark(const GridHour& h) {
    return std::all_of(h.sensors.begin(), h.sensors.end(), [](const Lux& e) { return e.value == 0; });
}

bool is_missing(const GridHour& h) {
    return std::all_of(h.sensors.begin(), h.sensors.end(), [](const Lux& e) { return std::isnan(e.value); });
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
            is_known = is_known || h.is_known || h.is_missing || h.dgp.value >= 1;
            all.views.back().hours.push_back(h);
        }
        require_interval(all.views.back().hours.front().time, is_known);
    }
    for (auto& [name, hours] : read.grids) all.grids.push_back(grid_of(name, hours));
    if (!all.grids.empty() && !all.views.empty()) base::fail(paths.front(), "views and sensors are counted apart");
    return all;
}

}  // namespace year
