// SPDX-License-Identifier: BSD-3-Clause
// Merging sums of frames that were made apart: see accumulate.h.
#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "base/processors.h"
#include "base/threads.h"
#include "film/accumulate.h"
#include "film/fingerprint.h"
#include "image/header.h"

namespace film {
namespace {

constexpr size_t most_history = 2000;  // header lines of inputs that are kept

int64_t diffuse_frames(const image::Ranges& ranges) {
    int64_t n = 0;
    for (const auto& r : ranges) n += r.second - std::max<int64_t>(r.first, 1) + 1;
    return n;
}

bool has_frame0(const image::Ranges& ranges) {
    return std::any_of(ranges.begin(), ranges.end(), [](const auto& r) { return r.first == 0; });
}

// First frame that both hold, or -1.
int64_t common_frame(const image::Ranges& a, const image::Ranges& b) {
    for (const auto& x : a)
        for (const auto& y : b)
            if (x.first <= y.second && y.first <= x.second) return std::max(x.first, y.first);
    return -1;
}

// Sorted, neighbours joined: 0:9 and 10:40 are 0:40.
void add_ranges(image::Ranges& to, const image::Ranges& more) {
    to.insert(to.end(), more.begin(), more.end());
    std::sort(to.begin(), to.end());
    image::Ranges joined;
    for (const auto& r : to) {
        if (!joined.empty() && r.first == joined.back().second + 1) joined.back().second = r.second;
        else joined.push_back(r);
    }
    to = joined;
}

std::string seed_text(bool has_seed, uint64_t seed) { return has_seed ? fmt::format("seed {}", seed) : "no seed"; }

}  // namespace

Merger::Group& Merger::group_of(const image::Header& h) {
    for (Group& g : groups_)
        if (g.has_seed == h.seed.has_value() && (!g.has_seed || g.seed == *h.seed)) return g;
    groups_.emplace_back();
    groups_.back().has_seed = h.seed.has_value();
    groups_.back().seed = h.seed.value_or(0);
    return groups_.back();
}

void Merger::check_ranges(const image::Header& h, const std::string& name) const {
    const auto check = [&](bool has_seed, uint64_t seed, const image::Ranges& ranges) {
        for (const Group& g : groups_) {
            std::vector<std::pair<uint64_t, image::Ranges>> held = g.whole.header.other_seeds;
            if (g.has_seed) held.push_back({g.seed, g.ranges});
            else if (!has_seed && common_frame(g.ranges, ranges) >= 0)
                base::fail(name, fmt::format("frame {} is in {} already", common_frame(g.ranges, ranges), g.last_name));
            for (const auto& [other, theirs] : held)
                if (has_seed && other == seed) {
                    if (const int64_t k = common_frame(theirs, ranges); k >= 0)
                        base::fail(name, fmt::format("frame {} of seed {} is in {} already", k, seed, g.last_name));
                    if (!g.whole.header.other_seeds.empty() || !h.other_seeds.empty())
                        base::fail(name, fmt::format("has more frames of seed {}, which {} mixes with other seeds: "
                                                     "merge all the parts at once",
                                                     seed, g.last_name));
                }
        }
    };
    check(h.seed.has_value(), h.seed.value_or(0), h.ranges);
    for (const auto& [seed, ranges] : h.other_seeds) check(true, seed, ranges);
}

void Merger::add(image::Picture p, const std::string& name) {
    image::Header& h = p.header;
    if (!h.frames)
        base::fail(name, h.frame ? "is a single frame: merging needs sums of frames"
                                 : "has no FRAMES= line: not a sum of frames");
    if (h.ranges.empty()) h.ranges = {{0, *h.frames}};
    int64_t held = diffuse_frames(h.ranges);
    for (const auto& other : h.other_seeds) held += diffuse_frames(other.second);
    if (held != *h.frames)
        base::fail(name, fmt::format("FRAMES={} does not fit RANGE={}, which holds {} diffuse frames", *h.frames,
                                     image::to_text(h.ranges), held));
    if (inputs_++ == 0) {
        first_ = h;
        first_name_ = name;
        width_ = p.width;
        height_ = p.height;
    }
    if (p.width != width_ || p.height != height_)
        base::fail(name, fmt::format("is {} x {}, {} is {} x {}", p.width, p.height, first_name_, width_, height_));
    if (h.view != first_.view) base::fail(name, "has another view than " + first_name_);
    if (h.grids != first_.grids) base::fail(name, "has other points than " + first_name_);
    require_same_action(h, first_, name, first_name_);
    require_same_fingerprint(h, first_, name, first_name_);
    check_ranges(h, name);
    image::Header input;
    image::add_input_history(input, name, h);
    for (const std::string& line : input.lines)
        if (history_.size() < most_history) history_.push_back(line);

    Group& g = group_of(h);
    const bool zero = has_frame0(h.ranges);
    const bool apart = !zero || *h.frames == 0 || !p.frame0.empty();  // frame 0 known apart from the rest
    if (g.is_whole() || (!apart && !g.ranges.empty()))
        base::fail(g.is_whole() ? g.last_name : name,
                   "has frame 0 summed in and not kept apart, so that no further frames of its seed can be weighted: "
                   "write it as OpenEXR (-o file.exr), which keeps frame 0");
    g.frames += *h.frames;
    add_ranges(g.ranges, h.ranges);
    g.last_name = name;
    parts_.add(p, size_t(&g - groups_.data()), name);
    if (zero) g.moments = p.moments;
    if (!apart) {
        g.whole = std::move(p);
        return;
    }
    if (zero) g.frame0 = *h.frames == 0 ? p.rgb : p.frame0;
    if (g.sum.size() == 0) g.sum.clear(p.rgb.size());
    add_frames_of(p, name, g.sum);
}

// The moments of the only seed, or the mean over seeds weighted by their frames; none if a seed has none.
image::Moments Merger::merged_moments() const {
    if (groups_.size() == 1) return groups_[0].moments;
    int64_t frames = 0;
    for (const Group& g : groups_) {
        if (!g.moments) return {};
        frames += g.frames;
    }
    std::vector<double> sum(groups_[0].moments->size(), 0.0);
    for (const Group& g : groups_)
        for (size_t i = 0; i < sum.size(); ++i) sum[i] += double(g.frames) / double(frames) * double((*g.moments)[i]);
    return std::make_shared<const std::vector<float>>(sum.begin(), sum.end());
}

image::Picture Merger::result() const {
    if (groups_.empty()) base::fail("", "nothing to merge");
    image::Picture out;
    out.width = width_;
    out.height = height_;
    out.header.view = first_.view;
    out.header.grids = first_.grids;
    out.header.action = first_.action;
    out.header.fingerprint = first_.fingerprint;
    out.header.direct_frames = first_.direct_frames;
    out.header.pixel_aspect = first_.pixel_aspect;
    out.header.exposure = first_.exposure;
    out.header.lines = inputs_ == 1 ? first_.lines : history_;
    int64_t total = 0;
    for (const Group& g : groups_) {
        total += g.frames;
        if (groups_.size() > 1 && !g.complete())
            base::fail(
                g.last_name,
                fmt::format(
                    "{}: frames {} come without frame 0, and sums of different seeds are averaged only when complete",
                    seed_text(g.has_seed, g.seed), image::to_text(g.ranges)));
        if (groups_.size() > 1 && g.frames == 0)
            base::fail(g.last_name, seed_text(g.has_seed, g.seed) +
                                        ": frame 0 by itself cannot be averaged with the frames of another seed");
        if (groups_.size() > 1 && !g.has_seed)
            base::fail(g.last_name, "has no SEED= line: it cannot be distinguished from the others");
    }
    std::vector<double> sum(3 * size_t(width_) * height_, 0);
    for (const Group& g : groups_) {
        const double weight = groups_.size() > 1 ? double(g.frames) / double(total) : 1;
        base::in_shares(sum.size(), 1u << 16, base::processors(), [&](size_t first, size_t end) {
            for (size_t i = first; i < end; ++i)
                sum[i] += weight * (g.is_whole() ? double(g.whole.rgb[i]) : eq7(g.frame0, g.sum, g.frames, i));
        });
    }
    out.rgb.assign(sum.begin(), sum.end());
    out.moments = merged_moments();
    if (groups_.size() == 1) {
        out.frame0 = groups_[0].frame0;
        out.sum = groups_[0].sum.layers();
    }
    std::vector<const std::vector<float>*> frame0;
    for (const Group& g : groups_) frame0.push_back(&g.frame0);
    parts_.result(frame0, out);
    for (size_t i = 0; i < groups_.size(); ++i) {
        const Group& g = groups_[i];
        if (i == 0) {
            if (g.has_seed) out.header.seed = g.seed;
            out.header.ranges = g.ranges;
        } else {
            out.header.other_seeds.push_back({g.seed, g.ranges});
        }
        const auto& more = g.whole.header.other_seeds;
        out.header.other_seeds.insert(out.header.other_seeds.end(), more.begin(), more.end());
    }
    out.header.frames = total;
    return out;
}

}  // namespace film
