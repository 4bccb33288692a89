// SPDX-License-Identifier: BSD-3-Clause
// Directions, solid angles and runs of valid pixels of a view and size (geometry.h).
#include "glare/geometry.h"
#include "base/angle.h"
#include "view/density.h"
#include <algorithm>
#include <cmath>
#include <limits>

namespace glare {

using base::pi;

constexpr size_t most_kept = 1 << 16;  // pixels whose directions take no more memory than a picture of 360 x 360

Geometry::Geometry(std::unique_ptr<const ViewGeometry> rays, int w, int h)
    : width(w),
      height(h),
      projector(rays->projector),
      omega(rays->solid_angles(w, h)),
      omega_cos(size_t(w) * h),
      rays_(std::move(rays)),
      largest_cosine_(rays_->largest_cosine()) {
    const bool keeps = omega.size() <= most_kept;
    std::vector<Vec3> kept(keeps ? omega.size() : 0);
    in_rows(h, [&, forward = line_of_sight()](int first, int end) {
        for (size_t i = size_t(first) * w; i < size_t(end) * w; ++i) {
            const Vec3 d = direction(i);
            if (keeps) kept[i] = d;
            if (!(omega[i] > 0)) continue;
            const double c = dot(forward, d);
            if (dot(d, d) == 0) omega[i] = 0;
            else if (projector.view().type == 'a' && c < 0) omega[i] = -omega[i];
            else omega_cos[i] = omega[i] * rays_->incidence(c);
        }
    });
    if (keeps) directions_ = std::make_shared<const std::vector<Vec3>>(std::move(kept));
    find_spans();
}

std::vector<DrawnPixel> Geometry::drawn_pixels(const image::Moments& moments) const {
    std::vector<DrawnPixel> out;
    for (size_t i = 0; i < omega.size() && moments; ++i) {
        const float* const m = &(*moments)[image::moment_numbers * i];
        const double right = m[image::moment_right], up = m[image::moment_up];
        if (right == 0 && up == 0) continue;
        const double X = (x_of(i) + .5 + right) / width, Y = (y_of(i) + .5 + up) / height;
        const double size = view::solid_angle_density(projector, X, Y) / (double(width) * height);
        const double c = dot(line_of_sight(), rays_->direction(X, Y));
        const bool in_view = c >= 0 || (projector.view().type != 'a' && valid(i));
        out.push_back({uint32_t(i), in_view ? size : 0, size * std::max(c, 0.0)});
    }
    return out;
}

Geometry Geometry::with(const std::vector<DrawnPixel>& pixels) const {
    Geometry out = *this;
    for (const DrawnPixel& p : pixels) out.omega[p.pixel] = p.omega, out.omega_cos[p.pixel] = p.omega_cos;
    out.spans.clear(), out.row_spans.clear();
    out.omega_sum = 0, out.valid_count = 0;
    out.find_spans();
    return out;
}

void Geometry::find_spans() {
    for (int r = 0; r < height; ++r) {
        row_spans.push_back(spans.size());
        const double* row = &omega[size_t(r) * width];
        for (int x = 0; x < width; ++x) {
            if (!(row[x] > 0)) continue;
            const int begin = x;
            double sum = 0;
            for (; x < width && row[x] > 0; ++x) sum += row[x];
            omega_sum += sum;
            valid_count += x - begin;
            spans.push_back({begin, x});
        }
    }
    row_spans.push_back(spans.size());
}

// Largest stretch of each projection, angle per length in the picture plane: perspective, cylinder and planispheric at
// the centre, angular at 90 degrees (theta / sin theta = pi/2).
double Geometry::pitch_bound() const {
    const view::View& v = projector.view();
    const double vh = v.vh * pi / 180, vv = v.vv * pi / 180;
    switch (v.type) {
    case 'v': return 2 * std::max(std::tan(vh / 2) / width, std::tan(vv / 2) / height);
    case 'a': return pi / 2 * std::max(vh / width, vv / height);
    case 's': return 4 * std::max(std::tan(vh / 4) / width, std::tan(vv / 4) / height);
    case 'c': return std::max(vh / width, 2 * std::tan(vv / 2) / height);
    default: return std::numeric_limits<double>::infinity();
    }
}

double Geometry::share_of_light() const {
    double sum = 0;
    for (const double each : omega_cos) sum += each;
    return sum / base::pi;
}

}  // namespace glare
