// SPDX-License-Identifier: BSD-3-Clause
// Bright stretches, their nodes (swayed_groups.h), sums by node and picture, sources (swayed_sources.h).
#include "comfort/swayed_sources.h"

#include <algorithm>
#include <cmath>

#include "comfort/detect.h"
#include "comfort/luminance.h"
#include "comfort/source_sums.h"
#include "comfort/swayed_groups.h"

namespace comfort {
namespace {

constexpr size_t most = Signs::most + 1;  // pictures, and the mean

double luminance(float grey) {
    Luminance one;
    one.grey = &grey;
    return one.at(0);
}

// What a picture shows of a node.
struct Part {
    double pixels = 0, omega = 0;
    SourceSum own, mean;
    uint64_t first = UINT64_MAX;  // in column order
};

struct Node {
    std::array<Part, most> part;
    // Of what all pictures show: the middle of each pixel's two values, and by word how far they lie off it.
    Part common;
    std::vector<SourceSum> off;
};

class AllSources {
public:
    AllSources(const Swayed& lum, const Calmed& bright, const std::vector<double>& thresholds,
               const std::vector<Run>& bright_in_mean, const Geometry& g, const Settings& settings,
               Connector& connector)
        : lum_(lum),
          bright_(bright),
          bright_in_mean_(bright_in_mean),
          most_in_doubt_(bright.most_in_doubt()),
          g_(g),
          settings_(settings),
          connector_(connector),
          pictures_(lum.count() + 1) {
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
    void append(const Stretch& s, std::vector<Stretch>& to) const {
        if (!s.shown) return;
        const bool joins = !to.empty() && to.back().start + to.back().length == s.start && to.back().shown == s.shown &&
                           to.back().node == s.node && s.start % uint32_t(g_.width) != 0;
        if (joins) to.back().length += s.length;
        else to.push_back(s);
    }
    // Which pictures show a pixel for which test(its grey) holds.
    template <class Test>
    Shown shown_where(size_t p, const Calmed::Pixel& grey, Test test) const {
        const Shown mean = Shown(1) << lum_.count(), minus = lum_.minus(p), each = mean - 1;
        return (test(grey.mean + grey.sway) ? ~minus & each : 0) | (test(grey.mean - grey.sway) ? minus & each : 0) |
               (test(grey.mean) ? mean : 0);
    }
    Shown bright(size_t p, const Calmed::Pixel& grey, float low, float high) const {
        const float off = std::fabs(grey.sway);
        if (grey.mean - off > high) return all_;
        if (!(grey.mean + off > low)) return 0;
        if (low == high) return shown_where(p, grey, [&](float v) { return v > low; });
        Shown shown = 0;
        for (int k = 0; k < pictures_; ++k)
            shown |= shown_where(p, grey, [&](float v) { return v > limit_[size_t(k)]; }) & Shown(1) << k;
        return shown;
    }
    std::vector<Stretch> bright_stretches() const {
        const float low = *std::min_element(limit_.begin(), limit_.end()),
                    high = *std::max_element(limit_.begin(), limit_.end());
        std::vector<Stretch> out;
        const Doubtful *next = bright_.in_doubt().data(), *const end = next + bright_.in_doubt().size();
        const auto in_doubt = [&](uint32_t before) {
            for (; next != end && next->pixel < before; ++next) {
                const Shown shown = bright(next->pixel, {next->mean, next->sway}, low, high);
                if (shown && g_.valid(next->pixel)) append({next->pixel, 1, shown}, out);
            }
        };
        const auto sure = [&](uint32_t p, uint32_t to) {
            if (low == high && p < to) return append({p, to - p, all_}, out);
            for (; p < to; ++p) append({p, 1, bright(p, {lum_.mean[p], 0}, low, high)}, out);
        };
        for (const Run& r : bright_in_mean_) {
            uint32_t p = r.start;
            const uint32_t to = r.start + r.length;
            in_doubt(p);
            while (next != end && next->pixel < to) {
                sure(p, next->pixel);
                p = next->pixel + 1;
                in_doubt(p);
            }
            sure(p, to);
        }
        in_doubt(uint32_t(g_.omega.size()));
        return out;
    }
    Shown peak(size_t p) const {
        return shown_where(p, bright_.at(p), [&](float grey) { return luminance(grey) >= settings_.peak_limit; });
    }
    bool may_have_peaks(const Stretch& s) const {
        const float nearly = float(settings_.peak_limit / cdm2_per_grey * (1 - 1e-6));
        return bright_.mean_exceeds(s.start, int(s.length), nearly) ||
               (most_in_doubt_ > nearly && bright_.doubtful_exceeds(s.start, int(s.length), nearly));
    }
    // Peaks leave their group where there is a pixel above the limit; which of them belong together does not depend
    // on their groups, as those within reach of each other are of one.
    std::vector<Stretch> peak_stretches(const std::vector<Stretch>& stretches) {
        std::vector<Stretch> out;
        for (const Stretch& s : stretches) {
            if (!may_have_peaks(s)) continue;
            for (uint32_t p = s.start; p < s.start + s.length; ++p) {
                append({p, 1, peak(p) & s.shown}, out);
                const auto above = [&](float grey) { return cdm2_per_grey * grey > settings_.peak_limit; };
                peaks_in_ |= shown_where(p, bright_.at(p), above) & s.shown;
            }
        }
        for (Stretch& s : out) s.shown &= peaks_in_;
        out.erase(std::remove_if(out.begin(), out.end(), [](const Stretch& s) { return !s.shown; }), out.end());
        return out;
    }
    std::vector<Stretch> without_peaks(const std::vector<Stretch>& stretches) const {
        std::vector<Stretch> out;
        for (const Stretch& s : stretches) {
            if (!may_have_peaks(s)) out.push_back(s);
            else
                for (uint32_t p = s.start; p < s.start + s.length; ++p)
                    append({p, 1, s.shown & ~(peak(p) & peaks_in_), s.node}, out);
        }
        return out;
    }

    void find_first(const Stretch& s, Node& node) const {
        const uint64_t key = uint64_t(g_.x_of(s.start)) * uint64_t(g_.height) + uint64_t(g_.y_of(s.start));
        const auto lower = [&](Part& part) { part.first = std::min(part.first, key); };
        if (s.shown == all_) return lower(node.common);
        for (int k = 0; k < pictures_; ++k)
            if (s.shown >> k & 1) lower(node.part[size_t(k)]);
    }
    void add(const Stretch& s, Node& node) const {
        if (s.shown == all_) return add_common(s, node);
        const double y = g_.y_of(s.start);
        double x = g_.x_of(s.start);
        for (uint32_t p = s.start; p < s.start + s.length; ++p, ++x)
            for (int k = 0; k < pictures_; ++k) {
                if (!(s.shown >> k & 1)) continue;
                Part& to = node.part[size_t(k)];
                const float mean = lum_.mean[p], own = k < lum_.count() ? lum_.at(k, p) : mean;
                to.pixels += 1, to.omega += g_.omega[p];
                to.mean.add(mean, g_.omega[p], g_.omega_cos[p], x, y);
                to.own.add(own, g_.omega[p], g_.omega_cos[p], x, y);
            }
    }
    void add_common(const Stretch& s, Node& node) const {
        if (node.off.empty()) node.off.resize(Signs::words);
        CommonSums sum;
        add_stretch(lum_, g_, s.start, s.length, sum, node.off.data());
        node.common.pixels += s.length, node.common.omega += sum.omega;
        node.common.mean.add(sum.mean), node.common.own.add(sum.own);
    }
    // What all pictures show goes to each of them.
    void share(Node& node) const {
        if (node.common.first == UINT64_MAX) return;
        for (int k = 0; k < pictures_; ++k) {
            Part& to = node.part[size_t(k)];
            to.pixels += node.common.pixels, to.omega += node.common.omega;
            to.first = std::min(to.first, node.common.first);
            to.mean.add(node.common.mean);
            to.own.add(k == lum_.count() ? node.common.mean : node.common.own);
            for (size_t p = 0; k < lum_.count() && p < node.off.size(); ++p)
                to.own.add(node.off[p], lum_.signs->factor[p][size_t(k)]);
        }
    }

    // The sources of each picture, in the order of their first pixels.
    void take(const SwayedGroups& groups, std::vector<Node>& nodes) {
        for (Node& n : nodes) share(n);
        for (int k = 0; k < pictures_; ++k) {
            std::vector<Part> of_root(nodes.size());
            for (uint32_t n = 0; n < nodes.size(); ++n) {
                const Part& part = nodes[n].part[size_t(k)];
                if (part.first == UINT64_MAX) continue;
                Part& to = of_root[groups.root(k, n)];
                to.pixels += part.pixels, to.omega += part.omega, to.first = std::min(to.first, part.first);
                to.own.add(part.own), to.mean.add(part.mean);
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
    GlareSource source(const Part& part, const SourceSum& sum) const {
        GlareSource s;
        s.pixels = part.pixels, s.omega = part.omega, s.lum = cdm2_per_grey * sum.power / part.omega;
        s.x = sum.x / sum.power, s.y = sum.y / sum.power, s.eye_lux = cdm2_per_grey * sum.eye;
        place(s, g_, settings_);
        return s;
    }

    const Swayed& lum_;
    const Calmed& bright_;
    const std::vector<Run>& bright_in_mean_;
    const float most_in_doubt_;
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

std::vector<SwayedSources> all_sources(const Swayed& lum, const Calmed& bright, const std::vector<double>& thresholds,
                                       const std::vector<Run>& bright_in_mean, const Geometry& geometry,
                                       const Settings& settings, Connector& connector) {
    return AllSources(lum, bright, thresholds, bright_in_mean, geometry, settings, connector).find();
}

}  // namespace comfort
