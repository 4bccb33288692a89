// SPDX-License-Identifier: BSD-3-Clause
// See table.h.
#include "year/table.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.h"
#include "uncertainty/student.h"
#include "year/table_row.h"
#include "year/wanted.h"

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
    std::vector<std::pair<std::string, GridHours>> grids, edi;
    std::map<std::string, Wanted> wanted;  // by view or grid
};

// By the states of shades.
struct States {
    std::vector<std::pair<std::string, Reading>> readings;
    size_t bytes = 0;  // of sensors
};

size_t bytes_of(const GridHour& h) {
    return h.sensors.size() * sizeof(Lux) + h.halves.size() * sizeof(uncertainty::HalfCodes);
}

void add_to(Wanted& wanted, const Columns& c, const report::NumberRow& row, const weather::Time& time,
            const std::string& path) {
    wanted.add(time.minute_of_year(), c.hour ? row.notes[*c.hour] : "", path);
}

void add_sensor(const Columns& c, const report::NumberRow& row, const std::string& path, Reading& of, States& all) {
    constexpr size_t most_bytes = size_t(1) << 31;
    const std::vector<std::string>& labels = row.labels;
    const weather::Time time = time_of(labels[*c.sky], path);
    GridHour& hour = called(labels[*c.grid], of.grids)[time.minute_of_year()];
    const std::string& word = labels[*c.point];
    const size_t before = bytes_of(hour);
    if (word == "0") hour = {}, add_to(of.wanted[labels[*c.grid]], c, row, time, path);
    if (word != std::to_string(hour.sensors.size()))
        base::fail(path, labels[*c.grid] + " at " + labels[*c.sky] + ": point " + word + " where " +
                             std::to_string(hour.sensors.size()) + " comes next");
    hour.time = time;
    hour.paths = paths_of(c, row);
    add_sensor(c, row, path, hour);
    if (c.edi) {
        GridHour& light = called(labels[*c.grid], of.edi)[time.minute_of_year()];
        if (word == "0") light = {};
        light.time = time, light.paths = hour.paths;
        add_edi(c, row, path, light);
        all.bytes += sizeof(Lux) + sizeof(uncertainty::HalfCodes);
    }
    all.bytes += bytes_of(hour) - before;
    if (all.bytes > most_bytes)
        base::fail(path, "more than 2 GiB of sensors: 268,435,456 values, 89,478,485 with half-samples");
}

// The last line with a value counts; the ordinary pictures before those of the action have none.
void add_edi_of_view(const Columns& c, const report::NumberRow& row, const std::string& path, const weather::Time& time,
                     GridHours& hours) {
    GridHour light{time, {}};
    light.paths = paths_of(c, row);
    add_edi(c, row, path, light);
    GridHour& known = hours.try_emplace(time.minute_of_year(), light).first->second;
    if (!is_missing(light)) known = std::move(light);
}

