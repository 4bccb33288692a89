// SPDX-License-Identifier: BSD-3-Clause
// Directions and solid angles rounded as evalglare's are (built without fused multiply-add), for -like evalglare only:
// whole-number centres and distances of 0 fall to one side or the other by the last bit.  Everyone else uses
// view::Projector and Geometry, which are equal to 1e-9.
#pragma once
#include "view/view.h"

namespace glare {
using base::Vec3;

class EvalglareRays {
public:
    explicit EvalglareRays(const view::View& view);
    // Before the first position index, for solid angles and searches, and from then on: see again_.
    Vec3 forward() const { return forward_; }
    Vec3 line_of_sight() const { return again_; }
    // Cosines of the angles sigma and tau of the position index (position_index.h); above 1 or not a number where
    // evalglare's are.
    double sigma_cosine(Vec3 d) const;
    bool angle_undefined(Vec3 d) const;  // evalglare adds the products in two orders: one of the sums is above 1
    double tau_cosine(Vec3 d, double sigma) const;
    Vec3 sky() const { return sky_; }  // up, as long as the sine of the angle between -vd and -vu
    bool direction(double X, double Y, Vec3 forward, Vec3& d) const;
    // Quadrilateral of four great circles: sum of (pi - |acos(n_k . n_k+1)|) - 2 pi over the sides' normals; for the
    // pixel in the mirrored row, as evalglare has it.  0 where a corner has no direction, negative if impossible.
    double omega(int x, int y, int width, int height) const;

private:
    view::View view_;
    // With the first position index, evalglare scales the view direction to length 1 a second time, and nothing else.
    Vec3 forward_, right_, up_, again_, sky_;
    double across_, along_;
};

}  // namespace glare
