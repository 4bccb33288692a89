// SPDX-License-Identifier: BSD-3-Clause
// See skies.h.
#include "skies.h"

#include <fmt/core.h>

#include <filesystem>

#include "base/error.h"
#include "render/hours.h"
#include "weather/choose.h"
#include "weather/clock.h"
#include "weather/sky.h"

Sky sky_of_file(const std::string& path) {
    return {std::filesystem::path(path).stem().string(), path, std::nullopt, false, "", {}};
}

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

// What the sky of an hour has other than its line of the file would make one think.
static void warn_of(const weather::Weather& w, const weather::Hour& h, const weather::Sun& sun,
                    const std::optional<weather::HourLight>& light) {
    const std::string place = w.place_of(h) + ": " + weather::name_of(h.time);
    if (light && (light->even_gradation || light->even_indicatrix))
        base::warn(place, "Perez' sky is not positive for this light: the part of it that is not is left out");
    if (sun.altitude_deg <= 0 && h.direct_wm2 > 0 && h.direct_wm2 < weather::most_wm2)
        base::warn(place, "has direct sunlight with the sun below the horizon: the hour counts as dark");
}

static render::HourSky hour_sky(const weather::Hour& hour, const weather::HourLight& light) {
    render::HourSky sky;
    sky.number = uint32_t(hour.time.minute_of_year());
    sky.sun = {light.to_sun[0], light.to_sun[1], light.to_sun[2]};
    sky.sun_radiance = light.sun_radiance;
    sky.level = light.level;
    sky.ground = light.ground;
    sky.horizon = light.horizon;
    sky.sky_irradiance = light.sky_irradiance;
    for (int i = 0; i < 5; i++) sky.shape[i] = light.perez[i];
    return sky;
}

// W/m2 on a horizontal plane, about, of all hours with light, so that it is the same for each choice of them.
static double mean_irradiance(const weather::Weather& w) {
    double sum = 0, count = 0;
    for (const weather::Hour& h : w.hours)
        if (h.diffuse_wm2 > 0 && h.diffuse_wm2 < weather::most_wm2) sum += h.diffuse_wm2 + h.direct_wm2 / 3, count++;
    return count > 0 ? sum / count : 100;
}

HourSkies skies_of_hours(const std::string& weather_file, const std::string& hours, const HourOptions& options,
                         uint64_t seed) {
    weather::Weather w = weather::read_weather(weather_file);
    w.shift_h = options.shift_h;
    const weather::Choice choice = weather::choose_hours(w, hours, options.used_from);
    if (weather::has_sun(choice.year)) w.year = choice.year;
    check_clock(w);
    HourSkies all;
    size_t dark = 0, unknown = 0;
    bool by_one_year = false;
    all.mean_sky = render::hours_sky_text(mean_irradiance(w) * .6);  // visible: 110 lm/W over 179
    for (const size_t i : choice.hours) {
        const weather::Hour& h = w.hours[i];
        const weather::Sun sun = weather::sun_of(w, h);
        std::optional<weather::HourLight> light;
        Sky sky{weather::name_of(h.time), "", seed_of(h.time, seed), false, "", {}};
        if (weather::lacks_values(w, h) && !choice.named.count(i)) {
            sky.unknown = fmt::format("no irradiance in line {} of the weather file", h.line);
            ++unknown;
        } else {
            light = weather::light_of(w, h);
            if (light) sky.file = weather::sky_text(w, h, *light);
            warn_of(w, h, sun, light);
            sky.dark = !light;
            dark += sky.dark;
        }
        by_one_year |= h.year == 0;
        const int minute = h.time.minute_of_year() % 1440;
        sky.lines = {fmt::format("TIME= {} {:02}:{:02} UTC{:+g}", weather::day_text(h.time.date), minute / 60,
                                 minute % 60, -w.meridian_deg / 15 + 0.),
                     fmt::format("SUN= {:.2f} {:.2f}", sun.altitude_deg, sun.azimuth_deg),
                     fmt::format("IRRADIANCE= {:g} {:g}", h.direct_wm2, h.diffuse_wm2)};
        sky.hour = {0, 0};
        if (!choice.by_name) sky.hour = {int64_t(choice.first + all.skies.size() + 1), int64_t(choice.whole)};
        if (light) sky.light = hour_sky(h, *light);
        if (light)
            sky.lines.push_back(fmt::format("ILLUMINANCE= {:.0f} {:.0f}",
                                            weather::white_efficacy * light->sun_irradiance,
                                            weather::white_efficacy * light->sky_irradiance));
        all.skies.push_back(std::move(sky));
    }
    all.note = fmt::format("{}: hours: {} of {}, {} dark{}; {}{}", weather_file, choice.hours.size(), choice.whole,
                           dark, unknown ? fmt::format(", {} without values", unknown) : "",
                           by_one_year ? fmt::format("the sun is that of {}; ", w.year) : "", choice.note);
    return all;
}
