// SPDX-License-Identifier: BSD-3-Clause
// See next.h.
#include "year/next.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace year {
namespace {

constexpr double most_pixels = 9e5;   // of a picture: 1024 x 1024 in a circle
constexpr double dearest = 4;         // times the cheapest hour of a round: the others may not be needed after it
constexpr double before_frame_1 = 8;  // what frame 0 and the moments cost, in frames

// Noise falls with the frames and with the pixels, the error of pixels with the sides; a larger picture mostly knows
// which sources are joined.
uncertainty::Uncertain promised(const Hour& h, double frames, double larger) {
    uncertainty::Uncertain u = h.dgp;
    u.error *= std::sqrt((h.frames + 1) / frames) / larger;
    u.bound /= larger;
    if (larger > 1) u.jump = 0;
    return u;
}

// The cheapest way to decide the hour if its value stays; else a picture twice as large; nothing if it is the largest.
std::optional<Need> need_of(const Hour& h, double limit) {
    constexpr int most_larger = 4, most_times = 4;  // in one round: noise of few frames is itself not well known
    double frames = 8;                              // and frame 0
    while (frames < h.frames) frames *= 2;
    if (h.is_missing) return std::nullopt;
    if (!h.is_known) {
        frames = std::max(2 * frames, double(uncertainty::least_frames));
        return Need{h, limit, frames + 1, 1, frames + 1 + before_frame_1, {h.dgp.value, 0, 0}};
    }
    std::optional<Need> best;
    Need last;
    for (int larger = 1; larger <= most_larger && larger * larger * h.pixels <= most_pixels; larger *= 2)
        for (int times = 1; times <= most_times; times *= 2) {
            Need n{h, limit, times * frames + 1, larger, 0, promised(h, times * frames + 1, larger)};
            n.price = (n.frames + before_frame_1) * larger * larger * h.pixels / pixels_of_64;
            if (times == 1 && larger <= 2) last = n;
            const double apart = std::max(n.promised.at(-1) - limit, limit - n.promised.at(1));
            if (apart > 3 * n.promised.error && (!best || n.price < best->price)) best = n;
        }
    if (!best && last.larger > 1) best = last;
    return best;
}

double least_pixels(const View& view) {
    double least = INFINITY;
    for (const Hour& h : view.hours) least = std::min(least, h.least_pixels);
    return least;
}

// Is the class of the view decided if the first n promises are kept?
bool decided(View view, const std::vector<Need>& needs, size_t n, double alpha) {
    for (size_t k = 0; k < n; ++k)
        for (Hour& h : view.hours)
            if (h.time.minute_of_year() == needs[k].hour.time.minute_of_year())
                h.dgp = needs[k].promised, h.states.clear();
    const Verdict v = judge(view, alpha);
    return v.best == v.worst;
}

}  // namespace

std::vector<Need> needs(const View& view, const Verdict& v, double alpha) {
    // Hours on the side on which DGPe5 seems to be make it sure; others can only change it.
    const auto helps = [&](const Need& n) { return (n.hour.dgp.value > n.limit) == (v.exceeded.value > n.limit); };
    std::vector<Need> all;
    for (const Hour& h : view.hours) {
        std::optional<Need> most;  // of the limits that it holds
        for (int k = v.best; k < v.worst; ++k)
            if (holds(h, limits[size_t(k)]))
                if (const auto n = need_of(h, limits[size_t(k)]); n && (!most || n->price > most->price)) most = n;
        if (most) all.push_back(*most);
    }
    std::stable_sort(all.begin(), all.end(),
                     [&](const Need& a, const Need& b) { return helps(a) != helps(b) ? helps(a) : a.price < b.price; });
    size_t too_few = 0, enough = all.size();
    while (enough > too_few + 1) {
        const size_t middle = (too_few + enough) / 2;
        (decided(view, all, middle, alpha) ? enough : too_few) = middle;
    }
    all.resize(enough);
    if (all.empty()) return all;
    const auto cheaper = [](const Need& a, const Need& b) { return a.price < b.price; };
    const double most = dearest * std::min_element(all.begin(), all.end(), cheaper)->price;
    all.erase(std::remove_if(all.begin(), all.end(), [&](const Need& n) { return n.price > most; }), all.end());
    return all;
}

std::string need_lines(const std::vector<View>& views, const std::vector<Verdict>& verdicts, double alpha) {
    std::string text = "hour\tframes\tlarger\tlimit\tview\n";
    for (size_t k = 0; k < views.size(); ++k) {
        const double least = least_pixels(views[k]);
        for (const Need& n : needs(views[k], verdicts[k], alpha))
            text += fmt::format("{}\t{:.0f}\t{:.0f}\t{:.2f}\t{}\n", name_of(n.hour.time), n.frames,
                                n.larger * std::round(std::sqrt(n.hour.pixels / least)), n.limit,
                                views[k].name.empty() ? "-" : views[k].name);
    }
    return text;
}

}  // namespace year
