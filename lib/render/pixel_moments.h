// SPDX-License-Identifier: BSD-3-Clause
// Moments of the light within each pixel (image/picture.h, docs/decisions/0033): the variance over the pixel of the
// direct and specular light that reaches the eye, without the noise of single samples.
//   A sample a of a pixel is L(x) + noise, x its place in the pixel.  A second sample b at the same place, with other
// random numbers for the rest of the path, has the same L(x) and independent noise.  The covariance of a and b over
// places is the variance of L (components of variance: Searle, Casella and McCulloch, "Variance Components", 1992,
// chapter 3).  Pairs are drawn where the samples of frame 0 differ; no frame contains them.  Splatted emitters add
// their exact part.
#pragma once
#include <functional>
#include <vector>
#include "render/frame_zero.h"

namespace render {

// Number of places in each pixel at which pairs are drawn, 0: none.  Pixels that hold much of the light have more, and
// those of small pictures, where samples cost little.
// fewer: so many times.
std::vector<uint32_t> places_of_pixels(const FrameZero& zero, int nx, int ny, uint32_t fewer = 1);
// Samples of n places of each of some pixels, consecutive: both of a place, grey.
struct Pairs {
    std::vector<double> a, b;
};
using PairsOf = std::function<Pairs(const std::vector<uint32_t>& pixels, uint32_t n)>;
image::Moments moments_of(const FrameZero& zero, int nx, int ny, const std::vector<uint32_t>& places,
                          const PairsOf& pairs_of);
image::Moments pixel_moments(device::Device& device, const ViewPlan& plan, const FrameZero& zero);

}  // namespace render
