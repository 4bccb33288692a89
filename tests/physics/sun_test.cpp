// SPDX-License-Identifier: BSD-3-Clause
// The sun anywhere in an angular fisheye, from its middle to behind its rim: Ev and DGPf by closed form.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "physics/laws.h"

#include <fmt/format.h>

#include "glare/columns.h"
#include "image/picture.h"

using namespace laws;

namespace {

constexpr double half = .2665 * pi / 180, L = 1e8;  // cd/m2

// Integrals over the part of the sun's disc that lies ahead of the eye, `angle` from its line of sight.
struct Disc {
    double omega = 0, cosine = 0;  // sr, and sr times cosine
    explicit Disc(double angle) {
        constexpr int rings = 300, sectors = 360;
        const double whole = 2 * pi * (1 - std::cos(half));
        for (int k = 0; k < rings * sectors; ++k) {
            const double r = half * std::sqrt((k / sectors + .5) / rings), phi = 2 * pi * (k % sectors + .5) / sectors;
            const double c = std::cos(angle) * std::cos(r) - std::sin(angle) * std::sin(r) * std::cos(phi);
            if (c > 0) omega += whole / (rings * sectors), cosine += c * whole / (rings * sectors);
        }
    }
};

view::View fisheye(char type) {
    view::View v;
    v.type = type;
    v.vd = {0, 1, 0}, v.vu = {0, 0, 1};
    v.vh = v.vv = 180;
    return v;
}

struct Measured {
    double ev = 0, dgpf = 0;
};

// azimuth: 0 to the right, positive upward.
Measured measured(double angle, double azimuth, double surround, int side, char type = 'a') {
    const auto light = [](double cdm2) { return fmt::format("{0} {0} {0}", cdm2 / glare::cdm2_per_grey); };
    std::string text = fmt::format("void light l 0 0 3 {}\nl source sun 0 0 4 {} {} {} {}\n", light(L),
                                   std::sin(angle) * std::cos(azimuth), std::cos(angle),
                                   std::sin(angle) * std::sin(azimuth), 2 * half * 180 / pi);
    if (surround > 0) text += "void glow g 0 0 4 " + light(surround) + " 0\ng source sky 0 0 4 0 0 1 360\n";
    render::Renderer renderer(scene_of(text), fisheye(type), side, side, direct_only(), "cpu", {});
    image::Picture p;
    p.width = p.height = side;
    p.header.view = fisheye(type);
    renderer.frame(0, p.rgb);
    p.moments = renderer.moments();
    glare::ColumnChoice choice;
    choice.names = {"Ev", "DGPf"};
    glare::Requirements requirements;
    const auto columns = glare::choose_columns(choice, {}, requirements);
    const auto m = glare::measure(glare::read(glare::make_plan({{}, requirements}), p, "picture"));
    return {columns[0].value(m), columns[1].value(m)};
}

}  // namespace

TEST_CASE("the sun at the rim of the view, in a surround at the threshold") {
    constexpr double surround = 1999.9;
    for (const int side : {64, 128})
        for (const double azimuth : {0., .7, -1.134})
            for (double deg = 85; deg<92.05; deg += deg> 89.55 && deg < 90.35 ? .1 : .5) {
                CAPTURE(side);
                CAPTURE(azimuth);
                CAPTURE(deg);
                const Disc disc(deg * pi / 180);
                const double ev = pi * surround + (L - surround) * disc.cosine;
                double dgp = 5.87e-5 * ev + .159;
                if (disc.omega > 0) {
                    const double sigma = std::acos(disc.cosine / disc.omega);
                    const base::Vec3 d{std::sin(sigma) * std::cos(azimuth), std::cos(sigma),
                                       std::sin(sigma) * std::sin(azimuth)};
                    const double P = view::position_index(view::Projector(fisheye('a')), d);
                    dgp += .092 * std::log10(1 + L * L * disc.omega / (std::pow(ev, 1.87) * P * P));
                }
                const Measured m = measured(deg * pi / 180, azimuth, surround, side);
                CHECK(m.ev == doctest::Approx(ev).epsilon(.003));
                CHECK(std::abs(m.dgpf - dgp) < .002);
            }
}

// Of a hemispherical fisheye pixels across the rim have no solid angle, but the sun in them has.
TEST_CASE("a lone sun's illuminance, wherever it stands in a pixel") {
    for (const char type : {'a', 'h'})
        for (double azimuth = 0; azimuth < 6.2; azimuth += pi / 6)
            for (const double deg : {0., 20., 45., 60., 75., 80., 85.}) {
                CAPTURE(type);
                CAPTURE(azimuth);
                CAPTURE(deg);
                const double truth = L * Disc(deg * pi / 180).cosine;
                CHECK(measured(deg * pi / 180, azimuth, 0, 64, type).ev == doctest::Approx(truth).epsilon(.001));
            }
}

TEST_CASE("the position index rises on behind the eye") {
    const view::Projector p(fisheye('a'));
    for (const double azimuth : {0., .7, -1.2, -1.5})
        for (double deg = 88; deg < 120; deg += .1) {
            const double angle = deg * pi / 180, next = (deg + .1) * pi / 180;
            const auto at = [&](double a) {
                return view::position_index(
                    p, {std::sin(a) * std::cos(azimuth), std::cos(a), std::sin(a) * std::sin(azimuth)});
            };
            CHECK(at(next) >= at(angle));
            CHECK(at(next) < 1.01 * at(angle));
        }
}
