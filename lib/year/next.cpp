// SPDX-License-Identifier: BSD-3-Clause
// See next.h.
#include "year/next.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace year {
namespace {

constexpr double most_times = 16;  // times as many frames: an hour that needs more counts as on the limit

Need need_of(const Hour& h, double limit) {
    if (!h.is_known) return {h, limit, std::max(2 * h.frames, double(uncertainty::least_frames)), 1};
    const double apart = std::fabs(h.dgp.value - limit), noise = h.half_width();
    Need n{h, limit, h.frames, 1};
    while (n.larger < 8 && h.dgp.bound / n.larger > std::max(apart - noise, apart / 2)) n.larger *= 2;
    const double room = std::max(apart - h.dgp.bound / n.larger, noise / std::sqrt(most_times));
    if (noise > room) n.frames = std::ceil((h.frames + 1) * std::pow(noise / room, 2));
    return n;
}

}  // namespace

std::vector<Need> needs(const View& view, const Verdict& v) {
    std::vector<Need> all;
    for (int k = v.best; k < v.worst; ++k)
        for (const Hour& h : view.hours)
            if (holds(h, limits[size_t(k)])) all.push_back(need_of(h, limits[size_t(k)]));
    std::stable_sort(all.begin(), all.end(), [](const Need& a, const Need& b) {
        return std::fabs(a.hour.dgp.value - a.limit) < std::fabs(b.hour.dgp.value - b.limit);
    });
    return all;
}

std::string need_lines(const std::vector<View>& views, const std::vector<Verdict>& verdicts) {
    std::string text = "hour\tframes\tlarger\tlimit\tview\n";
    for (size_t k = 0; k < views.size(); ++k)
        for (const Need& n : needs(views[k], verdicts[k]))
            text += fmt::format("{}\t{:.0f}\t{}\t{:.2f}\t{}\n", name_of(n.hour.time), n.frames, n.larger, n.limit,
                                views[k].name.empty() ? "-" : views[k].name);
    return text;
}

}  // namespace year
