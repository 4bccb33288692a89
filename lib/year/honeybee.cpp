// SPDX-License-Identifier: BSD-3-Clause
// See honeybee.h.  Hours count from 0 at midnight of 1 January of a year without 29 February, by their middle.
#include "year/honeybee.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/error.h"
#include "image/stream.h"

namespace year {
namespace {

bool same_hours(const View& a, const View& b) {
    return std::equal(a.hours.begin(), a.hours.end(), b.hours.begin(), b.hours.end(),
                      [](const Hour& x, const Hour& y) { return x.time.minute_of_year() == y.time.minute_of_year(); });
}

}  // namespace

void write_honeybee(const std::string& folder, const std::vector<View>& views) {
    std::vector<size_t> lit;  // under any view
    const View& first = views.front();
    for (const View& v : views)
        if (!same_hours(first, v)) base::fail(v.name, "does not have the hours of " + first.name);
    std::string hours, rows;
    for (size_t i = 0; i < first.hours.size(); ++i) {
        const weather::Time& t = first.hours[i].time;
        const bool dark = std::all_of(views.begin(), views.end(), [&](const View& v) { return v.hours[i].dark; });
        if (dark || t.date.in_leap_year() == weather::leap_day) continue;
        lit.push_back(i);
        hours += fmt::format("{:g}\n", 24 * (t.date.of_year() - 1) + t.hour);
    }
    for (const View& v : views)
        for (const size_t i : lit) rows += fmt::format("{:.6g}{}", v.hours[i].dgp.value, i == lit.back() ? "\n" : "\t");
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure) base::fail(folder, "cannot be made: " + failure.message());
    image::write_bytes(folder + "/views.dgp", rows);
    image::write_bytes(folder + "/sun-up-hours.txt", hours);
    image::write_bytes(
        folder + "/grids_info.json",
        fmt::format("[{{\"name\": \"views\", \"identifier\": \"views\", \"full_id\": \"views\", \"count\": {}}}]\n",
                    views.size()));
}

}  // namespace year
