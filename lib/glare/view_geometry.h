// SPDX-License-Identifier: BSD-3-Clause
// Geometry of a view's pixels: directions, solid angles, angles to the line of sight.  This is luxpipe's own method;
// lib/evalglare overrides it.
#pragma once
#include <functional>
#include <limits>
#include <vector>
#include "view/position_index.h"
#include "view/view.h"

namespace glare {
using base::Vec3;
using view::EyeAngles;
using view::PositionModel;

class ViewGeometry {
public:
    explicit ViewGeometry(const view::View& view) : projector(view) {}
    virtual ~ViewGeometry() = default;

    const view::Projector projector;

    virtual Vec3 line_of_sight() const { return projector.forward(); }
    // Direction at a point of the picture, 0..1 from the left and from the bottom; (0,0,0) if none.
    virtual Vec3 direction(double X, double Y) const;
    // The same, for angles to the line of sight.
    virtual Vec3 seen_direction(double X, double Y) const { return direction(X, Y); }
    // Solid angles of all pixels, sr, row 0 = top; 0 if a corner has no direction.
    virtual std::vector<double> solid_angles(int width, int height) const;
    // Cosine of the angle of incidence at the eye, from the cosine to the line of sight.
    virtual double incidence(double cosine) const { return cosine > 0 ? cosine : 0; }
    virtual EyeAngles eye_angles(Vec3 d, bool picture_up) const { return view::eye_angles(projector, d, picture_up); }
    virtual double position_index(Vec3 d, PositionModel model) const {
        return view::position_index(eye_angles(d, model == PositionModel::accelerad), projector, d, model);
    }
    // Dot products above this, which rounding makes, correspond to no angle.
    virtual double largest_cosine() const { return std::numeric_limits<double>::infinity(); }
};

// Calls work(first, end) for all rows of a picture, on several threads if there are many.
void in_rows(int height, const std::function<void(int first, int end)>& work);

}  // namespace glare
