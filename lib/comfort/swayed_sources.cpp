// SPDX-License-Identifier: BSD-3-Clause
// Bright stretches, their nodes (swayed_groups.h), sums by node and picture, sources (swayed_sources.h).
#include "comfort/swayed_sources.h"

#include <algorithm>
#include <cmath>

#include "base/wide.h"
#include "comfort/detect.h"
#include "comfort/luminance.h"
#include "comfort/swayed_groups.h"

namespace comfort {
namespace {

constexpr size_t lanes = Signs::most, most = lanes + 1;  // and the mean

double luminance(const float& grey) {
    Luminance one;
    one.grey = const_cast<float*>(&grey);
    return one.at(0);
}

struct Sum {
    double power = 0, x = 0, y = 0, eye = 0;  // of L w, that times x and y, and L w cos
};
struct Part {
    double pixels = 0, omega = 0;
    Sum own, mean;
    uint64_t first = UINT64_MAX;  // in column order
};
using Node = std::array<Part, most>;

// Of a row's pixels, starting in column x: what all pictures have in common, and what each has more (less y).
struct RowSums {
    double omega = 0, power[lanes] = {}, x[lanes] = {}, eye[lanes] = {};
    Sum middle, mean;
};

WIDE_LOOP void add_row(const Swayed& lum, const Geometry& g, size_t first, size_t length, int x, RowSums& to) {
    for (size_t p = first; p < first + length; ++p, ++x) {
        const double plus = luminance(lum.mean[p] + lum.off[p]), minus = luminance(lum.mean[p] - lum.off[p]);
        const double own = luminance(lum.mean[p]), middle = (plus + minus) / 2, w = g.omega[p], c = g.omega_cos[p];
        to.omega += w;
        to.mean.power += own * w, to.mean.x += own * w * x, to.mean.eye += own * c;
        to.middle.power += middle * w, to.middle.x += middle * w * x, to.middle.eye += middle * c;
        const double off = (plus - minus) / 2, power = off * w, at_x = power * x, eye = off * c;
        const double* factor = lum.signs->factor[lum.pattern[p]].data();
        for (size_t k = 0; k < lanes; ++k) to.power[k] += factor[k] * power;
        for (size_t k = 0; k < lanes; ++k) to.x[k] += factor[k] * at_x;
        for (size_t k = 0; k < lanes; ++k) to.eye[k] += factor[k] * eye;
    }
}

class AllSources {
public:
    AllSources(const Swayed& lum, const Swayed& bright, const std::vector<double>& thresholds, const Geometry& g,
               const Settings& settings, Connector& connector)
        : lum_(lum), bright_(bright), g_(g), settings_(settings), connector_(connector), pictures_(lum.count() + 1) {
        for (const double t : thresholds) limit_.push_back(grey_limit(t));
        all_ = (Shown(1) << pictures_) - 1;
        out_.resize(size_t(pictures_));
    }
    std::vector<SwayedSources> find() {
        std::vector<Stretch> stretches = bright_stretches();
        std::vector<Stretch> peaks;
        if (settings_.peaks && radius_in_pixels(g_, settings_.search_opening) >= 1) peaks = peak_stretches(stretches);
        const SwayedGroups groups(g_, connector_, stretches, pictures_);
        std::vector<Node> nodes(groups.nodes());
        for (const Stretch& s : stretches) find_first(s, nodes[s.node]);
        if (!peaks.empty()) stretches = without_peaks(stretches);
        for (const Stretch& s : stretches) add(s, nodes[s.node]);
        take(groups, nodes);
        if (peaks.empty()) return std::move(out_);
        const SwayedGroups of_peaks(g_, connector_, peaks, pictures_);
        nodes.assign(of_peaks.nodes(), {});
        for (const Stretch& s : peaks) find_first(s, nodes[s.node]), add(s, nodes[s.node]);
        take(of_peaks, nodes);
        return std::move(out_);
    }

private:
    // Neighbours in a row that the same pictures show are one stretch.
    void append(uint32_t pixel, Shown shown, std::vector<Stretch>& to, uint32_t node = 0) const {
        if (!shown) return;
        const bool joins = !to.empty() && to.back().shown == shown && to.back().node == node &&
                           to.back().start + to.back().length == pixel && pixel % uint32_t(g_.width) != 0;
        if (joins) ++to.back().length;
        else to.push_back({pixel, 1, shown, node});
    }
    // Which pictures show a pixel for which test(its grey) holds.
    template <class Test>
    Shown shown_where(size_t p, Test test) const {
        const Shown mean = Shown(1) << bright_.count(), minus = bright_.minus(p), each = mean - 1;
        return (test(bright_.mean[p] + bright_.off[p]) ? ~minus & each : 0) |
               (test(bright_.mean[p] - bright_.off[p]) ? minus & each : 0) | (test(bright_.mean[p]) ? mean : 0);
    }
    std::vector<Stretch> bright_stretches() const {
        const float low = *std::min_element(limit_.begin(), limit_.end()),
                    high = *std::max_element(limit_.begin(), limit_.end());
        std::vector<Stretch> out;
        const auto add_pixel = [&](size_t p) {
            const float off = std::fabs(bright_.off[p]);
            Shown shown = 0;
            if (bright_.mean[p] - off > high) shown = all_;
            else if (!(bright_.mean[p] + off > low)) return;
            else if (low == high) shown = shown_where(p, [&](float grey) { return grey > low; });
            else
                for (int k = 0; k < pictures_; ++k) {
                    const float grey = k < bright_.count() ? bright_.at(k, p) : bright_.mean[p];
                    shown |= Shown(grey > limit_[size_t(k)]) << k;
                }
            append(uint32_t(p), shown, out);
        };
        constexpr int block = 32;  // most are dark
        for (int r = 0; r < g_.height; ++r)
            for (size_t s = g_.row_spans[r]; s < g_.row_spans[r + 1]; ++s)
                for (int x = g_.spans[s].begin; x < g_.spans[s].end; x += block) {
                    const int n = std::min(block, g_.spans[s].end - x);
                    const size_t first = size_t(r) * g_.width + x;
                    if (!bright_.may_exceed(first, n, low)) continue;
                    for (size_t p = first; p < first + size_t(n); ++p) add_pixel(p);
                }
        return out;
    }
    Shown peak(size_t p) const {
        return shown_where(p, [&](float grey) { return luminance(grey) >= settings_.peak_limit; });
    }
    // Peaks leave their group where there is a pixel above the limit; which of them belong together does not depend
    // on their groups, as those within reach of each other are of one.
    std::vector<Stretch> peak_stretches(const std::vector<Stretch>& stretches) {
        std::vector<Stretch> out;
        for (const Stretch& s : stretches)
            for (uint32_t p = s.start; p < s.start + s.length; ++p) {
                append(p, peak(p) & s.shown, out);
                const auto above = [&](float grey) { return cdm2_per_grey * grey > settings_.peak_limit; };
                peaks_in_ |= shown_where(p, above) & s.shown;
            }
        if (peaks_in_ != all_)
            for (Stretch& s : out) s.shown &= peaks_in_;
        out.erase(std::remove_if(out.begin(), out.end(), [](const Stretch& s) { return !s.shown; }), out.end());
        return out;
    }
    std::vector<Stretch> without_peaks(const std::vector<Stretch>& stretches) const {
        std::vector<Stretch> out;
        for (const Stretch& s : stretches)
            for (uint32_t p = s.start; p < s.start + s.length; ++p)
                append(p, s.shown & ~(peak(p) & peaks_in_), out, s.node);
        return out;
    }

