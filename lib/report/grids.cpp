// SPDX-License-Identifier: BSD-3-Clause
// See grids.h.
#include "report/grids.h"

#include <algorithm>
#include <limits>

#include "base/error.h"
#include "base/number.h"

namespace report {
namespace {

using uncertainty::Interval;
using uncertainty::NoisyValues;
using Kind = GridColumn::Kind;

// The number behind a word: p5, share300.
bool number_behind(const std::string& text, const std::string& word, double& number) {
    return text.compare(0, word.size(), word) == 0 && base::parse_real(text.substr(word.size()), number) && number >= 0;
}

bool set_kind(const std::string& text, GridColumn& c) {
    const std::pair<const char*, Kind> words[] = {{"mean", Kind::mean},     {"min", Kind::min}, {"max", Kind::max},
                                                  {"median", Kind::median}, {"U0", Kind::U0},   {"df", Kind::df},
                                                  {"each", Kind::each}};
    for (const auto& [word, kind] : words)
        if (text == word) return c.kind = kind, true;
    c.kind = Kind::share;
    if (number_behind(text, "share", c.argument)) return true;
    c.kind = Kind::percentile;
    if (!number_behind(text, "p", c.argument) || c.argument > 100) return false;
    c.argument /= 100;
    return true;
}

Interval ratio(Interval over, Interval under, double factor) {
    if (!(under.high > 0)) return {NAN, NAN};
    const double most = under.low > 0 ? over.high / under.low : std::numeric_limits<double>::infinity();
    return {factor * over.low / under.high, factor * most};
}

double greatest(const std::vector<double>& v) { return *std::max_element(v.begin(), v.end()); }
double least(const std::vector<double>& v) { return *std::min_element(v.begin(), v.end()); }

}  // namespace

bool may_be_of_grid(const std::string& name) {
    GridColumn any;
    return set_kind(name.substr(name.rfind('.') + 1), any);
}

std::vector<GridColumn> grid_columns(const std::vector<std::string>& names, const std::vector<image::Grid>& grids,
                                     const std::string& place) {
    std::vector<GridColumn> out;
    size_t outside = grids.size();
    for (size_t g = 0; g < grids.size(); ++g)
        if (grids[g].name == grid_outside) outside = g;
    for (const std::string& name : names) {
        const size_t dot = name.rfind('.');
        const std::string of = dot == std::string::npos ? "" : name.substr(0, dot), what = name.substr(dot + 1);
        const size_t before = out.size();
        for (size_t g = 0; g < grids.size(); ++g) {
            if (of.empty() ? g == outside : grids[g].name != of) continue;
            GridColumn c{grids[g].name + "." + what, g, Kind::mean, 0, outside};
            if (!set_kind(what, c) || (c.kind == Kind::each && place != "-until"))
                base::fail(place,
                           "\"" + name + "\" is not a number of a grid: mean, min, max, median, p5, U0, share300, df");
            if (c.kind == Kind::df && outside == grids.size())
                base::fail(place, "df needs a grid called outside: a sensor without obstructions under the same sky");
            out.push_back(c);
        }
        if (out.size() == before) base::fail(place, "\"" + name + "\": there is no grid \"" + of + "\"");
    }
    return out;
}

bool holds(const Tolerance& rule, const GridColumn& c, const std::vector<NoisyValues>& grids) {
    constexpr double alpha = .05;
    const NoisyValues& v = grids[c.grid];
    if (c.kind != Kind::each) {
        const GridNumber n = grid_number(c, grids, alpha);
        return n.limits.half_width() <= rule.of(n.value);
    }
    size_t narrow = 0;
    for (size_t i = 0; i < v.value.size(); ++i) narrow += point_limits(v, i, alpha).half_width() <= rule.of(v.value[i]);
    return 100 * narrow >= 95 * v.value.size();
}

GridNumber grid_number(const GridColumn& c, const std::vector<NoisyValues>& grids, double alpha) {
    const NoisyValues& v = grids[c.grid];
    const auto percentile_at = [&](double share) {
        const auto of = [share](std::vector<double> x) { return uncertainty::percentile(std::move(x), share); };
        const double value = of(v.value);
        return GridNumber{value, shifted_limits(v, alpha, value, std::min(share, 1 - share), of)};
    };
    const Interval mean = mean_limits(v, alpha);
    switch (c.kind) {
    case Kind::mean: return {v.mean.value, mean};
    case Kind::min: return {least(v.value), least_limits(v, alpha)};
    case Kind::max: return {greatest(v.value), greatest_limits(v, alpha)};
    case Kind::median: return percentile_at(.5);
    case Kind::percentile: return percentile_at(c.argument);
    case Kind::share: {
        const auto of = [&](const std::vector<double>& x) { return uncertainty::share_from(x, c.argument); };
        return {of(v.value), shifted_limits(v, alpha, c.argument, 0, of)};
    }
    case Kind::U0: {
        const Interval u = ratio(least_limits(v, alpha), mean, 1);
        return {least(v.value) / v.mean.value, {u.low, u.high > 1 ? 1 : u.high}};
    }
    case Kind::df:
    case Kind::each: break;
    }
    const NoisyValues& out = grids[c.outside];
    return {100 * v.mean.value / out.mean.value, ratio(mean, mean_limits(out, alpha), 100)};
}

}  // namespace report
