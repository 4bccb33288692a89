// SPDX-License-Identifier: BSD-3-Clause
// Scenes whose light can be written down, on every device: 16384 samples a ray, within 4 standard errors.  Then a sun,
// which is drawn by its area: Ev of the picture.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "physics/laws.h"

#include <fmt/core.h>

#include "base/vec.h"

using namespace laws;
using base::Vec3;

// A bubble of radiance 1 around everything.  What reflects all light and lies in it looks like it, wherever one looks
// and however the light went: nothing is lost and nothing counted twice.
TEST_CASE("white things in a uniform surround cannot be seen") {
    const std::string room = "void glow g 0 0 4 1 1 1 0\ng bubble sky 0 0 4 0 0 0 20\n";
    const std::string things =
        "void plastic white 0 0 5 1 1 1 0 0\nwhite sphere ball 0 0 4 0 0 0 1\nwhite cone hat 0 0 8 0 0 1.5 0 0 3 1 .2\n"
        "white polygon plate 0 0 12 -2 -2 -1.2 2 -2 -1.2 2 2 -1.2 -2 2 -1.2\n";
    render::RenderOptions options;
    options.ab = 100;
    options.lr = -200;
    for (const Ray& ray : {Ray{{5, 0, 0}, {-1, 0, 0}}, Ray{{5, 0, -.5}, {-1, 0, -.15}}, Ray{{4, 1, 4}, {-4, -1, -2}}})
        expect(room + things, options, ray, {1}, 2048);
    options.ss = 1;  // the lobe that keeps its energy at every angle
    expect(room + "void plastic gloss 0 0 5 1 1 1 .1 .2\ngloss sphere ball 0 0 4 0 0 0 1\n", options,
           {{5, 0, .6}, {-1, 0, 0}}, {1}, 2048);
    expect(room + "void glass clear 0 0 3 1 1 1\nclear polygon pane 0 0 12 -2 -2 0 2 -2 0 2 2 0 -2 2 0\n", options,
           {{3, 0, 1}, {-3, 0, -1}}, {1}, 2048);
}

// Above -ss 1.5 rough lobes are weighted where the ray still counts enough for two samples, -ss times its weight.  What
// a diffuse bounce or another rough lobe sends out never does, in rtrace as here: a white rough ceiling, seen by a
// floor of which the eye sees a spot, returns all it gets (rtrace -ss 4 -ad 256: 0.5 to every digit; weighted it would
// be 0.4656).
TEST_CASE("rough lobes behind a bounce keep their energy") {
    const std::string text =
        "void glow g 0 0 4 1 1 1 0\ng source sky 0 0 4 0 0 1 360\nvoid metal rough 0 0 5 1 1 1 1 .2\n"
        "rough ring ceiling 0 0 8 0 0 1 0 0 -1 0 4\nvoid plastic grey 0 0 5 .5 .5 .5 0 0\n"
        "grey ring spot 0 0 8 0 0 0 0 0 1 0 .01\nrough ring side 0 0 8 3 0 .5 -1 0 0 0 .4\n";
    render::RenderOptions options;
    options.ab = 1;
    for (double ss : {1., 4., 64.}) {
        CAPTURE(ss);
        options.ss = ss;
        expect(text, options, {{0, 0, .5}, {0, 0, -1}}, {.5});
    }
}

// A closed sphere (radius R) of diffuse reflectance p with a small bulb (radius r, radiance L0) at its centre.  The
// bulb gives every wall point E = pi L0 (r/R)^2; each bounce returns a share p and loses the share (r/R)^2 to the bulb:
//     L = L0 (r/R)^2 sum_k p^k (1 - (r/R)^2)^(k-1),  k = 1 ... bounces + 1.
TEST_CASE("light trapped in a closed sphere sums the geometric series") {
    const std::string text =
        "void light lm 0 0 3 1000 1000 1000\nlm sphere bulb 0 0 4 0 0 0 .01\n"
        "void plastic wall 0 0 5 .5 .3 .1 0 0\nwall bubble room 0 0 4 0 0 0 1\n";
    for (int bounces : {0, 1, 2, 60}) {
        CAPTURE(bounces);
        render::RenderOptions options;
        options.ab = bounces;
        options.lr = -200;
        std::vector<double> exact;
        for (double p : {.5, .3, .1}) {
            double sum = 0, term = p;
            for (int k = 0; k <= bounces; ++k, term *= p * (1 - 1e-4)) sum += term;
            exact.push_back(1000 * 1e-4 * sum);
        }
        expect(text, options, {{.5, 0, 0}, {1, .3, .2}}, exact);
    }
}

