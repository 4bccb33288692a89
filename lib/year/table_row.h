// SPDX-License-Identifier: BSD-3-Clause
// A row of vcmetrics' tables as an hour of a view, or as an hour's light at a sensor.
#pragma once
#include <optional>
#include <string>

#include "report/number_table.h"
#include "year/table.h"

namespace year {

// Where the columns stand.  DGPf where it is there, else DGP; of sensors E, whose limits are called lo and hi.
struct Columns {
    std::optional<size_t> view, sky, state, frame, grid, point;  // among labels
    std::optional<size_t> errors, paths, hour;                   // among notes
    std::optional<size_t> value, low, high, pixel_error, joins, ev, ev_low, pixels, edi, edi_low, edi_high;
    std::string name;  // of the value

    enum class Of { hours, one_sky };  // one sky: of sensors, whose rows need not say when
    // Throws Error (place: the table) where one is missing.
    explicit Columns(const report::NumberTable& table, Of what = Of::hours);
};

weather::Time time_of(const std::string& name, const std::string& place);
Hour hour_of(const Columns& columns, const report::NumberRow& row, const std::string& place);
std::string paths_of(const Columns& columns, const report::NumberRow& row);  // empty: the hour's own
// Of its mEDI; a value without an interval counts as missing.
void add_edi(const Columns& columns, const report::NumberRow& row, const std::string& place, GridHour& hour);
void add_sensor(const Columns& columns, const report::NumberRow& row, const std::string& place, GridHour& hour);

}  // namespace year
