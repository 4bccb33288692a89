// SPDX-License-Identifier: BSD-3-Clause
// See skies.h.
#include "skies.h"

#include <fmt/core.h>

#include <filesystem>

#include "base/error.h"
#include "weather/choose.h"
#include "weather/clock.h"
#include "weather/sky.h"

Sky sky_of_file(const std::string& path) { return {std::filesystem::path(path).stem(), path, std::nullopt, false, {}}; }

// Noise differs from hour to hour, and no two runs of different -seed share any.
static uint64_t seed_of(const weather::Time& time, uint64_t seed) {
    return seed * 1000000 + uint64_t(time.minute_of_year());
}

// A warning where the file's own irradiances speak for another place of the sun.
static void check_clock(const weather::Weather& w) {
    if (const auto e = weather::clock_error(w))
        base::warn(w.path, fmt::format("direct normal times sine of the sun's altitude, plus diffuse, is {:.1f} % off "
                                       "the file's global irradiance (median), and {:.1f} % where the sun is moved by "
                                       "{:+g} h: is the file's clock wrong?  -wea-shift {:g} moves it",
                                       100 * e->as_placed, 100 * e->shifted, e->shift_h - w.shift_h, e->shift_h));
}

HourSkies skies_of_hours(const std::string& weather_file, const std::string& hours, const HourOptions& options,
                         uint64_t seed) {
    weather::Weather w = weather::read_weather(weather_file);
    w.shift_h = options.shift_h;
    check_clock(w);
    const weather::Choice choice = weather::choose_hours(w, hours, options.used_from);
    HourSkies all;
    size_t dark = 0;
    for (const size_t i : choice.hours) {
        const weather::Hour& h = w.hours[i];
        const weather::Sun sun = weather::sun_of(w, h);
        Sky sky{weather::name_of(h.time), "", seed_of(h.time, seed), weather::is_dark(w, h), {}};
        if (!sky.dark) sky.file = weather::sky_text(w, h);
        dark += sky.dark;
        const int minute = h.time.minute_of_year() % 1440;
        sky.lines = {fmt::format("TIME= {} {:02}:{:02} UTC{:+g}", weather::day_text(h.time.date), minute / 60,
                                 minute % 60, -w.meridian_deg / 15 + 0.),
                     fmt::format("SUN= {:.2f} {:.2f}", sun.altitude_deg, sun.azimuth_deg),
                     fmt::format("IRRADIANCE= {:g} {:g}", h.direct_wm2, h.diffuse_wm2)};
        all.skies.push_back(std::move(sky));
    }
    all.note = fmt::format("{}: hours: {} of {}, {} dark; {}", weather_file, choice.hours.size(), choice.whole, dark,
                           choice.note);
    return all;
}
