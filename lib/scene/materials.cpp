// SPDX-License-Identifier: BSD-3-Clause
// See materials.h.
#include "scene/materials.h"

#include "kernels/dialect/host.h"

namespace scene {

namespace {

struct Fill {
    size_t count;
    double value;
};
constexpr Fill fill(size_t count, double value) { return {count, value}; }
constexpr Fill none{0, 0};

constexpr Material material_of(uint32_t number, Fill absent, Passes light, Passes eye, uint32_t traits) {
    return {number, traits & MT_FLAGS, traits & ~MT_FLAGS, light, eye, absent.count, float(absent.value)};
}
#define ROW_OF_MATERIAL(number, type, strings, reals, absent, values, lobe, light, eye, region, back, traits) \
    material_of(kernels::M_##number, absent, Passes::light, Passes::eye, MATERIAL_TRAITS(region, back, traits)),
constexpr Material material_rows[] = {MATERIALS(ROW_OF_MATERIAL, ROW_OF_MATERIAL)};
#undef ROW_OF_MATERIAL

}  // namespace

const Material& material_row(Type type) { return material_rows[size_t(type) - size_t(Type::instance) - 1]; }

bool light_passes(const Scene& scene, const Object& material, bool bv) {
    const Passes light = material_row(material.type).light;
    if (light != Passes::ask) return light == Passes::yes;
    const auto a = scene.reals(material);
    const auto s = scene.strings(material);
    switch (material.type) {
    case Type::trans: return !bv || (a[4] * a[4] <= 1e-6 && a[5] * a[6] > 1e-6);
    case Type::WGMDfunc: return s[5] != "0";     // the word decides, from behind, too
    case Type::BSDF: return !bv || s[0] != "0";  // a proxy of some thickness
    default: return false;
    }
}

bool eye_passes(const Scene& scene, const Object& material) {
    const Passes eye = material_row(material.type).eye;
    if (eye != Passes::ask) return eye == Passes::yes;
    const auto some = [&](size_t k) { return scene.strings(material)[k] != "0"; };
    switch (material.type) {
    case Type::BRTDfunc: return some(3) || some(4) || some(5);
    case Type::WGMDfunc: return some(5);
    case Type::BSDF: return some(0);
    default: return false;
    }
}

bool mirror_gives_way(const Scene& scene, const Object& material) {
    return material.type != Type::BSDF && eye_passes(scene, material);
}

}  // namespace scene
