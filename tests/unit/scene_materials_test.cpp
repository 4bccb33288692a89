// SPDX-License-Identifier: BSD-3-Clause
// The table of materials: what must hold of every row, and the questions whose answers depend on arguments.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>
#include "kernels/dialect/host.h"
#include "scene/materials.h"
#include "scene_text.h"

using namespace scene;

namespace {
std::vector<Type> all_materials() {
    std::vector<Type> out;
    for (size_t t = 0; t < size_t(Type::count); t++)
        if (is_material(Type(t))) out.push_back(Type(t));
    return out;
}
struct One {
    Scene scene;
    const Object& material() const { return scene.objects.back(); }
    explicit One(const std::string& text) : scene(read_text(text)) {}
    bool light(bool bv = true) const { return light_passes(scene, material(), bv); }
    bool eye() const { return eye_passes(scene, material()); }
};
}  // namespace

TEST_CASE("kernels know of a number what its rows say") {
    const uint32_t asked =
        MT_EMISSIVE | MT_CLEAR | MT_TURNS | MT_OPEN_BACK | MT_NO_BACK | MT_BENDS | MT_MEDIUM | MT_EVEN;
    for (Type t : all_materials()) {
        CAPTURE(type_name(t));
        const Material& row = material_row(t);
        CHECK(row.number >= M_FIRST_MATERIAL);
        CHECK(row.number < kernels::M_END);
        CHECK(row.traits == kernels::material_has(row.number, asked));
    }
}

TEST_CASE("the traits of types are those of their names") {
    CHECK(is_emissive(Type::illum));
    CHECK(!is_emissive(Type::plastic));
    CHECK(!is_emissive(Type::polygon));
    CHECK(is_clear(Type::prism2));
    CHECK(!is_clear(Type::trans));
    CHECK(material_row(Type::glass).number == kernels::M_GLASS);
    CHECK(material_row(Type::metdata).number == kernels::M_BRDF);
    CHECK(material_row(Type::metdata).flags == MF_METAL);
}

TEST_CASE("the index of glass is 1.52 where it is left out") {
    CHECK(material_row(Type::glass).filled == 4);
    CHECK(material_row(Type::glass).fill == 1.52f);
    CHECK(material_row(Type::plastic).filled == 0);
}

TEST_CASE("light passes trans from behind with -bv-, else where it is smooth and lets some through") {
    CHECK(One("void trans m 0 0 7 .5 .5 .5 0 0 .5 1").light());
    CHECK(!One("void trans m 0 0 7 .5 .5 .5 0 .1 .5 1").light());
    CHECK(One("void trans m 0 0 7 .5 .5 .5 0 .1 .5 1").light(false));
    CHECK(!One("void trans m 0 0 7 .5 .5 .5 0 0 .5 0").light());
}

TEST_CASE("of functions and BSDF files the words decide") {
    CHECK(!One("void BRTDfunc m 10 0 0 0 0 0 0 0 0 0 . 0 9 0 0 0 0 0 0 0 0 0").eye());
    CHECK(One("void BRTDfunc m 10 0 0 0 0 .1 0 0 0 0 . 0 9 0 0 0 0 0 0 0 0 0").eye());
    const One sheet("void BSDF m 6 0 a.xml 0 0 1 . 0 0"), proxy("void BSDF m 6 .1 a.xml 0 0 1 . 0 0");
    CHECK(!sheet.light());
    CHECK(sheet.light(false));
    CHECK(proxy.light());
    CHECK(proxy.eye());
    CHECK(!mirror_gives_way(proxy.scene, proxy.material()));
}

TEST_CASE("every type that asks for its arguments is answered for") {
    // an answer without a case would be `no` whatever the arguments are: these pass for some
    for (Type t : all_materials()) {
        CAPTURE(type_name(t));
        const Material& row = material_row(t);
        if (row.light == Passes::ask) CHECK((t == Type::trans || t == Type::WGMDfunc || t == Type::BSDF));
        if (row.eye == Passes::ask) CHECK((t == Type::BRTDfunc || t == Type::WGMDfunc || t == Type::BSDF));
    }
}
