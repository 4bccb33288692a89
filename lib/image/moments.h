// SPDX-License-Identifier: BSD-3-Clause
// Moments of the light inside a pixel: its variance, and the place of drawn sources (docs/decisions/0033).
#pragma once
#include <cstddef>
#include <memory>
#include <vector>

namespace image {

// Numbers of a pixel.
constexpr size_t moment_numbers = 4;
constexpr size_t moment_variance = 0;    // of grey (grey.h) over the pixel, (W/(sr m2))^2
constexpr size_t moment_difference = 1;  // half the difference between two independent estimates of it
constexpr size_t moment_right = 2;       // centroid of the drawn sources from its centre, in pixels; 0: none
constexpr size_t moment_up = 3;
// moment_numbers of each pixel, row 0 = top; the moments of frame 0 belong to all sums that contain it.
using Moments = std::shared_ptr<const std::vector<float>>;
// Sets numbers that are not finite or too large, and variances below 0, to 0.
void clean_moments(std::vector<float>& moments);

struct Picture;

// Sums that follow in a stream have the moments of the first one.
class CarriedMoments {
public:
    CarriedMoments();
    ~CarriedMoments();
    void pass(Picture& picture);  // the next one of the stream

private:
    std::unique_ptr<Picture> first_;  // which had them, without its pixels
};

}  // namespace image