// The same without a limit, which is the default: L = L0 (r/R)^2 p / (1 - p (1 - (r/R)^2)).
TEST_CASE("a closed sphere without a limit of bounces has all of its light") {
    for (double p : {.5, .8, .9, .95, .99}) {
        CAPTURE(p);
        expect(fmt::format("void light lm 0 0 3 1000 1000 1000\nlm sphere bulb 0 0 4 0 0 0 .01\n"
                           "void plastic wall 0 0 5 {0} {0} {0} 0 0\nwall bubble room 0 0 4 0 0 0 1\n",
                           p),
               {}, {{.5, 0, 0}, {1, .3, .2}}, {1000 * 1e-4 * p / (1 - p * (1 - 1e-4))}, 2048, .02);
    }
}

// Walls that are lamps of radiance 1 by a share f and else reflect p: L = f + (1 - f) p L in closed rooms of any shape.
TEST_CASE("a closed cube of glowing walls, diffuse or mirrors, has all of its light") {
    const double f = .005;
    for (const char* wall : {"plastic wall 0 0 5 {0} {0} {0} 0 0", "mirror wall 0 0 3 {0} {0} {0}"})
        for (double reflected : {.5, .8, .9, .95, .99}) {
            CAPTURE(std::string(wall));
            CAPTURE(reflected);
            const std::string text = fmt::format("void " + std::string(wall), reflected / (1 - f)) +
                                     "\nvoid glow lamp 0 0 4 1 1 1 0\nvoid mixfunc both 4 lamp wall .005 . 0 0\n"
                                     "!genbox both room 1 1 1 -i\n";
            expect(text, {}, {{.5, .4, .3}, {1, .3, .2}}, {f / (1 - reflected)}, 16384, .15);
        }
}

// A disc of half angle a and radiance L at zenith angle t: E = pi sin(a)^2 cos(t) L, and the floor returns rho E / pi.
TEST_CASE("the sun on a floor") {
    const double a = .25 * pi / 180, cosine = .9 / std::sqrt(.94);
    std::vector<double> exact;
    for (const auto& [rho, L] : {std::pair{.5, 1e4}, std::pair{.3, 9e3}, std::pair{.1, 8e3}})
        exact.push_back(rho * L * std::sin(a) * std::sin(a) * cosine);
    expect(
        "void light sun 0 0 3 10000 9000 8000\nsun source disc 0 0 4 .3 .2 .9 .5\n"
        "void plastic mat 0 0 5 .5 .3 .1 0 0\nmat polygon floor 0 0 12 -5 -5 0 5 -5 0 5 5 0 -5 5 0\n",
        direct_only(), {{0, 0, 2}, {.2, 0, -1}}, exact);
}

namespace {

// A pane of transmissivity t and index 1.52: Fresnel's reflectances of both polarisations summed over all passes
// inside.
struct Pane {
    double through, back;
};
Pane pane(double t, double cosine) {
    const double n = 1.52, c2 = std::sqrt(1 - (1 - cosine * cosine) / (n * n)), d = std::pow(t, 1 / c2);
    const double rs = (cosine - n * c2) / (cosine + n * c2), rp = (n * cosine - c2) / (n * cosine + c2);
    Pane sum{0, 0};
    for (double r : {rs * rs, rp * rp}) {
        sum.through += .5 * (1 - r) * (1 - r) * d / (1 - r * r * d * d);
        sum.back += .5 * r * (1 + (1 - 2 * r) * d * d) / (1 - r * r * d * d);
    }
    return sum;
}

const std::string sky_and_ground =
    "void glow up 0 0 4 1 2 3 0\nup source sky 0 0 4 0 0 1 180\nvoid glow down 0 0 4 5 5 5 0\ndown source ground 0 0 4 "
    "0 0 -1 180\n"
    "void glass pane 0 0 3 .96 .9 .8\npane polygon low 0 0 12 -50 -50 0 50 -50 0 50 50 0 -50 50 0\n";

}  // namespace

