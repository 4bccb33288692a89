// SPDX-License-Identifier: BSD-3-Clause
// Bright pixels to groups as evalglare does, for -like evalglare: same groups, same numbers, and sums grown
// pixel by pixel in its order, since their last bits decide where a centre falls and which of two groups is larger.
// luxpipe labels connected components (glare/connected_components.h), which gives the same groups but for accidents of
// rounding.
#pragma once
#include <cstdint>
#include <vector>
#include "evalglare/check_picture.h"
#include "evalglare/neighbour_search.h"
#include "glare/connected_components.h"

namespace evalglare {
using glare::Run;

// Running sums of one group.
struct GroupSums {
    double pixels = 0, omega = 0, lum = 0;  // omega-weighted mean luminance
    double x = 0, y = 0;                    // mean position weighted by L w; y from the bottom
    double brightest = 0;                   // of all pixels it ever had
    void add(double pixel_lum, double pixel_omega, int pixel_x, int pixel_y);
    void remove(double pixel_lum, double pixel_omega, int pixel_x, int pixel_y);
};

class Groups {
public:
    Groups(const Geometry& geometry, double search_opening);
    // First scan: every bright pixel joins a group in reach or opens one.  Second, with `merge`: groups join a larger
    // one in reach until none can.  `shortcut`: a pixel above a bright one takes its group unseen.
    void find(const std::vector<Run>& bright, const CheckPicture& lum, bool shortcut, bool merge);
    // `groups` groups that are known (-z), pixels in the order in which evalglare adds them up: row by row from below.
    void take(const std::vector<Run>& grouped, uint32_t groups, const CheckPicture& lum);
    // Pixels of at least `limit` leave their group for new ones, connected at half the reach and then merged.
    void extract_peaks(const CheckPicture& lum, double limit);
    // A pixel of no group joins one, from now on like all others; or it only adds to a group's sums (smoothing).
    void add(uint32_t pixel, uint32_t group, const CheckPicture& lum);
    void count_too(uint32_t pixel, uint32_t group, const CheckPicture& lum);
    void leave(uint32_t pixel, const CheckPicture& lum);
    void join(uint32_t pixel, uint32_t group, const CheckPicture& lum);
    uint32_t open();
    uint32_t count() const { return uint32_t(sums_.size() - 1); }
    const std::vector<GroupSums>& sums() const { return sums_; }  // by number, from 1
    std::vector<Run> runs() const;                                // in picture order

private:
    void start(const std::vector<Run>& pixels);
    uint32_t group_in_reach(uint32_t pixel) const;
    uint32_t larger_in_reach(uint32_t pixel, uint32_t from_group) const;
    uint32_t peak_in_reach(uint32_t pixel, const AngularRadius& radius, uint32_t from_group) const;
    bool follows_bright(uint32_t pixel) const;
    bool surrounded(uint32_t pixel) const;
    void merge(const std::vector<uint32_t>& pixels, uint32_t from_group, bool skip_surrounded, const CheckPicture& lum);
    uint32_t column_key(uint32_t pixel) const;
    void sort_by_column(std::vector<uint32_t>& pixels) const;

    const Geometry& geometry_;
    NeighbourSearch search_;
    double opening_;
    AngularRadius radius_;
    std::vector<uint32_t> group_;   // by pixel, 0 = none
    std::vector<uint32_t> pixels_;  // of all groups, in column order
    std::vector<GroupSums> sums_;
    std::vector<std::vector<uint32_t>> members_;  // by group, in any order
};

}  // namespace evalglare
