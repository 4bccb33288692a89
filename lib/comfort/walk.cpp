// SPDX-License-Identifier: BSD-3-Clause
// evalglare's first scan where its search radius is a pixel or less (-like evalglare): there it does not go on to
// merge, so that what it finds is not the connected components.  Every bright pixel, columns from the left and from
// the bottom, joins a group found by a walk along the rows below and then above, or opens a new one; in each row the
// walk goes left, then right from the middle of the stretch it reached before, never past the pixel's own column.
#include <cmath>
#include "comfort/sources.h"

namespace comfort {
namespace {

class Walk {
public:
    Walk(const Geometry& g, double opening) : g_(g), opening_(float(opening)), group_(g.omega.size(), 0) {}
    uint32_t run(std::vector<Run>& runs) {
        std::vector<char> bright(g_.omega.size(), 0);
        for (const Run& r : runs)
            for (uint32_t p = r.start; p < r.start + r.length; ++p) bright[p] = 1;
        uint32_t groups = 0;
        for (int x = 0; x < g_.width; ++x)
            for (int y = 0; y < g_.height; ++y) {
                const size_t i = g_.index(x, y);
                if (!bright[i]) continue;
                const uint32_t found = search(x, y);
                group_[i] = found ? found : ++groups;
            }
        std::vector<Run> single;
        for (const Run& r : runs)
            for (uint32_t p = r.start; p < r.start + r.length; ++p) single.push_back({p, 1, group_[p]});
        runs.swap(single);
        return groups;
    }

private:
    uint32_t search(int x, int y) {
        from_ = g_.direction(x, y);
        const uint32_t below = half(x, y, 0, -1), above = half(x, y + 1, g_.height - 1, 1);
        return above ? above : below;
    }
    bool in_reach(int x, int y) const { return 2 * std::acos(dot(from_, g_.direction(x, y))) <= opening_; }
    uint32_t half(int x, int first, int last, int step) {
        int low = x, high = x;
        for (int row = first; step < 0 ? row >= last : row <= last; row += step) {
            int c = (low + high) / 2;
            for (; c >= 0 && in_reach(c, row); --c)
                if (const uint32_t group = group_[g_.index(c, row)]) return group;
            low = c + 1;
            c = (low + high) / 2;
            for (; c <= x && in_reach(c, row); ++c)
                if (const uint32_t group = group_[g_.index(c, row)]) return group;
            high = c - 1;
        }
        return 0;
    }
    const Geometry& g_;
    double opening_;
    std::vector<uint32_t> group_;
    Vec3 from_;
};

}  // namespace

uint32_t walk_groups(std::vector<Run>& runs, const Geometry& geometry, double opening) {
    return Walk(geometry, opening).run(runs);
}

}  // namespace comfort