TEST_CASE("sky and ground in one pane and in two") {
    for (double angle : {0., 40., 75.}) {
        CAPTURE(angle);
        const double s = std::sin(angle * pi / 180), c = std::cos(angle * pi / 180);
        std::vector<double> one, two;
        const double t[3] = {.96, .9, .8}, sky[3] = {1, 2, 3};
        for (int i = 0; i < 3; ++i) {
            const Pane p = pane(t[i], c);
            one.push_back(p.through * 5 + p.back * sky[i]);
            const double between = 1 / (1 - p.back * p.back);  // to and fro between the two
            two.push_back(p.through * p.through * between * 5 +
                          p.back * (1 + p.through * p.through * between) * sky[i]);
        }
        render::RenderOptions options = direct_only();
        options.lr = -60;
        const Ray ray{{-s * 2, 0, c * 2}, {s, 0, -c}};
        expect(sky_and_ground, options, ray, one, 65536);
        expect(sky_and_ground + "pane polygon high 0 0 12 -50 -50 .5 50 -50 .5 50 50 .5 -50 50 .5\n", options, ray, two,
               65536);
    }
}

// Lambert (1760): a polygon of radiance L gives E = L/2 sum over its edges of (the angle an edge subtends) times (the
// cosine between the normal of the plane through that edge and the receiver's).
namespace {
double lambert(const std::vector<Vec3>& corners, Vec3 at, Vec3 normal) {
    double sum = 0;
    for (size_t i = 0; i < corners.size(); ++i) {
        const Vec3 a = base::unit(corners[i] - at), b = base::unit(corners[(i + 1) % corners.size()] - at);
        sum += std::acos(dot(a, b)) * dot(base::unit(cross(a, b)), normal);
    }
    return std::abs(sum) / 2;
}
}  // namespace

TEST_CASE("a polygon of any shape lights a floor as Lambert's formula says") {
    const std::vector<std::vector<Vec3>> shapes = {
        {{-.5, -.5, 1}, {-.5, .5, 1}, {.5, .5, 1}, {.5, -.5, 1}},                           // square
        {{0, 0, 1}, {0, 1, 1}, {1, 0, 1}},                                                  // triangle
        {{-1, -.5, 1}, {-.2, .5, 1}, {.2, .5, 1}, {1, -.5, 1}},                             // trapezoid
        {{-.8, -.8, 1}, {-.8, .8, 1}, {0, .8, 1}, {0, .2, 1}, {.8, .2, 1}, {.8, -.8, 1}}};  // an L
    for (const auto& shape : shapes) {
        std::string text =
            "void plastic mat 0 0 5 .5 .3 .1 0 0\nmat polygon floor 0 0 12 -5 -5 0 5 -5 0 5 5 0 -5 5 0\n"
            "void light lm 0 0 3 10 10 10\nlm polygon lamp 0 0 " +
            std::to_string(3 * shape.size());
        for (const Vec3& v : shape)
            text += " " + std::to_string(v.x) + " " + std::to_string(v.y) + " " + std::to_string(v.z);
        text += "\n";
        for (const Vec3& at : {Vec3{-.1, -.2, 0}, Vec3{1, .5, 0}}) {
            const double E = 10 * lambert(shape, at, {0, 0, 1});
            expect(text, direct_only(), {{at.x, at.y, .5}, {0, 0, -1}}, {.5 * E / pi, .3 * E / pi, .1 * E / pi});
        }
    }
}

// A sphere wholly above the horizon: E = pi L (r/d)^2 cos(t), exactly, at any distance.
TEST_CASE("a sphere of light") {
    const double d2 = 1 + .36, E = pi * 10 * .16 / d2 / std::sqrt(d2);
    expect(
        "void light lm 0 0 3 10 10 10\nlm sphere ball 0 0 4 0 0 1 .4\nvoid plastic mat 0 0 5 .5 .3 .1 0 0\n"
        "mat polygon floor 0 0 12 -5 -5 0 5 -5 0 5 5 0 -5 5 0\n",
        direct_only(), {{.6, 0, .1}, {0, 0, -1}}, {.5 * E / pi, .3 * E / pi, .1 * E / pi});
}

