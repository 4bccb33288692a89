// SPDX-License-Identifier: BSD-3-Clause
// See honeybee.h.  Hours count from 0 at midnight of 1 January of a year without 29 February, by their middle.
#include "year/honeybee.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/error.h"
#include "base/printable.h"
#include "image/stream.h"
#include "image/stream_parts.h"

namespace year {
namespace {

bool is_dark(const Hour& h) { return h.dark; }
bool is_missing(const Hour& h) { return h.is_missing; }

template <class Hours>
bool same_hours(const Hours& a, const Hours& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const auto& x, const auto& y) { return x.time.minute_of_year() == y.time.minute_of_year(); });
}

void make_folder(const std::string& folder) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure) base::fail(folder, "cannot be made: " + failure.message());
}

void write_info(const std::string& folder, const std::vector<std::pair<std::string, size_t>>& counts) {
    std::string text;
    for (const auto& [name, count] : counts) {
        if (name.empty() || name[0] == '.' || name.find('/') != std::string::npos)
            base::fail("-honeybee", "\"" + name + "\" cannot be the name of a file");
        const std::string word = base::quoted_json(name);
        text += fmt::format("{}{{\"name\": {}, \"identifier\": {}, \"full_id\": {}, \"count\": {}}}",
                            text.empty() ? "" : ", ", word, word, word, count);
    }
    make_folder(folder);
    image::write_bytes(folder + "/grids_info.json", "[" + text + "]\n");
}

// Writes the hours; which of them are columns: those that are not dark in all items.
template <class Item>
std::vector<size_t> write_hours(const std::string& folder, const std::vector<Item>& items) {
    std::vector<size_t> columns;
    std::string hours, schedule;
    for (size_t i = 0; i < 8760; ++i) schedule += "0\n";
    for (size_t i = 0; i < items[0].hours.size(); ++i) {
        const weather::Time& t = items[0].hours[i].time;
        if (t.date.in_leap_year() == weather::leap_day) continue;
        const auto missing = [i](const Item& item) { return is_missing(item.hours[i]); };
        if (std::any_of(items.begin(), items.end(), missing)) continue;
        const double of_year = 24 * (t.date.of_year() - 1) + t.hour;
        schedule[2 * size_t(of_year)] = '1';
        if (std::all_of(items.begin(), items.end(), [i](const Item& item) { return is_dark(item.hours[i]); })) continue;
        columns.push_back(i);
        hours += fmt::format("{:g}\n", of_year);
    }
    image::write_bytes(folder + "/sun-up-hours.txt", hours);
    image::write_bytes(folder + "/schedule.txt", schedule);
    return columns;
}

template <class Item>
void require_same_hours(const std::vector<Item>& items) {
    for (const Item& item : items)
        if (!same_hours(items[0].hours, item.hours))
            base::fail(item.name, "does not have the hours of " + items[0].name);
}

// A row a row, values apart by tabs.
template <class Value>
std::string text_rows(size_t rows, const std::vector<size_t>& columns, const Value& value) {
    std::string text;
    for (size_t row = 0; row < rows; ++row)
        for (const size_t i : columns)
            text += fmt::format("{:.6g}{}", value(row, i), i == columns.back() ? "\n" : "\t");
    return text;
}

// NumPy's format, version 1.0 (numpy.lib.format): a dictionary, filled up to a multiple of 64 bytes, then the values.
std::string npy(const Grid& grid, const std::vector<size_t>& columns) {
    std::string head = fmt::format("{{'descr': '{}f4', 'fortran_order': False, 'shape': ({}, {}), }}",
                                   image::host_is_big_endian() ? '>' : '<', grid.sensors(), columns.size());
    constexpr size_t before = 10, multiple = 64;  // bytes: what stands before the dictionary
    head.append(multiple - 1 - (before + head.size()) % multiple, ' ') += '\n';
    std::string bytes("\x93NUMPY\x01\x00", 8);
    bytes += {char(head.size() % 256), char(head.size() / 256)};
    bytes += head;
    for (size_t row = 0; row < grid.sensors(); ++row)
        for (const size_t i : columns)
            bytes.append(reinterpret_cast<const char*>(&grid.hours[i].sensors[row].value), sizeof(float));
    return bytes;
}

}  // namespace

void write_honeybee(const std::string& folder, const std::vector<View>& views) {
    require_same_hours(views);
    write_info(folder, {{"views", views.size()}});
    const std::vector<size_t> columns = write_hours(folder, views);
    const auto dgp = [&](size_t view, size_t i) { return views[view].hours[i].dgp.value; };
    image::write_bytes(folder + "/views.dgp", text_rows(views.size(), columns, dgp));
}

void write_honeybee(const std::string& folder, const std::vector<Grid>& grids, const std::vector<Grid>& direct) {
    require_same_hours(grids);
    std::vector<std::pair<std::string, size_t>> counts;
    for (const Grid& g : grids) counts.emplace_back(g.name, g.sensors());
    write_info(folder, counts);
    const std::vector<size_t> columns = write_hours(folder, grids);
    const std::string arrays = folder + "/__static_apertures__/default";
    for (const auto& [name, kind] : {std::pair("/total/", &grids), {"/direct/", &direct}}) {
        if (kind->empty()) continue;
        make_folder(arrays + name);
        for (size_t g = 0; g < grids.size(); ++g) {
            if (!same_hours((*kind)[g].hours, grids[0].hours))
                base::fail("-direct", "does not have the hours of the table");
            image::write_bytes(arrays + name + grids[g].name + ".npy", npy((*kind)[g], columns));
        }
    }
    for (const Grid& g : grids) {
        const auto lux = [&](size_t sensor, size_t i) { return g.hours[i].sensors[sensor].value; };
        image::write_bytes(folder + "/" + g.name + ".ill", text_rows(g.sensors(), columns, lux));
    }
}

}  // namespace year
