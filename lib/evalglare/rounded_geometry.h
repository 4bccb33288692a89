// SPDX-License-Identifier: BSD-3-Clause
// Directions and solid angles rounded as evalglare's are (built without fused multiply-add), for -like evalglare only:
// whole-number centres and distances of 0 fall to one side or the other by the last bit.  glare::ViewGeometry is equal
// to 1e-9.
#pragma once
#include "glare/view_geometry.h"

namespace evalglare {
using base::Vec3;

class RoundedGeometry final : public glare::ViewGeometry {
public:
    explicit RoundedGeometry(const view::View& view);
    // Before the first position index, for solid angles and searches, and from then on: see again_.
    Vec3 line_of_sight() const override { return again_; }
    Vec3 direction(double X, double Y) const override;
    Vec3 seen_direction(double X, double Y) const override;
    // Quadrilateral of four great circles: sum of (pi - |acos(n_k . n_k+1)|) - 2 pi over the sides' normals; for the
    // pixel in the mirrored row, as evalglare has it (differs if -vl is not 0).  0 where a corner has no direction,
    // negative if impossible.
    std::vector<double> solid_angles(int width, int height) const override;
    double incidence(double cosine) const override { return cosine; }  // negative behind the eye
    // evalglare's literal for pi makes a right angle a little less than 90 degrees, so that what is level but for
    // rounding counts as above.
    view::EyeAngles eye_angles(Vec3 d, bool picture_up) const override;
    // The upper limit, 16, where rounding makes the angle not a number.
    double position_index(Vec3 d, view::PositionModel model) const override;
    double largest_cosine() const override { return 1; }  // such a pixel is outside even its own circle

private:
    bool to_direction(double X, double Y, Vec3 forward, Vec3& d) const;
    // Cosines of the angles sigma and tau of the position index; above 1 or not a number where evalglare's are.
    double sigma_cosine(Vec3 d) const;
    bool angle_undefined(Vec3 d) const;  // evalglare adds the products in two orders: one of the sums is above 1
    double tau_cosine(Vec3 d, double sigma) const;
    double solid_angle(int x, int y, int width, int height) const;

    view::View view_;
    // With the first position index, evalglare scales the view direction to length 1 a second time, and nothing else.
    Vec3 forward_, right_, up_, again_;
    Vec3 sky_;  // up, as long as the sine of the angle between -vd and -vu
    double across_, along_;
};

}  // namespace evalglare
