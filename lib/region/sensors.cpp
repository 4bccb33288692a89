// SPDX-License-Identifier: BSD-3-Clause
// See sensors.h.
#include "region/sensors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "region/queries.h"
#include "region/upper_faces.h"

namespace region {
namespace {

using Corners = std::vector<Vec3>;
constexpr double flat = 1e-4;  // of a face's size: in the same plane

// Faces of one plane, with axes along and across the longest edge of the first one.
struct Plane {
    Vec3 normal, right, up;
    double height = 0, size = 0;  // normal . corner; length of the longest edge
    std::vector<Corners> faces;
};

Plane plane_of(const Corners& corners) {
    Plane out;
    out.normal = base::unit(area_of(corners));
    Vec3 edge;
    for (size_t i = 0; i < corners.size(); ++i)
        if (const Vec3 e = corners[(i + 1) % corners.size()] - corners[i]; base::length(e) > out.size)
            out.size = base::length(e), edge = base::unit(e);
    const Vec3 across = cross(out.normal, edge);
    // rows from the left to the right, as seen with +z or +y up
    const Vec3 level = std::fabs(out.normal.z) > .9 ? Vec3{1, 0, 0} : base::unit(cross({0, 0, 1}, out.normal));
    for (const Vec3 axis : {edge, -edge, across, -across})
        if (dot(axis, level) > dot(out.right, level)) out.right = axis;
    out.up = cross(out.normal, out.right);
    out.height = dot(out.normal, corners[0]);
    out.faces = {corners};
    return out;
}

// Even-odd, so that seams cut holes.
bool contains(const Plane& plane, const Corners& corners, Vec3 p) {
    const double x = dot(p, plane.right), y = dot(p, plane.up);
    bool in = false;
    for (size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
        const double xi = dot(corners[i], plane.right), yi = dot(corners[i], plane.up),
                     xj = dot(corners[j], plane.right), yj = dot(corners[j], plane.up);
        if ((yi > y) != (yj > y) && x < xi + (y - yi) / (yj - yi) * (xj - xi)) in = !in;
    }
    return in;
}

bool contains(const Plane& plane, Vec3 p) {
    return std::any_of(plane.faces.begin(), plane.faces.end(),
                       [&](const Corners& face) { return contains(plane, face, p); });
}

void add_plane(std::vector<Plane>& planes, const Plane& more) {
    for (Plane& p : planes)
        if (base::length(p.normal - more.normal) < flat && std::fabs(p.height - more.height) < flat * p.size) {
            p.faces.insert(p.faces.end(), more.faces.begin(), more.faces.end());
            return;
        }
    planes.push_back(more);
}

// A horizontal face looks up: Honeybee's floors have their corners from outside, and polygon3d has no side.
void add_face(std::vector<Plane>& planes, Corners corners) {
    const Vec3 area = area_of(corners);
    if (area.z < -.99 * base::length(area)) std::reverse(corners.begin(), corners.end());
    if (base::length(area) > 0) add_plane(planes, plane_of(corners));
}

Corners corners_of(const std::vector<double>& n) {
    Corners out;
    for (size_t i = 0; i + 2 < n.size(); i += 3) out.push_back({n[i], n[i + 1], n[i + 2]});
    return out;
}

bool in_volume(const Shape& s, Vec3 p) {
    const std::vector<double>& n = s.numbers;
    const Vec3 a{n[0], n[1], n[2]};
    if (s.kind == Kind::sphere3d) return base::length(p - a) <= n[3];
    for (int k = 0; k < 3; ++k)
        if (p[k] < std::min(n[size_t(k)], n[size_t(k) + 3]) || p[k] > std::max(n[size_t(k)], n[size_t(k) + 3]))
            return false;
    return true;
}

class Sensors {
public:
    Sensors(const Regions& regions, const SceneView* scene) : in_(regions), planes_(regions.shapes.size()) {
        const auto meant = scene ? meant_surfaces(regions, *scene) : std::vector<std::vector<char>>{};
        for (size_t s = 0; s < regions.shapes.size(); ++s) lay(regions.shapes[s], s, meant, scene);
    }
    std::vector<image::Point> points(int root, double spacing, double height) const {
        std::vector<image::Point> out;
        for (const Plane& plane : planes_below(root)) add(plane, root, spacing, height, out);
        return out;
    }

private:
    const Regions& in_;
    std::vector<std::vector<Plane>> planes_;  // by shape

    void lay(const Shape& shape, size_t s, const std::vector<std::vector<char>>& meant, const SceneView* scene) {
        Corners own;
        const std::vector<double>& n = shape.numbers;
        switch (shape.kind) {
        case Kind::box3d:
        case Kind::sphere3d: return;
        case Kind::polygon3d: own = corners_of(n); break;
        case Kind::disc3d: own = ring_corners({n[0], n[1], n[2]}, {n[3], n[4], n[5]}, 0, n[6]); break;
        case Kind::surface:
        case Kind::modifier:
            if (!scene) base::fail(shape.place, "asks for surfaces of a scene; name its files behind the region file");
            lay_faces(shape, faces_of(meant[s], *scene), planes_[s]);
            if (planes_[s].empty())
                base::fail(shape.place, "\"" + shape.text + "\" has no polygon and no ring for points to lie on");
            return;
        default: base::fail(shape.place, "needs a view; points lie on polygon3d, disc3d, surface and modifier");
        }
        add_face(planes_[s], own);
    }