// A spotlight of area A at height d shines as if from f behind itself: E = L A / (d + f)^2 below it, nothing outside
// its cone.  The square is 1/500 of the height: A cos/d^2 is its solid angle to 1e-6.
TEST_CASE("a spotlight") {
    const std::string text =
        "void plastic mat 0 0 5 .5 .3 .1 0 0\nmat polygon floor 0 0 12 -9 -9 0 9 -9 0 9 9 0 -9 9 0\n"
        "void spotlight lm 0 0 7 1e4 1e4 1e4 60 0 0 -.5\n"
        "lm polygon lamp 0 0 12 -.001 -.001 2 -.001 .001 2 .001 .001 2 .001 -.001 2\n";
    const double E = 1e4 * 4e-6 / (2.5 * 2.5);
    expect(text, direct_only(), {{0, 0, .5}, {0, 0, -1}}, {.5 * E / pi, .3 * E / pi, .1 * E / pi});
    expect(text, direct_only(), {{2, 0, .5}, {0, 0, -1}}, {0});
}

// A sheet that passes the share t of all light diffusely, under a sky of radiance 1: it shows C t from below, C (1-t)
// from above.
TEST_CASE("a diffusing sheet under the sky") {
    const std::string text =
        "void glow up 0 0 4 1 1 1 0\nup source sky 0 0 4 0 0 1 180\nvoid trans sheet 0 0 7 .8 .6 .4 0 0 .3 0\n"
        "sheet polygon roof 0 0 12 -5 -5 0 5 -5 0 5 5 0 -5 5 0\n";
    render::RenderOptions options;
    options.ab = 1;
    expect(text, options, {{0, 0, -1}, {.1, 0, 1}}, {.24, .18, .12}, 65536);
    expect(text, options, {{0, 0, 1}, {.1, 0, -1}}, {.56, .42, .28}, 65536);
}

// A sun of half angle a in an empty sky: Ev = pi sin(a)^2 cos(t) L.  It is about a pixel wide here, so only drawing it
// by area can get this right in a single frame; with the sun on the axis its centre is a pixel's corner.
TEST_CASE("frame 0 has all of the sun, wherever it is in the picture") {
    const int size = 256;
    render::RenderOptions options = direct_only();
    options.direct_samples = 1;
    for (const char type : {'v', 'a', 'h', 's', 'c'}) {
        for (const double tilt : {0., .061, .12}) {
            CAPTURE(type);
            CAPTURE(tilt);
            view::View view;
            view.type = type;
            view.vd = {0, 1, 0};
            view.vh = view.vv = type == 'v' || type == 'c' ? 90 : 180;
            const view::Projector projector(view);
            const base::Vec3 sun = base::unit({tilt, 1, tilt / 3});
            render::Renderer renderer(
                scene_of("void light sun 0 0 3 1e6 1e6 1e6\nsun source disc 0 0 4 " + std::to_string(sun.x) + " " +
                         std::to_string(sun.y) + " " + std::to_string(sun.z) + " .533\n"),
                view, size, size, options, "cpu", {});
            std::vector<float> rgb;
            renderer.frame(0, rgb);
            double Ev = 0;
            for (int j = 0; j < size; ++j)
                for (int i = 0; i < size; ++i) {
                    const float v = rgb[3 * (size_t(size - 1 - j) * size + size_t(i))];
                    if (v == 0) continue;
                    const auto dir = projector.direction((i + .5) / size, (j + .5) / size);
                    REQUIRE(dir);
                    Ev += v * view::pixel_solid_angle(projector, i, j, size, size) * dir->y;
                }
            const double half = .2665 * pi / 180;
            CHECK(Ev == doctest::Approx(1e6 * pi * std::sin(half) * std::sin(half) * sun.y).epsilon(.002));
        }
    }
}
