// SPDX-License-Identifier: BSD-3-Clause
// See band_colours.h.  Modifiers precede their users.
#include "flatten/band_colours.h"

#include <algorithm>
#include <set>

#include "base/error.h"
#include "flatten/named_modifiers.h"
#include "scene/materials.h"

namespace flatten {
namespace {

using scene::Object;
using scene::Type;

bool is_spectral(Type t) { return t >= Type::spectrum && t <= Type::specpict; }
bool is_rgb_pattern(Type t) {
    return t == Type::colorfunc || t == Type::colordata || t == Type::colorpict || t == Type::colortext;
}

// First real arguments of R, G and B of a material.
std::vector<size_t> colours_of(Type type) {
    switch (type) {
    case Type::interface: return {0, 4};
    case Type::ashik2:
    case Type::mist: return {0, 3};
    case Type::BRTDfunc:
    case Type::WGMDfunc:
    case Type::BSDF:
    case Type::aBSDF: return {0, 3, 6};
    case Type::prism1:
    case Type::prism2:
    case Type::antimatter: return {};
    default: return {0};
    }
}

bool is_grey(scene::Span<double> a, size_t at) { return a[at] == a[at + 1] && a[at] == a[at + 2]; }

// All that an object's chain and arguments name.
template <class F>
void for_parts(const scene::Scene& scene, const scene::Scene::Resolved& r, const F& part) {
    if (r.modifier >= 0) part(size_t(r.modifier));
    for (const int32_t m : named_modifiers(scene, uint32_t(r.object)))
        if (m >= 0) part(size_t(m));
}

}  // namespace

SpectralUses spectral_uses(const scene::Scene& scene) {
    const size_t count = scene.objects.size();
    const std::vector<uint8_t> needed = needed_modifiers(scene, 0, count, {});
    SpectralUses uses(count), above(count);  // above: of the materials and spectra that a chain ends in
    for (size_t i = 0; i < count; i++) {
        if (scene::is_surface(scene.objects[i].type)) continue;
        const auto r = scene.resolve(int32_t(i));
        const Type t = scene.objects[r.object].type;
        if (scene::is_material(t)) (scene::is_emissive(t) ? above[i].of_light : above[i].of_surface) = true;
        if (is_spectral(t)) above[i].has_spectrum = true;
        for_parts(scene, r, [&](size_t m) {
            above[i].has_spectrum |= above[m].has_spectrum;
            if (scene::is_material(t)) return;
            above[i].of_light |= above[m].of_light;
            above[i].of_surface |= above[m].of_surface;
        });
    }
    for (size_t i = count; i-- > 0;) {
        if (scene::is_surface(scene.objects[i].type) || !needed[i]) continue;
        const auto r = scene.resolve(int32_t(i));
        SpectralUse& use = uses[i];
        use.of_light |= above[i].of_light;
        use.of_surface |= above[i].of_surface;
        use.has_spectrum |= above[i].has_spectrum;  // also by a pattern that the light is above of
        for_parts(scene, r, [&](size_t m) {
            uses[m].of_light |= use.of_light;
            uses[m].of_surface |= use.of_surface;
            uses[m].has_spectrum |= use.has_spectrum && scene::is_material(scene.objects[m].type) &&
                                    !scene::is_material(scene.objects[r.object].type);
        });
    }
    return uses;
}

cal::PatternSpec pattern_spec(const BandColours* colours, const SpectralUses& uses, const scene::Scene& scene, size_t i,
                              const Object& o) {
    const auto s = scene.strings(o);
    const auto r = scene.reals(o);
    cal::PatternSpec spec{type_name(o.type), {s.begin(), s.end()}, {r.begin(), r.end()}, scene.place(o), {}};
    if (!colours) return spec;
    if (is_spectral(o.type) && uses[i].of_light && uses[i].of_surface)
        base::fail(spec.place, "a spectrum of lights and of surfaces: with -action, give each its own");
    spec.bands = &colours->bands;
    spec.of_light = uses[i].of_light;
    return spec;
}

std::vector<double> arguments_of(const BandColours* colours, const SpectralUses& uses, const scene::Scene& scene,
                                 size_t i, const Object& material) {
    const auto a = scene.reals(material);
    std::vector<double> out(a.begin(), a.end());
    if (!colours) return out;
    for (const size_t at : colours_of(material.type)) {
        if (at + 3 > out.size()) break;
        const spectrum::Colour rgb{a[at], a[at + 1], a[at + 2]};
        spectrum::Colour c = colour_of_surface(colours->bands, rgb);
        if (scene::is_emissive(material.type) && !uses[i].has_spectrum) {
            const LightSpectra& lights = colours->lights;
            const auto lamp = lights.lamps.find(scene.name(scene.objects[i]));
            c = colour_of_light(colours->bands, rgb, lamp == lights.lamps.end() ? lights.daylight : lamp->second);
        }
        std::copy(c.begin(), c.end(), out.begin() + long(at));
    }
    return out;
}

Guessed guessed_spectra(const scene::Scene& scene, const LightSpectra& lights) {
    const std::vector<uint8_t> needed = needed_modifiers(scene, 0, scene.objects.size(), {});
    const SpectralUses uses = spectral_uses(scene);
    std::set<std::string> lamps;
    Guessed guessed;
    const auto add = [](std::vector<std::string>& list, const std::string& name) {
        if (std::find(list.begin(), list.end(), name) == list.end()) list.push_back(name);
    };
    for (size_t i = 0; i < needed.size(); i++) {
        if (!needed[i] || scene::is_surface(scene.objects[i].type)) continue;
        const std::string name = scene.name(scene.objects[i]);
        const Object& o = scene.objects[scene.resolve(int32_t(i)).object];
        const auto a = scene.reals(o);
        if (is_rgb_pattern(o.type)) add(guessed.surfaces, name);
        if (!scene::is_material(o.type)) continue;
        if (scene::is_emissive(o.type)) {
            const bool is_lamp = lights.lamps.count(name) > 0, is_black = std::max({a[0], a[1], a[2]}) <= 0;
            if (is_lamp && !uses[i].has_spectrum) lamps.insert(name);
            if (!is_lamp && !uses[i].has_spectrum && !is_black) add(guessed.lights, name);
            continue;
        }
        for (const size_t at : colours_of(o.type))
            if (at + 3 <= a.size() && !is_grey(a, at)) add(guessed.surfaces, name);
    }
    for (const auto& [name, spectrum] : lights.lamps)
        if (lamps.count(name) == 0) guessed.lamps.push_back(name);
    return guessed;
}

}  // namespace flatten
