// SPDX-License-Identifier: BSD-3-Clause
// See page.h.
#include "page.h"

#include <numeric>

#include "base/error.h"
#include "image/stream.h"

namespace {

// Tables of sensors; of several states of shades the most open one.
year::StateTables sensors_in(const std::vector<std::string>& files, const char* option) {
    year::StateTables of = year::read_states(files).front();
    if (of.tables.grids.empty()) base::fail(option, "is of sensors (vcmetrics -each), not of views");
    return of;
}

year::PageParts parts_of(const Options& o) {
    year::PageParts parts;
    if (!o.planes.empty()) {
        const year::DaylightHours daylight = year::daylight_hours(weather::read_weather(o.en17037));
        const year::StateTables of = sensors_in(o.planes, "-plane");
        for (const year::Grid& g : of.tables.grids)
            parts.planes.push_back(
                {g.name, of.state, year::judge_provision(g, daylight, o.rooflight, 1 - o.percent / 100)});
        parts.daylight_hours = o.en17037;
    }
    if (!o.openings.empty()) {
        const weather::Weather day = weather::read_weather(o.sun_steps);
        for (const year::Grid& g : sensors_in(o.openings, "-openings").tables.grids) {
            std::vector<size_t> points(g.sensors());
            std::iota(points.begin(), points.end(), size_t(0));
            parts.openings.push_back({g.name, year::judge_sunlight(g, points, day, o.lowest_deg)});
        }
    }
    if (!o.view_out.empty()) parts.view_out = year::read_view_out(o.view_out);
    return parts;
}

}  // namespace

year::Page page_of(const Options& o, const Counted& c, const std::vector<year::Verdict>& verdicts,
                   const std::vector<year::BodyClock>& clocks) {
    year::Page page;
    page.title = o.title, page.views = c.tables.views, page.verdicts = verdicts, page.clocks = clocks;
    page.parts = parts_of(o), page.shades = c.shades;
    page.certainty = o.percent / 100;
    page.command = o.command;
    for (const std::string& file : o.eyes)
        for (view::NamedView& eye : view::read_views(file, {})) page.eyes.push_back(std::move(eye));
    if (!o.plan.empty()) page.plan = image::read_file(o.plan);
    for (const std::string& file : o.pictures) page.pictures.push_back(image::read_file(file));
    if (!o.weather.empty()) page.weather = weather::read_weather(o.weather);
    page.files = o.tables;
    for (const auto& more : {o.closed, o.by, o.planes, o.openings, o.eyes, o.pictures})
        page.files.insert(page.files.end(), more.begin(), more.end());
    for (const std::string& file : {o.en17037, o.sun_steps, o.view_out})
        if (!file.empty()) page.files.push_back(file);
    page.version = std::string("luxpipe ") + LUXPIPE_VERSION;
    return page;
}