    static std::vector<Corners> faces_of(const std::vector<char>& meant, const SceneView& scene) {
        std::vector<Corners> faces;
        for (unsigned k = 0; k < scene.surfaces(); ++k)
            if (meant[k])
                if (Corners face = scene.face(k); !face.empty()) faces.push_back(std::move(face));
        return faces;
    }
    static void lay_faces(const Shape& shape, const std::vector<Corners>& faces, std::vector<Plane>& planes) {
        const std::vector<Corners> upper = upper_faces(faces);
        if (upper.size() < faces.size())
            base::warn(shape.place,
                       fmt::format("\"{}\" has points on its upper faces alone; {} of {} faces stand upright "
                                   "or close a body from below",
                                   shape.text, faces.size() - upper.size(), faces.size()));
        for (const Corners& face : upper) add_face(planes, face);
    }

    bool inside(int node, Vec3 p) const {
        const Node& n = in_.nodes[size_t(node)];
        switch (n.op) {
        case '!': return !inside(n.a, p);
        case '+': return inside(n.a, p) || inside(n.b, p);
        case '-': return inside(n.a, p) && !inside(n.b, p);
        case '&': return inside(n.a, p) && inside(n.b, p);
        default: break;
        }
        const Shape& shape = in_.shapes[size_t(n.a)];
        if (shape.kind == Kind::box3d || shape.kind == Kind::sphere3d) return in_volume(shape, p);
        const std::vector<Plane>& planes = planes_[size_t(n.a)];
        return std::any_of(planes.begin(), planes.end(), [&](const Plane& plane) { return contains(plane, p); }) &&
               (shape.within < 0 || in_volume(in_.shapes[size_t(shape.within)], p));
    }

    // Of all shapes that are not taken away; of an intersection those of the first part that has some.
    std::vector<Plane> planes_below(int node) const {
        const Node& n = in_.nodes[size_t(node)];
        if (n.op == 's') return planes_[size_t(n.a)];
        if (n.op == '!') return {};
        std::vector<Plane> out = planes_below(n.a);
        if (n.op == '+' || (n.op == '&' && out.empty()))
            for (const Plane& plane : planes_below(n.b)) add_plane(out, plane);
        return out;
    }
    void add(const Plane& plane, int root, double spacing, double height, std::vector<image::Point>& out) const {
        double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
        for (const Corners& face : plane.faces)
            for (const Vec3 c : face)
                for (int k = 0; k < 2; ++k) {
                    const double v = dot(c, k ? plane.up : plane.right);
                    low[k] = std::min(low[k], v), high[k] = std::max(high[k], v);
                }
        double count[2];
        for (int k = 0; k < 2; ++k) count[k] = std::max(1., std::floor((high[k] - low[k]) / spacing + 1e-6));
        if (count[0] * count[1] > double(image::most_points))
            base::fail("-spacing", fmt::format("makes more than {} points", image::most_points));
        const auto at = [&](int k, int i) { return (low[k] + high[k]) / 2 + (i - (count[k] - 1) / 2) * spacing; };
        for (int j = 0; j < int(count[1]); ++j)
            for (int i = 0; i < int(count[0]); ++i) {
                const Vec3 p = at(0, i) * plane.right + at(1, j) * plane.up + plane.height * plane.normal;
                if (contains(plane, p) && inside(root, p))
                    out.push_back({p + height * plane.normal, height < 0 ? -plane.normal : plane.normal});
            }
    }
};

}  // namespace

std::vector<Vec3> ring_corners(Vec3 centre, Vec3 normal, double inner, double outer) {
    constexpr int sides = 64;
    const Vec3 n = base::unit(normal), level = std::fabs(n.z) < .9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
    const Vec3 a = base::unit(cross(level, n)), b = cross(n, a);
    Corners out;
    for (int i = 0; i <= 2 * sides + 1; ++i) {  // a seam joins the outer to the inner circle
        const double turn = 2 * M_PI * (i <= sides ? i : 2 * sides + 1 - i) / sides, r = i <= sides ? outer : inner;
        out.push_back(centre + r * (std::cos(turn) * a + std::sin(turn) * b));
    }
    return out;
}

std::vector<image::Point> sensors_of(const Regions& regions, size_t k, double spacing, double height,
                                     const SceneView* scene) {
    const Regions one = only(regions, k);
    std::vector<image::Point> out = Sensors(one, scene).points(one.regions[0].root, spacing, height);
    if (out.empty())
        base::fail(one.regions[0].place,
                   fmt::format("region \"{}\" has no point at a spacing of {:g}", one.regions[0].name, spacing));
    return out;
}

}  // namespace region
