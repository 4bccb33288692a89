// SPDX-License-Identifier: BSD-3-Clause
// Quantities that depend on view and size only, calculated once per stream: directions, solid angles and valid pixels.
// A pixel is valid if its centre has a direction, its solid angle (great-circle quadrilateral through the four corners)
// is above 0 and, for type a, it is not behind the eye.  Types c and s keep pixels behind the eye, with cosine 0.
#pragma once
#include <memory>
#include <vector>
#include "glare/view_geometry.h"
#include "image/moments.h"

namespace glare {

// A pixel that a source was drawn in (image/moments.h), with solid angle and incidence at the place of its light.
struct DrawnPixel {
    uint32_t pixel;
    double omega, omega_cos;
};

struct Span {
    int begin, end;
};

class Geometry {
public:
    Geometry(const view::View& view, int w, int h) : Geometry(std::make_unique<ViewGeometry>(view), w, h) {}
    Geometry(std::unique_ptr<const ViewGeometry> rays, int w, int h);

    // Drawn pixels of a picture, and the geometry in which they lie at the place of their light.  Light behind the eye
    // is out of view, as are pixels whose centre is.
    std::vector<DrawnPixel> drawn_pixels(const image::Moments& moments) const;
    Geometry with(const std::vector<DrawnPixel>& pixels) const;

    int width, height;
    view::Projector projector;
    std::vector<double> omega;      // sr, row 0 = top; 0 or less: the pixel is invalid (its size is |omega|)
    std::vector<double> omega_cos;  // omega times the cosine of incidence at the eye; 0 for invalid pixels
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
    const ViewGeometry& rays() const { return *rays_; }
    Vec3 direction(int x, int y) const { return rays_->direction((x + 0.5) / width, (y + 0.5) / height); }
    Vec3 direction(size_t i) const { return directions_ ? (*directions_)[i] : direction(x_of(i), y_of(i)); }
    Vec3 line_of_sight() const { return rays_->line_of_sight(); }
    // For angles to the line of sight.
    Vec3 seen_direction(int x, int y) const { return rays_->seen_direction((x + 0.5) / width, (y + 0.5) / height); }
    Vec3 seen_direction(size_t i) const { return seen_direction(x_of(i), y_of(i)); }
    // Returns true if an angle of this cosine is at most the angle of cosine `limit`.
    bool inside(double cosine, double limit) const { return cosine >= limit && cosine <= largest_cosine_; }
    double pitch_bound() const;     // no two valid side-by-side pixels are farther apart (radians; inf for type h)
    double share_of_light() const;  // fraction of the light at the eye, for a uniform luminance
    bool fits(const view::View& view, int w, int h) const {
        return w == width && h == height && view == projector.view();
    }

private:
    void find_spans();
    std::shared_ptr<const ViewGeometry> rays_;
    std::shared_ptr<const std::vector<Vec3>> directions_;  // of all pixels; null: they are too many to be kept
    double largest_cosine_;
};

using view::evalglare_deg;
using view::evalglare_pi;

}  // namespace glare
