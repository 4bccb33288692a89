// SPDX-License-Identifier: BSD-3-Clause
// What depends on view and size only, worked out once and kept for all pictures of a stream:
// directions, solid angles, and which pixels count.
// A pixel is valid if its centre has a direction, its solid angle (great-circle quadrilateral through the four
// corners) is above 0 and, for type a, it is not behind the eye.  Types c and s that look behind keep those pixels
// with cosine 0 (evalglare: negative cosines).
#pragma once
#include <optional>
#include <vector>
#include "glare/evalglare_geometry.h"
#include "view/position_index.h"
#include "view/view.h"

namespace glare {
using base::Vec3;

struct Span {
    int begin, end;
};

// Sums over pixels: grey times omega cos, and grey times omega.
struct Light {
    double eye = 0, all = 0;
};

class Geometry {
public:
    // evalglare_slips: directions and solid angles as evalglare rounds them, the solid angle that of the pixel in the
    // opposite row (differs if vl is not 0), and negative cosines behind the eye.
    Geometry(const view::View& view, int width, int height, bool evalglare_slips = false);

    int width, height;
    view::Projector projector;
    std::vector<double> omega;      // sr, row 0 = top; negative or 0: the pixel does not count (its size is |omega|)
    std::vector<double> omega_cos;  // omega * cos(angle from the view direction); 0 where the pixel does not count
    std::vector<Span> spans;        // runs of valid pixels, row after row from the top
    std::vector<size_t> row_spans;  // spans of row r: row_spans[r] .. row_spans[r+1]-1
    double omega_sum = 0;           // of valid pixels
    long valid_count = 0;

    bool valid(size_t i) const { return omega[i] > 0; }
    Span extent(int row) const {  // from the first valid pixel to the last one
        const bool any = row_spans[row] < row_spans[row + 1];
        return any ? Span{spans[row_spans[row]].begin, spans[row_spans[row + 1] - 1].end} : Span{0, 0};
    }
    size_t index(int x, int y) const { return size_t(height - 1 - y) * width + x; }  // y from the bottom
    int x_of(size_t i) const { return int(i % width); }
    int y_of(size_t i) const { return height - 1 - int(i / width); }
    Vec3 direction(int x, int y) const;  // (0,0,0) if none
    Vec3 direction(size_t i) const { return direction(x_of(i), y_of(i)); }
    Vec3 line_of_sight() const;
    // The same, to the last bit with evalglare's slips, for angles to the line of sight.
    Vec3 seen_direction(int x, int y) const;
    Vec3 seen_direction(size_t i) const { return seen_direction(x_of(i), y_of(i)); }
    const EvalglareRays* slips() const { return slips_ ? &*slips_ : nullptr; }
    // With evalglare's slips: the angle to the line of sight is not a number, since rounding carried its cosine
    // above 1.
    bool angle_undefined(Vec3 d) const { return slips_ && slips_->angle_undefined(d); }
    double pitch_bound() const;     // no two valid side-by-side pixels are farther apart (radians; inf for type h)
    double share_of_light() const;  // of the light that reaches the eye, if all directions are as bright
    bool fits(const view::View& view, int w, int h) const {
        return w == width && h == height && view == projector.view();
    }

private:
    void solid_angles();
    void find_spans();
    std::optional<EvalglareRays> slips_;
};

using view::evalglare_deg;
using view::evalglare_pi;

}  // namespace glare
