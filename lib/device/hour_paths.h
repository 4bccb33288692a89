// SPDX-License-Identifier: BSD-3-Clause
// What a pass of paths for many hours gives (kernels/integrator/hours.h): for each path what it gets from the skies and
// suns of all hours, per radiance of theirs.
#pragma once
#include <cmath>
#include <cstdint>
#include <vector>

namespace device {

// Response to a sun: light over the radiance of its disc.
struct SunShare {
    uint32_t sun;
    float rgb[3];
};

// Share of a path in the light of a suffix vertex.
struct SuffixShare {
    uint32_t suffix;  // its path in the square
    float rgb[3];
};

struct SkyShare {
    float dir[3], rgb[3];
    uint32_t kind;  // SKY_*; SKY_GATHERS: dir is a normal, rgb the reflectance
};

struct HourPaths {
    std::vector<float> rest;  // light that is the same in all hours, as Device::run() gives it
    std::vector<SkyShare> sky;
    std::vector<float> end;  // 3 floats a path: where it ends in SKY_GATHERS
    std::vector<SunShare> suns;
    // Path p's own suns are from suns_at[2 p] on, those of its suffix vertex from suns_at[2 p + 1] to suns_at[2 p + 2].
    std::vector<uint64_t> suns_at;
    // With path reuse: those of path p from shares_at[p] on.
    std::vector<SuffixShare> shares;
    std::vector<uint64_t> shares_at;

    void append(HourPaths&& more);  // of the paths that follow
};

// Shares in the order in which they are found, vertex by vertex.
class FoundSuns {
public:
    // list: of suns_at.
    void add(uint32_t list, uint32_t sun, const float* rgb, float weight) {
        if (!(std::fabs(rgb[0]) + std::fabs(rgb[1]) + std::fabs(rgb[2]) > 0.0f)) return;
        found_.push_back({list, {sun, {weight * rgb[0], weight * rgb[1], weight * rgb[2]}}});
    }
    // List by list.
    void sort(uint32_t lists, HourPaths& out) const {
        out.suns_at.assign(lists + 1u, 0);
        for (const Found& f : found_) out.suns_at[f.list + 1u]++;
        for (uint32_t i = 0; i < lists; i++) out.suns_at[i + 1u] += out.suns_at[i];
        std::vector<uint64_t> place(out.suns_at.begin(), out.suns_at.end() - 1);
        out.suns.resize(found_.size());
        for (const Found& f : found_) out.suns[place[f.list]++] = f.share;
    }

private:
    struct Found {
        uint32_t list;
        SunShare share;
    };
    std::vector<Found> found_;
};

inline void HourPaths::append(HourPaths&& more) {
    const auto add = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    const auto add_places = [](auto& to, const auto& from, uint64_t before) {
        if (to.empty() && !from.empty()) to.push_back(0);
        for (size_t i = 1; i < from.size(); i++) to.push_back(before + from[i]);
    };
    add_places(suns_at, more.suns_at, suns.size());
    add_places(shares_at, more.shares_at, shares.size());
    add(sky, more.sky);
    add(end, more.end);
    add(suns, more.suns);
    add(shares, more.shares);
}

}  // namespace device