    void find_first(const Stretch& s, Node& node) const {
        const uint64_t key = uint64_t(g_.x_of(s.start)) * uint64_t(g_.height) + uint64_t(g_.y_of(s.start));
        for (int k = 0; k < pictures_; ++k)
            if (s.shown >> k & 1) node[size_t(k)].first = std::min(node[size_t(k)].first, key);
    }
    void add(const Stretch& s, Node& node) const {
        if (s.shown == all_) return add_to_all(s, node);
        for (uint32_t p = s.start; p < s.start + s.length; ++p)
            for (int k = 0; k < pictures_; ++k) {
                if (!(s.shown >> k & 1)) continue;
                Part& to = node[size_t(k)];
                const float grey = k < lum_.count() ? lum_.at(k, p) : lum_.mean[p];
                to.pixels += 1, to.omega += g_.omega[p];
                for (const auto& [sum, L] :
                     {std::pair(&to.own, luminance(grey)), {&to.mean, luminance(lum_.mean[p])}}) {
                    const double power = L * g_.omega[p];
                    sum->power += power, sum->x += power * g_.x_of(p), sum->y += power * g_.y_of(p);
                    sum->eye += L * g_.omega_cos[p];
                }
            }
    }
    void add_to_all(const Stretch& s, Node& node) const {
        RowSums row;
        add_row(lum_, g_, s.start, s.length, g_.x_of(s.start), row);
        const double y = g_.y_of(s.start);
        const auto add = [&](Sum& to, double power, double x, double eye) {
            to.power += power, to.x += x, to.y += power * y, to.eye += eye;
        };
        for (size_t k = 0; k < size_t(pictures_); ++k) {
            const bool mean = k + 1 == size_t(pictures_);
            node[k].pixels += s.length, node[k].omega += row.omega;
            add(node[k].mean, row.mean.power, row.mean.x, row.mean.eye);
            if (mean) add(node[k].own, row.mean.power, row.mean.x, row.mean.eye);
            else
                add(node[k].own, row.middle.power + row.power[k], row.middle.x + row.x[k], row.middle.eye + row.eye[k]);
        }
    }

