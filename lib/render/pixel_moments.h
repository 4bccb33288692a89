// SPDX-License-Identifier: BSD-3-Clause
// Moments of the light within each pixel (image/moments.h, docs/decisions/0033): the variance over the pixel of the
// direct and specular light that reaches the eye, without the noise of single samples.
//   A sample a of a pixel is L(x) + noise, x its place in the pixel.  A second sample b at the same place, with other
// random numbers for the rest of the path, has the same L(x) and independent noise, so the covariance of a and b over
// places is the variance of L (components of variance: Searle, Casella and McCulloch, "Variance Components", 1992,
// chapter 3).  Sources that are drawn by area add their exact part.
#pragma once
#include "image/moments.h"
#include "render/probes.h"

namespace render {

// Light drawn by area in a pixel, in grey (image/grey.h): the integrals of their luminance and of its square
// over the pixel, and the integral weighted by the position, in pixels from the centre.
struct DrawnLight {
    double sum = 0, squares = 0, right = 0, up = 0;
};

class PixelMoments {
public:
    PixelMoments(const Probes& probes, int nx, int ny);
    float* of(uint32_t pixel) { return &moments_[image::moment_numbers * size_t(pixel)]; }
    // Samples of n places, 3 floats each, and (or null) the second ones of the same places.
    void add_places(uint32_t pixel, const float* a, const float* b, uint32_t n);
    // mean: light that is not drawn, 3 a pixel.  drawn: by pixel, or empty.
    image::Moments finish(const std::vector<float>& mean, const std::vector<DrawnLight>& drawn);

private:
    // The sun is in few of the samples of a pixel (a curved surface mirrors it): k of them, each of luminance L, of n.
    struct Glint {
        double k = 0, L = 0, n = 0;
    };
    static Glint glint_of(double sum, double squares, double n);
    void add_glints();

    const Probes& probes_;
    int nx_, ny_;
    std::vector<float> moments_;
    std::vector<Glint> glints_;
};

}  // namespace render
