// SPDX-License-Identifier: BSD-3-Clause
// Directions and solid angles rounded as evalglare's are (built without fused multiply-add), for -like evalglare only:
// whole-number centres and distances of 0 fall to one side or the other by the last bit.  Everyone else uses
// view::Projector and Geometry, which are equal to 1e-9.
#pragma once
#include "view/view.h"

namespace comfort {
using base::Vec3;

class EvalglareRays {
public:
    explicit EvalglareRays(const view::View& view);
    Vec3 forward() const { return forward_; }
    bool direction(double X, double Y, Vec3& d) const;
    // Quadrilateral of four great circles: sum of (pi - |acos(n_k . n_k+1)|) - 2 pi over the sides' normals; for the
    // pixel in the mirrored row, as evalglare has it.  0 where a corner has no direction, negative if impossible.
    double omega(int x, int y, int width, int height) const;

private:
    view::View view_;
    Vec3 forward_, right_, up_;
    double across_, along_;
};

}  // namespace comfort
