// SPDX-License-Identifier: BSD-3-Clause
// See action.h.
#include "spectrum/action.h"

#include <fmt/core.h>

#include <filesystem>
#include <numeric>

#include "base/error.h"
#include "base/printable.h"
#include "spectrum/illuminants.h"
#include "spectrum/tables.h"

namespace spectrum {
namespace {

constexpr double most_lumens_per_watt = 683.002;

const struct Known {
    const char* name;
    const double* weight;
    double from_nm, to_nm;
    int bands;
} known[] = {
    {"mel", action_mel, 410, 580, 9}, {"rh", action_rh, 420, 590, 9}, {"sc", action_sc, 410, 520, 9},
    {"mc", action_mc, 460, 630, 9},   {"lc", action_lc, 450, 640, 9}, {"V", action_v, 460, 660, 12},
};

Spectrum times(Spectrum s, double by) {
    for (double& v : s) v *= by;
    return s;
}

double sum_of_v() { return std::accumulate(action_v, action_v + 401, 0.); }

// Where the action of daylight reaches this share of its whole.
double quantile(const Spectrum& weight, double share) {
    const Spectrum& light = d65();
    const double goal = share * dot(weight, light);
    double sum = 0;
    for (size_t i = 0; i < weight.size(); i++)
        if ((sum += weight[i] * light[i]) >= goal) return first_nm + double(i);
    return last_nm;
}

Action of_file(const std::string& path, const base::Opener& by) {
    // Their bands lie between the same quantiles as those of mel, on average.
    constexpr double below = .0115, above = .005;
    const Spectrum weight = read_spectrum(path, by);
    if (dot(weight, d65()) <= 0) base::fail(path, "an action of 0 everywhere");
    const double from = quantile(weight, below), to = std::max(from + 1, quantile(weight, 1 - above));
    return {std::filesystem::path(path).stem().string(), "W/m2", times(weight, 1 / (most_lumens_per_watt * sum_of_v())),
            from, to};
}

}  // namespace

const Action& by_v() {
    static const Action v = action_of("V");
    return v;
}

Action action_of(const std::string& word, const base::Opener& by) {
    for (const Known& k : known)
        if (word == k.name) {
            const Spectrum weight = of_table(k.weight, 1), v = of_table(action_v, 1);
            const double scale = dot(d65(), v) / dot(d65(), weight) / sum_of_v();
            return {k.name, "lx", times(weight, scale), k.from_nm, k.to_nm, k.bands};
        }
    if (!std::filesystem::exists(word))
        base::fail("-action",
                   fmt::format("\"{}\" is neither mel, rh, sc, mc, lc or V nor a file", base::excerpt(word)));
    return of_file(word, by);
}

double daylight_ratio(const Action& action, const Spectrum& light) {
    return dot(action.value, light) / dot(by_v().value, light);
}

}  // namespace spectrum
