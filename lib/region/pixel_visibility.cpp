// SPDX-License-Identifier: BSD-3-Clause
// See pixel_visibility.h.
#include "region/pixel_visibility.h"
#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <set>

namespace region {

PixelVisibility::PixelVisibility(const Space& space, const SceneView& eye)
    : space_(space), eye_(eye), nx_(space.nx), ny_(space.ny) {
    trace_centres();
    collect_tiles();
}

RayHits PixelVisibility::trace(double x, double y) const {
    RayHits s;
    const auto ray = space_.projector.ray(x / nx_, y / ny_);
    s.seen = bool(ray);
    if (!ray) return s;
    s.p = {ray->dir, x, y};
    if (space_.behind > 0) space_.point(x, y, s.p);
    s.begin = dot(ray->origin - space_.eye, s.p.dir);
    bool closed = false;
    s.n = eye_.look(ray->origin, ray->dir, ray->tmax, s.crossings, RayHits::room, closed);
    for (int i = 0; i < s.n; ++i) s.crossings[i].t += s.begin;
    s.end = closed && s.n ? s.crossings[s.n - 1].t : ray->tmax > 0 ? s.begin + ray->tmax : INFINITY;
    return s;
}

void PixelVisibility::trace_centres() {
    directions_.resize(size_t(nx_) * size_t(ny_));
    ends_.resize(directions_.size());
    list_of_.resize(directions_.size());
    lists_.push_back({});  // 0: no ray
    std::mutex lock;
    std::map<std::vector<unsigned>, uint32_t> known;
    for_all(size_t(ny_), [&](size_t y) {
        std::map<std::vector<unsigned>, uint32_t> mine;
        std::vector<unsigned> list;
        for (int x = 0; x < nx_; ++x) {
            RayHits s = trace(x + .5, double(y) + .5);
            size_t i = y * size_t(nx_) + size_t(x);
            directions_[i] = s.p.dir;
            ends_[i] = s.end;
            if (!s.seen) continue;
            list.clear();
            for (int k = 0; k < s.n; ++k) list.push_back(s.crossings[k].surface);
            auto found = mine.find(list);
            if (found == mine.end()) {
                std::lock_guard<std::mutex> hold(lock);
                auto global = known.find(list);
                if (global == known.end()) {
                    global = known.emplace(list, uint32_t(lists_.size())).first;
                    lists_.push_back(list);
                }
                found = mine.emplace(list, global->second).first;
            }
            list_of_[i] = found->second;
        }
    });
}

void PixelVisibility::collect_tiles() {
    across_ = (nx_ + tile - 1) / tile;
    tiles_.resize(size_t(across_) * size_t((ny_ + tile - 1) / tile));
    for_all(tiles_.size(), [&](size_t t) {  // with a rim of one pixel
        int x0 = int(t) % across_ * tile, y0 = int(t) / across_ * tile;
        std::set<uint32_t> lists;
        for (int y = std::max(y0 - 1, 0); y <= std::min(y0 + tile, ny_ - 1); ++y)
            for (int x = std::max(x0 - 1, 0); x <= std::min(x0 + tile, nx_ - 1); ++x) lists.insert(list(x, y));
        tiles_[t].assign(lists.begin(), lists.end());
    });
}

}  // namespace region
