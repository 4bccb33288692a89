// SPDX-License-Identifier: BSD-3-Clause
// See skies.h.
#include "scene/skies.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/angle.h"
#include "base/error.h"
#include "scene/materials.h"

namespace scene {
namespace {

constexpr double sky_deg = 5, touching_deg = 1;
constexpr const char* allowed = "; -second-sky allows it";

struct FarLight {
    const Object* object;
    base::Vec3 direction;
    double width_deg;
    bool is_sky() const { return width_deg > sky_deg; }
};

// From this object on; black ones and lamps are left out.
std::vector<FarLight> far_lights(const Scene& scene, size_t first) {
    constexpr double least_glow_wm2 = 1;
    std::vector<FarLight> all;
    for (size_t i = first; i < scene.objects.size(); ++i) {
        const Object& o = scene.objects[i];
        if (o.type != Type::source || o.modifier < 0) continue;
        const int32_t m = scene.material(o.modifier).object;
        if (m == VOID || !is_emissive(scene.objects[m].type)) continue;
        const Span<double> rgb = scene.reals(scene.objects[m]), r = scene.reals(o);
        const double brightest = std::max({rgb[0], rgb[1], rgb[2]}), width_deg = std::min(r[3], 360.);
        if (brightest <= 0) continue;
        const FarLight light{&o, unit(base::Vec3{r[0], r[1], r[2]}), width_deg};
        const double wm2 = 2 * base::pi * (1 - std::cos(width_deg / 2 * base::degree)) * brightest;
        if (light.is_sky() || scene.objects[m].type != Type::glow || wm2 >= least_glow_wm2) all.push_back(light);
    }
    return all;
}

bool overlap(const FarLight& a, const FarLight& b) {
    const double apart_deg = std::acos(std::clamp(dot(a.direction, b.direction), -1., 1.)) / base::degree;
    return apart_deg < (a.width_deg + b.width_deg) / 2 - touching_deg;
}

// source "sun" of a.rad:14
std::string named(const Scene& scene, const FarLight& l) { return "source \"" + scene.name(*l.object) + "\""; }
std::string placed(const Scene& scene, const FarLight& l) { return named(scene, l) + " of " + scene.place(*l.object); }

}  // namespace

void require_no_sky(const Scene& scene) {
    for (const FarLight& l : far_lights(scene, 0))
        base::fail(scene.place(*l.object), named(scene, l) + " is a " + (l.is_sky() ? "sky" : "sun") +
                                               " beside that of the weather file" + allowed);
}

void require_one_sky(const Scene& scene, size_t first) {
    const std::vector<FarLight> all = far_lights(scene, 0);
    for (const FarLight& l : all) {
        if (l.object < &scene.objects[0] + first) continue;
        for (const FarLight& other : all) {
            if (other.object >= &scene.objects[0] + first || l.is_sky() != other.is_sky()) continue;
            if (l.is_sky() && !overlap(l, other)) continue;
            base::fail(scene.place(*l.object), named(scene, l) + " is a second " + (l.is_sky() ? "sky" : "sun") +
                                                   ", beside " + placed(scene, other) + allowed);
        }
    }
}

void warn_of_two_skies(const Scene& scene) {
    const std::vector<FarLight> all = far_lights(scene, 0);
    for (const FarLight& l : all)
        for (const FarLight& other : all)
            if (other.object < l.object && other.object->file != l.object->file && l.is_sky() && other.is_sky() &&
                overlap(l, other))
                return base::warn(scene.place(*l.object), named(scene, l) + " is a second sky, beside " +
                                                              placed(scene, other) + ": both give light");
}

}  // namespace scene