void add_table(const std::string& path, States& all, Tables& tables) {
    std::optional<Columns> c;
    const auto add = [&](const report::NumberTable& t, const report::NumberRow& row) {
        if (!c) {
            c.emplace(t);
            tables.exact = tables.exact || !c->low;
            tables.no_errors = tables.no_errors || (c->low && !c->errors);
            tables.no_pixels = tables.no_pixels || (!c->grid && !c->pixels);
        }
        Reading& of = called(c->state ? row.labels[*c->state] : "", all.readings);
        if (c->grid) return add_sensor(*c, row, path, of, all);
        const Hour h = hour_of(*c, row, path);
        const std::string view = c->view ? row.labels[*c->view] : "";
        add_to(of.wanted[view], *c, row, h.time, path);
        if (c->edi) add_edi_of_view(*c, row, path, h.time, called(view, of.edi));
        // Of a year the pictures of an action come behind all ordinary ones, in rows of their own.
        if (c->edi && h.is_missing && !std::isnan(row.values[*c->edi])) return;
        Hour& known = called(view, of.views).try_emplace(h.time.minute_of_year(), h).first->second;
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

// What an hour with noise says of it.
struct Noise {
    weather::Time time;
    std::string paths;
    double strata;
};

// Have hours paths in common?  Then they are of one run, and all hours have half-samples: whatever errors they have in
// common with others shows in these alone.
bool share_paths(const std::vector<Noise>& hours) {
    const auto first = std::find_if(hours.begin(), hours.end(), [](const Noise& n) { return !n.paths.empty(); });
    if (first == hours.end()) return false;
    for (const Noise& n : hours) {
        require_half_samples(n.time, n.strata);
        if (!n.paths.empty() && n.paths != first->paths)
            base::fail(weather::name_of(n.time),
                       "and " + weather::name_of(first->time) +
                           " share their paths with hours of two runs: seeds, frames or hours "
                           "of them differ");
    }
    return true;
}

View view_of(const std::string& name, const Hours& hours) {
    View view{name, {}};
    bool is_known = false;
    std::vector<Noise> noise;
    for (const auto& [minute, h] : hours) {
        if (!std::isfinite(h.dgp.value)) base::fail(weather::name_of(h.time), "has no value");
        is_known = is_known || h.is_known || h.is_missing || h.dgp.value >= 1;
        if (h.dgp.error > 0) noise.push_back({h.time, h.paths, h.halves.strata});
        view.hours.push_back(h);
    }
    require_interval(view.hours.front().time, is_known);
    view.shared = share_paths(noise);
    return view;
}

Grid grid_of(const std::string& name, GridHours& hours) {
    Grid grid{name, {}};
    std::vector<Noise> noise;
    for (auto& [minute, h] : hours) {
        for (const Lux& e : h.sensors)
            if (!is_missing(h)) require_interval(h.time, e.error >= 0 && std::isfinite(e.value));
        if (!h.halves.empty()) h.halves.resize(h.sensors.size());
        const auto is_noisy = [](const Lux& e) { return e.error > 0; };
        if (std::any_of(h.sensors.begin(), h.sensors.end(), is_noisy)) noise.push_back({h.time, h.paths, h.strata});
        grid.hours.push_back(std::move(h));
        if (grid.hours.back().sensors.size() != grid.sensors())
            base::fail(name, weather::name_of(grid.hours.back().time) + " has other sensors than " +
                                 weather::name_of(grid.hours.front().time));
    }
    grid.shared = share_paths(noise);
    const auto fewer = [](const Noise& a, const Noise& b) { return a.strata < b.strata; };
    if (!noise.empty()) grid.strata = std::min_element(noise.begin(), noise.end(), fewer)->strata;
    return grid;
}

}  // namespace

double Hour::low() const { return dgp.at(-1, uncertainty::student_of_normal(normal_quantile, dgp.degrees)); }
double Hour::high() const { return dgp.at(1, uncertainty::student_of_normal(normal_quantile, dgp.degrees)); }

void require_half_samples(const weather::Time& time, double strata) {
    if (!(strata > 0))
        base::fail(weather::name_of(time),
                   "has no half-samples, but hours of this year share their paths (vcmetrics -halves)");
}

bool is_dark(const GridHour& h) {
    return std::all_of(h.sensors.begin(), h.sensors.end(), [](const Lux& e) { return e.value == 0; });
}

bool is_missing(const GridHour& h) {
    return std::all_of(h.sensors.begin(), h.sensors.end(), [](const Lux& e) { return std::isnan(e.value); });
}

std::vector<StateTables> read_states(const std::vector<std::string>& paths) {
    Tables kind;
    States read;
    for (const std::string& path : paths) add_table(path, read, kind);
    std::vector<StateTables> all;
    for (auto& [state, of] : read.readings) {
        Tables& tables = all.emplace_back(StateTables{state, kind}).tables;
        for (const auto& [name, hours] : of.views) tables.views.push_back(view_of(name, hours));
        for (auto& [name, hours] : of.grids) tables.grids.push_back(grid_of(name, hours));
        for (auto& [name, hours] : of.edi) tables.edi.push_back(grid_of(name, hours));
        for (View& view : tables.views) view.to_come = of.wanted[view.name].missing();
        for (Grid& grid : tables.grids) grid.to_come = of.wanted[grid.name].missing();
        if (!tables.grids.empty() && !tables.views.empty())
            base::fail(paths.front(), "views and sensors are counted apart");
    }
    return all;
}

Tables read_tables(const std::vector<std::string>& paths) {
    std::vector<StateTables> states = read_states(paths);
    if (states.size() > 1)
        base::fail(paths.front(), "has states \"" + states[0].state + "\" and \"" + states[1].state +
                                      "\": -shades says which hour has which, -state names one");
    return states.empty() ? Tables{} : std::move(states[0].tables);
}

}  // namespace year