    // The sources of each picture, in the order of their first pixels.
    void take(const SwayedGroups& groups, const std::vector<Node>& nodes) {
        for (int k = 0; k < pictures_; ++k) {
            std::vector<Part> of_root(nodes.size());
            for (uint32_t n = 0; n < nodes.size(); ++n) {
                const Part& part = nodes[n][size_t(k)];
                if (part.first == UINT64_MAX) continue;
                Part& to = of_root[groups.root(k, n)];
                to.pixels += part.pixels, to.omega += part.omega, to.first = std::min(to.first, part.first);
                for (const auto& [sum, more] : {std::pair(&to.own, &part.own), {&to.mean, &part.mean}})
                    sum->power += more->power, sum->x += more->x, sum->y += more->y, sum->eye += more->eye;
            }
            const auto none = [](const Part& p) { return p.pixels == 0; };
            of_root.erase(std::remove_if(of_root.begin(), of_root.end(), none), of_root.end());
            std::sort(of_root.begin(), of_root.end(), [](const Part& a, const Part& b) { return a.first < b.first; });
            for (const Part& p : of_root) {
                out_[size_t(k)].own.push_back(source(p, p.own));
                out_[size_t(k)].of_mean.push_back(source(p, p.mean));
            }
        }
    }
    GlareSource source(const Part& part, const Sum& sum) const {
        GlareSource s;
        s.pixels = part.pixels, s.omega = part.omega, s.lum = sum.power / part.omega;
        s.x = sum.x / sum.power, s.y = sum.y / sum.power, s.eye_lux = sum.eye;
        place(s, g_, settings_);
        return s;
    }

    const Swayed &lum_, &bright_;
    const Geometry& g_;
    const Settings& settings_;
    Connector& connector_;
    int pictures_;  // and the mean
    std::vector<float> limit_;
    Shown all_ = 0, peaks_in_ = 0;
    std::vector<SwayedSources> out_;
};

}  // namespace

bool sources_at_once(const Settings& s) {
    const bool plain_pixels = !s.slips && !s.fast && !s.field_cut && !s.fill && !s.check_picture;
    const bool plain_sources = s.dgp_form == DgpForm::merged && !s.smooth && !s.patches && !s.zones;
    return plain_pixels && plain_sources && !s.task && s.task_region.empty() && !s.band_rad && !s.mask_file;
}

std::vector<SwayedSources> all_sources(const Swayed& lum, const Swayed& bright, const std::vector<double>& thresholds,
                                       const Geometry& geometry, const Settings& settings, Connector& connector) {
    return AllSources(lum, bright, thresholds, geometry, settings, connector).find();
}

}  // namespace comfort
