// SPDX-License-Identifier: BSD-3-Clause
// See table_row.h.
#include "year/table_row.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "glare/formulas.h"
#include "report/errors.h"
#include "uncertainty/student.h"

namespace year {
namespace {

// The error of DGPf from pixels (docs/decisions/0038-a-year.md).  DGPf.px is what its known causes change; the rest is
// some thousandths in round pictures of 64 x 64, half of it when the sides double.  Without DGPf.px all that filling
// the pixels adds counts.
void add_error_of_pixels(Hour& h, double pixel_error, std::optional<double> joins) {
    const double at_64 = joins ? .0015 : .005, filling = joins ? 0 : std::fabs(pixel_error);
    h.dgp.bound = std::max(at_64 * std::sqrt(pixels_of_64 / h.pixels), filling);
    h.dgp.jump = joins.value_or(0);
}

// Where a column stands; nothing if the table lacks it.
std::optional<size_t> column(const std::vector<std::string>& names, const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return std::nullopt;
    return size_t(found - names.begin());
}

// What the row says of the error of a number; without that, what its limits say if they are of 95 %.
report::NumberError error_of(const Columns& c, const report::NumberRow& row, const std::string& name,
                             const std::string& place) {
    const bool of_edi = name == "mEDI";
    const std::optional<size_t>&low = of_edi ? c.edi_low : c.low, &high = of_edi ? c.edi_high : c.high;
    if (c.errors) {
        const report::NumberError unknown{NAN, uncertainty::Uncertain::infinite, {}};
        return report::error_of(name, row.notes[*c.errors], place).value_or(unknown);
    }
    if (!low || !high) return {0, uncertainty::Uncertain::infinite, {}};
    return {(row.values[*high] - row.values[*low]) / 2 / normal_quantile, uncertainty::Uncertain::infinite, {}};
}

// The DGP that an hour has by the lower limit of its illuminance alone; 0 where the correction of low light counts.
double least_dgp(const Columns& c, const report::NumberRow& row, const std::string& place) {
    if (!c.ev || !c.ev_low) return 0;
    double lux = row.values[*c.ev_low];
    if (c.errors) {
        const report::NumberError e = error_of(c, row, "Ev", place);
        lux = row.values[*c.ev] - uncertainty::student_of_normal(normal_quantile, e.degrees) * e.error;
    }
    return glare::least_dgp(lux);
}

}  // namespace

Columns::Columns(const report::NumberTable& t, Of what) {
    view = column(t.labels, "view"), sky = column(t.labels, "sky"), state = column(t.labels, "state"),
    frame = column(t.labels, "frame");
    grid = column(t.labels, "grid"), point = column(t.labels, "point");
    errors = column(t.notes, report::errors_column), paths = column(t.notes, report::paths_column);
    hour = column(t.notes, report::hour_column);
    name = grid ? "E" : column(t.names, "DGPf") ? "DGPf" : "DGP";
    const std::string end = grid ? "" : name + ".";
    value = column(t.names, name), low = column(t.names, end + "lo"), high = column(t.names, end + "hi");
    pixel_error = column(t.names, "DGP.px"), joins = column(t.names, "DGPf.px");
    ev = column(t.names, "Ev"), ev_low = column(t.names, "Ev.lo"), pixels = column(t.names, "pixels");
    edi = column(t.names, "mEDI"), edi_low = column(t.names, "mEDI.lo"), edi_high = column(t.names, "mEDI.hi");
    if (what == Of::one_sky && !grid) base::fail(t.name, "has no column grid (vcmetrics -each of points)");
    if (!sky && what == Of::hours) base::fail(t.name, "has no column sky with the names of hours (ptrace -wea)");
    if (!value) base::fail(t.name, grid ? "has no column E" : "has no column DGPf or DGP");
    if (grid && !point) base::fail(t.name, "has no column point (vcmetrics -each without -points)");
    if (grid && (!low || !high)) base::fail(t.name, "has no columns lo and hi");
}

weather::Time time_of(const std::string& name, const std::string& place) {
    const auto time = weather::parse_name(name);
    if (!time || time->hour < 0) base::fail(place, "\"" + name + "\" is not the name of an hour (0621_1430)");
    return *time;
}

Hour hour_of(const Columns& c, const report::NumberRow& row, const std::string& place) {
    const auto cell = [&](const std::optional<size_t>& at) {
        return at ? std::optional(row.values[*at]) : std::nullopt;
    };
    Hour h;
    h.time = time_of(row.labels[*c.sky], place);
    h.dgp.value = row.values[*c.value];
    h.dark = cell(c.ev) == 0;
    if (c.frame) h.frames = std::atof(row.labels[*c.frame].c_str());
    if (cell(c.pixels) > 0) h.pixels = *cell(c.pixels);
    h.least_pixels = h.pixels;
    h.paths = paths_of(c, row);
    h.is_missing = c.ev ? std::isnan(*cell(c.ev)) : std::isnan(h.dgp.value);
    if (h.is_missing) {
        h.is_known = false;
        h.dgp = {0, 0, 1};
        return h;
    }
    if (h.dark || !c.low || !c.high) return h;
    const report::NumberError e = error_of(c, row, c.name, place);
    const double middle = (*cell(c.low) + *cell(c.high)) / 2;
    h.is_known = std::isfinite(middle) && e.error >= 0;
    if (h.is_known) {
        h.dgp.value = middle, h.dgp.error = e.error, h.dgp.degrees = e.degrees, h.halves = e.halves;
        add_error_of_pixels(h, cell(c.pixel_error).value_or(0), cell(c.joins));
    } else {
        h.dgp.bound = 1;
    }
    h.dgp.least = least_dgp(c, row, place);
    h.dgp.most = 1;
    return h;
}

std::string paths_of(const Columns& c, const report::NumberRow& row) {
    return c.paths && row.notes[*c.paths] != "-" ? row.notes[*c.paths] : "";
}

namespace {

void add_light(double lux, const report::NumberError& error, GridHour& hour) {
    hour.sensors.push_back({float(lux), lux == 0 && std::isnan(error.error) ? 0 : float(error.error)});
    hour.degrees = error.degrees > 0 ? error.degrees : uncertainty::Uncertain::infinite;
    if (!(error.halves.strata > 0)) return;
    hour.halves.resize(hour.sensors.size());
    hour.halves.back() = error.halves.codes;
    hour.strata = error.halves.strata;
}

}  // namespace

void add_sensor(const Columns& c, const report::NumberRow& row, const std::string& place, GridHour& hour) {
    add_light(row.values[*c.value], error_of(c, row, c.name, place), hour);
}

void add_edi(const Columns& c, const report::NumberRow& row, const std::string& place, GridHour& hour) {
    const report::NumberError error = error_of(c, row, "mEDI", place);
    const double lux = row.values[*c.edi];
    add_light(lux == 0 || error.error >= 0 ? lux : std::nan(""), error, hour);
}

}  // namespace year
