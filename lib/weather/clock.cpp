// SPDX-License-Identifier: BSD-3-Clause
// See clock.h.  By least squares over the hours
//     GHI - DHI - DNI S(0)  =  s DNI S'  +  a DNI S  +  b DHI,      S(t) = sin(altitude) of the hour, t hours later,
// in which s is a shift: what it adds in the morning it takes in the afternoon.  Instruments that read too much or too
// little (a, b) do so in both.  The standard error of s is over the days, whose hours go together.
#include "weather/clock.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/angle.h"
#include "weather/sky.h"

namespace weather {
namespace {

constexpr double per_hour = base::pi / 12;  // of the hour angle
constexpr size_t least_days = 15;           // with sun
constexpr double most_off_h = 4;

// The sine of the altitude is middle - swing cos(angle).
struct SunnyHour {
    int day;
    double global, direct, diffuse, middle, swing, angle;
    double sine(double later_h) const { return middle - swing * std::cos(angle + per_hour * later_h); }
    double slope(double later_h) const { return per_hour * swing * std::sin(angle + per_hour * later_h); }
    double off(double later_h) const { return global - diffuse - direct * sine(later_h); }
};

// Hours with sun all of whose light is there and which are far enough from sunrise and sunset.
std::vector<SunnyHour> sunny_hours(const Weather& w) {
    constexpr double least_wm2 = 20, most_wm2 = 1500, margin_h = 1;
    const auto is_there = [&](double wm2) { return wm2 >= 0 && wm2 <= most_wm2; };
    const double half_h = w.step_min / 120, latitude = w.latitude_deg * base::degree;
    std::vector<SunnyHour> all;
    for (const Hour& h : w.hours) {
        if (!is_there(h.global_wm2) || !is_there(h.direct_wm2) || !is_there(h.diffuse_wm2)) continue;
        if (h.direct_wm2 < least_wm2 || h.global_wm2 < least_wm2) continue;
        const generators::Sun sun = sun_at_middle(w, h);
        const SunnyHour s{h.time.date.in_leap_year(),
                          h.global_wm2,
                          h.direct_wm2,
                          h.diffuse_wm2,
                          std::sin(latitude) * std::sin(sun.declination),
                          std::cos(latitude) * std::cos(sun.declination),
                          sun.solar_time * per_hour};
        if (s.sine(-half_h - margin_h) > 0 && s.sine(half_h + margin_h) > 0) all.push_back(s);
    }
    return all;
}

struct Fit {
    double step_h = 0, error_h = INFINITY, direct = 0, diffuse = 0;  // s, its standard error, a, b
};

using Row = std::array<double, 4>;  // DNI S', DNI S, DHI and what is left

Row row_of(const SunnyHour& s, double at_h) {
    return {s.direct * s.slope(at_h), s.direct * s.sine(at_h), s.diffuse, s.off(at_h)};
}

// Takes from rows `k` on what they have of row k, in which sums are of products; false: there is nothing in it.
bool sweep(std::array<Row, 4>& sums, size_t k, Row& share) {
    if (!(sums[k][k] > 1e-9)) return false;
    for (size_t i = 0; i < 4; ++i) share[i] = sums[k][i] / sums[k][k];
    for (size_t i = 0; i < 4; ++i)
        for (size_t j = 0; j < 4; ++j)
            if (i != k && j != k) sums[i][j] -= share[i] * share[j] * sums[k][k];
    for (size_t i = 0; i < 4; ++i) sums[i][k] = sums[k][i] = 0;
    return true;
}

// One step of Gauss and Newton from a shift: instruments are taken out of all (Frisch and Waugh), then s is a slope.
Fit fit(const std::vector<SunnyHour>& hours, double at_h) {
    std::array<Row, 4> sums{};
    for (const SunnyHour& s : hours) {
        const Row r = row_of(s, at_h);
        for (size_t i = 0; i < 4; ++i)
            for (size_t j = 0; j < 4; ++j) sums[i][j] += r[i] * r[j];
    }
    Row of_direct{}, of_diffuse{};
    const bool has_direct = sweep(sums, 1, of_direct), has_diffuse = sweep(sums, 2, of_diffuse);
    Fit f;
    if (!has_direct || !(sums[0][0] > 1e-9)) return f;
    f.step_h = sums[0][3] / sums[0][0];
    f.diffuse = has_diffuse ? of_diffuse[3] : 0;
    f.direct = of_direct[3] - f.diffuse * of_direct[2];
    double squares = 0, of_day = 0;
    int day = 0;
    const auto close = [&] { squares += of_day * of_day, of_day = 0; };
    for (const SunnyHour& s : hours) {
        if (s.day != day) close(), day = s.day;
        Row r = row_of(s, at_h);
        const double direct = r[1], diffuse = r[2] - of_direct[2] * direct;
        for (size_t i : {0, 3}) r[i] -= of_direct[i] * direct + (has_diffuse ? of_diffuse[i] * diffuse : 0);
        of_day += r[0] * (r[3] - f.step_h * r[0]);
    }
    close();
    f.error_h = std::sqrt(squares) / sums[0][0];
    return f;
}

// Median share of what is left, instruments of `f` taken out.
double median_off(const std::vector<SunnyHour>& hours, const Fit& f, double at_h) {
    std::vector<double> shares;
    for (const SunnyHour& s : hours)
        shares.push_back(std::fabs(s.off(at_h) - f.direct * s.direct * s.sine(at_h) - f.diffuse * s.diffuse) /
                         s.global);
    const auto middle = shares.begin() + long(shares.size() / 2);
    std::nth_element(shares.begin(), middle, shares.end());
    return *middle;
}

size_t days_of(const std::vector<SunnyHour>& hours) {
    size_t days = 0;
    for (size_t i = 0; i < hours.size(); ++i) days += i == 0 || hours[i].day != hours[i - 1].day;
    return days;
}

}  // namespace

std::optional<ClockError> clock_error(const Weather& w) {
    const std::vector<SunnyHour> hours = sunny_hours(w);
    if (days_of(hours) < least_days) return std::nullopt;
    double shift = 0;
    for (int k = 0; k < 8; ++k) shift += std::clamp(fit(hours, shift).step_h, -1., 1.);
    const Fit best = fit(hours, shift);
    constexpr double about_a_quarter = .2, doubt = 4;  // standard errors
    if (!(std::fabs(shift) - doubt * best.error_h > about_a_quarter)) return std::nullopt;
    const ClockError e{std::round(20 * (w.shift_h + shift)) / 20, median_off(hours, best, 0),
                       median_off(hours, best, shift)};
    if (!(e.shifted < e.as_placed) || std::fabs(shift) > most_off_h) return std::nullopt;
    return e;
}

}  // namespace weather
