// SPDX-License-Identifier: BSD-3-Clause
// See shade_looks.h.
#include "year/shade_looks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/number.h"
#include "uncertainty/shared_counts.h"
#include "uncertainty/student.h"
#include "weather/light.h"
#include "weather/sky.h"
#include "year/verdict.h"

namespace year {

ReadyRule ready(const ShadeRule& rule, const ShadeGroup& group, const ShadeSources& sources) {
    using Kind = ShadeRule::Kind;
    ReadyRule r{rule, group.states, {}, {}, {}};
    if (rule.kind == Kind::schedule) r.schedule = read_shade_schedule(rule.file, group.name);
    if (rule.kind == Kind::slats || rule.wm2 > 0) {
        r.weather = weather::read_weather(rule.file);
        for (size_t i = 0; i < r.weather.hours.size(); ++i) r.weather_at[r.weather.hours[i].time.minute_of_year()] = i;
        if (rule.kind == Kind::slats && rule.tilts.size() != group.states.size())
            base::fail(rule.text, fmt::format("{} tilts for {} states", rule.tilts.size(), group.states.size()));
    }
    if (rule.kind == Kind::glare && (!sources.glare || sources.glare->open().views.empty()))
        base::fail(rule.text, "reads a table of views: -by");
    if (rule.kind == Kind::sun && (!sources.direct || sources.direct->open().grids.empty()))
        base::fail(rule.text, "reads a table of sensors under direct sun: -direct");
    return r;
}

Kept glare_kept(const ReadyRule& r, double limit, const ShadeStates& views, const std::string& state,
                const weather::Time& time) {
    std::vector<std::string> names = r.rule.at;
    if (names.empty())
        for (const View& v : views.open().views) names.push_back(v.name);
    Kept kept;
    for (const std::string& name : names) {
        const Hour& h = views.hour(state, name, time.minute_of_year());
        const bool held = holds(h, limit), above = h.dgp.value > limit;
        kept.by_value = kept.by_value && !above;
        kept.surely = kept.surely && !above && !held;
        kept.perhaps = kept.perhaps && (!above || held);
    }
    return kept;
}

// Limits of how many sensors of an hour have so much light.
static uncertainty::Interval sensors_from(double lux, const Grid& grid, const GridHour& h) {
    constexpr double alpha = .05;
    std::vector<uncertainty::Shared> sensors;
    for (size_t i = 0; i < h.sensors.size(); ++i) {
        sensors.push_back({{double(h.sensors[i].value), double(h.sensors[i].error), 0, 0, h.degrees}, {}});
        if (!h.halves.empty()) sensors.back().off = uncertainty::off(h.halves[i]);
    }
    if (grid.strata > 0 && !h.halves.empty())
        return uncertainty::count_within(sensors, uncertainty::counts_within(sensors, lux, INFINITY), grid.strata, lux,
                                         INFINITY, alpha);
    uncertainty::Interval limits{0, 0};  // errors of sensors are alike, nobody knows how much
    const double t = uncertainty::student_of_normal(normal_quantile, h.degrees);
    for (const uncertainty::Shared& s : sensors)
        limits.low += s.of.at(-1, t) >= lux, limits.high += s.of.at(1, t) >= lux;
    return limits;
}

static const weather::Hour& hour_of(const ReadyRule& r, const weather::Time& time) {
    const auto at = r.weather_at.find(time.minute_of_year());
    if (at == r.weather_at.end()) base::fail(r.rule.file, "has no " + name_of(time));
    return r.weather.hours[at->second];
}

// Of direct sun, which no sensor reaches without a sun.
static double lux_of(const ReadyRule& r, const weather::Time& time) {
    if (!(r.rule.wm2 > 0)) return r.rule.lux;
    const weather::Hour& hour = hour_of(r, time);
    const auto light = weather::light_of(r.weather, hour);
    if (!light || !(light->sun_irradiance > 0)) return INFINITY;
    return r.rule.wm2 * weather::white_efficacy * light->sun_irradiance / hour.direct_wm2;
}

Kept sun_kept(const ReadyRule& r, const ShadeStates& direct, const std::string& state, const weather::Time& time) {
    const std::string known = direct.has(state) || !direct.has("") ? state : "";  // a run without states: the open one
    const double lux = lux_of(r, time);
    double low = 0, high = 0, value = 0, sensors = 0;
    bool missing = false;
    for (const Grid& grid : direct.open().grids) {
        const std::vector<std::string>& at = r.rule.at;
        if (!at.empty() && std::find(at.begin(), at.end(), grid.name) == at.end()) continue;
        const GridHour h = direct.hour_of_grid(known, grid.name, time.minute_of_year());
        sensors += double(h.sensors.size());
        if (missing = missing || is_missing(h); missing) continue;
        for (const Lux& e : h.sensors) value += e.value >= lux;
        const uncertainty::Interval limits = sensors_from(lux, grid, h);
        low += limits.low, high += limits.high;
    }
    if (sensors == 0) base::fail(r.rule.text, "-direct has none of these grids");
    const double most = r.rule.share * sensors + 1e-9;
    return {value <= most, !missing && high <= most, low <= most};
}

// WMO, Guide to Instruments and Methods of Observation (No. 8), chapter 8: direct normal irradiance of sunshine.
constexpr double sunshine_wm2 = 120;

Kept sun_kept_out(const ReadyRule& r, size_t state, const weather::Time& time) {
    const weather::Hour& hour = hour_of(r, time);
    if (hour.direct_wm2 < sunshine_wm2) return {};
    const weather::Sun sun = weather::sun_of(r.weather, hour);
    const auto profile = profile_angle_deg(sun.altitude_deg, sun.azimuth_deg, r.rule.slats.facade_deg);
    double tilt = 0;
    const bool has_slats = base::parse_real(r.rule.tilts[state], tilt),
               kept = !profile || (has_slats && keep_out(r.rule.slats, tilt, *profile));
    return {kept, kept, kept};
}

}  // namespace year
