// SPDX-License-Identifier: BSD-3-Clause
// How far a sum of frames still is from its limit, as a picture: the standard error of the mean luminance of each block
// of 8 x 8 pixels over that mean, rms over the blocks, but for the 2 % that are furthest off (what few paths light).
// The error takes frames for independent.  They are not: a pixel's samples are points of one low-discrepancy
// sequence, so the true error is often smaller.
#pragma once
#include <cstdint>
#include <vector>
#include "image/picture.h"

namespace film {

class BlockError {
public:
    void restart(const image::Picture& frame0);
    void add(const image::Picture& frame);  // 1, 2, 3 ...
    // Infinity while the frames are too few to tell.
    double relative() const;

private:
    std::vector<double> sums_of(const image::Picture& picture) const;
    int64_t frames_ = 0;
    std::vector<double> frame0_, sum_, squares_;  // of each block, its pixels added up
};

}  // namespace film
