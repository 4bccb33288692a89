// SPDX-License-Identifier: BSD-3-Clause
// See sun_images.h.
#include "render/sun_images.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "flatten/pack.h"
#include "kernels/dialect/host.h"
#include "render/picture_place.h"
#include "render/image_tracer.h"

namespace render {
using namespace kernels;
using base::Vec3;
using flatten::bits;

namespace {

constexpr size_t MOST_PAIRED = 64;     // planes tried for two reflections
constexpr size_t MOST_TRIED = 1024;    // discs traced before the list is made
constexpr uint32_t TRIED_POINTS = 64;  // of each of them
constexpr uint32_t SEEN_POINTS = 256;  // of the image of an hour's sun
constexpr uint32_t MOST_WAYS = 16;     // at four surfaces a path can go two ways; at more, by random numbers
constexpr uint32_t LEAST_POINTS = 256, MOST_POINTS = 4096;  // of each disc drawn
constexpr uint32_t ENOUGH_RAYS = 1u << 18;                  // of all
constexpr int LAYERS = 32;                                  // surfaces before the first that reflects

Vec3 point_of_disc(const SunImages::Disc& disc, double x, double y) {
    const Vec3 a = unit(cross(disc.dir, std::fabs(disc.dir.x) < .5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0})),
               b = cross(disc.dir, a);
    const double z = 1 - x * disc.cap, r = std::sqrt(std::max(0.0, 1 - z * z)), turn = 2 * M_PI * y;
    return unit(disc.dir * z + a * (r * std::cos(turn)) + b * (r * std::sin(turn)));
}

bool is_in(const SunImages::Disc& disc, Vec3 dir) {
    const Vec3 e = dir - disc.dir;
    return dot(e, e) / 2 <= disc.cap;
}

Vec3 mirrored(Vec3 v, Vec3 n) { return v - n * (2 * dot(v, n)); }

// The surface that the eye sees along a direction, behind those that let light through.
class Look {
public:
    Look(const flatten::HostTracer& tracer, Vec3 eye) : tracer_(tracer), eye_(eye) {}

    // Does a part of the disc show a surface of this normal?
    bool shows_plane(const SunImages::Disc& disc, Vec3 normal) const {
        for (uint32_t k = 0; k < 9; k++) {
            const double radius2 = k == 0 ? 0 : k % 2 == 0 ? .25 : .9;
            if (place_on_plane(point_of_disc(disc, radius2, k / 8.0), normal)) return true;
        }
        return false;
    }

    // One that the sun lights?
    bool shows_sun(const SunImages::Disc& disc, Vec3 normal) const {
        for (uint32_t k = 0; k < SEEN_POINTS; k++) {
            const Vec3 dir = point_of_disc(disc, unit_step(k, first_step), unit_step(k, second_step));
            const auto place = place_on_plane(dir, normal);
            if (place && !is_hidden(*place, mirrored(dir, normal))) return true;
        }
        return false;
    }

private:
    using T = flatten::HostTracer;

    bool is_hidden(Vec3 place, Vec3 to_sun) const {
        const double off = 1e-5 * (1 + std::sqrt(dot(place - eye_, place - eye_)));
        return tracer_.blocked(place, to_sun, off, 1e30, T::opaque);
    }

    std::optional<Vec3> place_on_plane(Vec3 dir, Vec3 normal) const {
        const double same = 1 - 4 * sampling::same_plane_rad * sampling::same_plane_rad;
        const auto is_plane = [&](const T::Found& f) { return std::fabs(dot(f.normal, normal)) > same; };
        const T::Found wall = tracer_.closest(eye_, dir, 0, 1e30, T::opaque);
        if (wall.t >= 0 && is_plane(wall)) return eye_ + dir * wall.t;
        double from = 0;
        const double to = wall.t < 0 ? 1e30 : wall.t;
        for (int i = 0; i < LAYERS && from < to; i++) {
            const T::Found pane = tracer_.closest(eye_, dir, from, to, T::transparent);
            if (pane.t < 0) return {};
            if (is_plane(pane)) return eye_ + dir * pane.t;
            from = pane.t * (1 + 1e-5) + 1e-6;
        }
        return {};
    }

    const flatten::HostTracer& tracer_;
    Vec3 eye_;
};

// Smaller than a few pixels, and in the picture.
bool is_drawable(const SunImages::Disc& disc, const view::Projector& projector, int nx, int ny) {
    const auto place = place_of(projector, disc.dir, nx, ny, true);
    const double w = 2 * M_PI * disc.cap;
    if (!place || w / place->sr * nx * ny > LARGEST_DRAWN) return false;
    const double reach = 2 * std::sqrt(w / place->sr);  // beyond the rim no part of the disc is in the picture
    return std::fabs(place->X - .5) <= .5 + reach && std::fabs(place->Y - .5) <= .5 + reach;
}

}  // namespace

SunImages possible_images(const flatten::FlatScene& scene, const flatten::HostTracer& tracer,
                          const sampling::SmoothSurfaces& smooth, const view::View& view, int nx, int ny) {
    SunImages out;
    if (view.type == 'l') return out;  // all camera directions are one
    const std::vector<Vec3>& planes = smooth.planes;
    const view::Projector projector(view);
    const Look look(tracer, view.vp);
    const auto try_disc = [&](Vec3 dir, double radius, const Vec3* plane) {
        const SunImages::Disc disc{dir, 1 - std::cos(radius)};
        if (out.discs.size() >= MOST_TRIED || !is_drawable(disc, projector, nx, ny)) return false;
        if (plane && !look.shows_plane(disc, *plane)) return false;
        out.discs.push_back(disc);
        return true;
    };
    for (uint32_t i = 0; i < scene.sources.size() && !smooth.none(); i++) {
        const Source& q = scene.sources[i];
        if (q.kind != SK_DISTANT || q.max_radius > 0) continue;
        if (q.light_type == M_ILLUM || q.relay != NONE) continue;
        const Vec3 sun = unit(flatten::vec_of(q.centre));
        const double radius = std::acos(1 - double(q.cap)), more = 2 * sampling::same_plane_rad;
        bool any = try_disc(sun, radius + more, nullptr);
        for (const Vec3& n : planes) any = try_disc(mirrored(sun, n), radius + more, &n) || any;
        const size_t paired = std::min(planes.size(), MOST_PAIRED);
        for (size_t a = 0; a < paired; a++)
            for (size_t b = 0; b < paired; b++)
                if (a != b) {
                    const Vec3 dir = mirrored(mirrored(sun, planes[b]), planes[a]);
                    any = try_disc(dir, radius + 2 * more, &planes[a]) || any;
                }
        if (any || smooth.curved) out.sources.push_back(i);
    }
    return out;
}

bool shows_image(const flatten::HostTracer& tracer, const sampling::SmoothSurfaces& smooth, const view::View& view,
                 int nx, int ny, Vec3 sun, double radius) {
    if (view.type == 'l') return false;
    const view::Projector projector(view);
    const Look look(tracer, view.vp);
    const double cap = 1 - std::cos(radius + 2 * sampling::same_plane_rad);
    for (size_t i = 0; i < smooth.planes.size() && i < MOST_PAIRED; i++) {
        const Vec3& n = smooth.planes[i];
        const SunImages::Disc disc{mirrored(sun, n), cap};
        if (is_drawable(disc, projector, nx, ny) && look.shows_plane(disc, n) && look.shows_sun(disc, n)) return true;
    }
    return false;
}

void keep_lit_images(device::Device& device, const device::Params& base, const view::View& view, SunImages& images) {
    ImageTracer tracer(device, base, view, MOST_WAYS);
    std::vector<size_t> disc_of;
    for (size_t i = 0; i < images.discs.size(); i++)
        for (uint32_t k = 0; k < TRIED_POINTS; k++) {
            const Vec3 dir = point_of_disc(images.discs[i], unit_step(k, first_step), unit_step(k, second_step));
            const auto place = place_of(tracer.projector(), dir, int(base.nx), int(base.ny));
            if (!place) continue;
            tracer.add(*place);
            disc_of.push_back(i);
        }
    tracer.run(0);

    struct Lit {
        double light = 0;
        SunImages::Disc disc;
    };
    std::vector<Lit> lit;
    for (const SunImages::Disc& disc : images.discs) lit.push_back({0, disc});
    images.ways = 1;
    for (size_t k = 0; k < disc_of.size(); k++) {
        float rgb[3];
        tracer.mean(k, rgb);
        const double light = double(rgb[0]) + double(rgb[1]) + double(rgb[2]);
        if (!(light > 0)) continue;
        lit[disc_of[k]].light += light * light;
        images.ways = std::max(images.ways, tracer.ways_needed(k));
    }
    std::stable_sort(lit.begin(), lit.end(), [](const Lit& a, const Lit& b) { return a.light > b.light; });
    images.discs.clear();
    for (const Lit& l : lit)
        if (l.light > 0 && images.discs.size() < MOST_IMAGES) images.discs.push_back(l.disc);
}

std::vector<ImagePoint> draw_images(device::Device& device, const device::Params& base, const view::View& view,
                                    const SunImages& images) {
    std::vector<ImagePoint> out;
    if (images.discs.empty()) return out;
    ImageTracer tracer(device, base, view, images.ways);
    const uint32_t points =
        std::clamp(ENOUGH_RAYS / uint32_t(2 * images.ways * images.discs.size()), LEAST_POINTS, MOST_POINTS);
    for (size_t i = 0; i < images.discs.size(); i++)
        for (uint32_t k = 0; k < points; k++) {
            const SunImages::Disc& disc = images.discs[i];
            const Vec3 dir = point_of_disc(disc, unit_step(k, first_step), unit_step(k, second_step));
            const auto before = images.discs.begin() + long(i);
            if (std::any_of(images.discs.begin(), before, [&](const auto& d) { return is_in(d, dir); })) continue;
            const auto place = place_of(tracer.projector(), dir, int(base.nx), int(base.ny));
            if (!place) continue;
            tracer.add(*place);
            const double weight = 2 * M_PI * disc.cap / points / place->sr * base.nx * base.ny;
            out.push_back({place->pixel, place->right, place->up, float(weight), {}, {}});
        }
    for (const bool first : {true, false}) {
        tracer.run(first ? 1 : 2);
        for (size_t k = 0; k < out.size(); k++) tracer.mean(k, first ? out[k].first : out[k].second);
    }
    return out;
}

}  // namespace render
