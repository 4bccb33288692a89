// SPDX-License-Identifier: BSD-3-Clause
// Sensors on, just before and behind surfaces, in models of 1 m to 500 km.  A sky of radiance 1 lies all around, and
// the surface has reflectance 1/2, so that both its sides have radiance 1/2.  With F the form factor from the sensor to
// a rectangle a by b above whose middle it lies at height h,
//     E = pi (1 - F/2) where it looks at it, pi where it looks away.
//     F = 2/pi (A/sqrt(1+A^2) atan(B/sqrt(1+A^2)) + B/sqrt(1+B^2) atan(A/sqrt(1+B^2))),  A = a/2h,  B = b/2h
// On the surface (h = 0) it sees nothing of it, whichever way it looks; neither where the surface is less than 1e-4
// ahead: rtrace -I begins so far along the sensor's direction.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "physics/laws.h"

#include <fmt/format.h>

#include <random>

#include "base/vec.h"
#include "unit/temp_folder.h"

using namespace laws;
using base::Vec3;

namespace {

constexpr int frames = 8;

double form_factor(double a, double b, double h) {
    const double A = a / (2 * h), B = b / (2 * h), p = std::sqrt(1 + A * A), q = std::sqrt(1 + B * B);
    return 2 / pi * (A / p * std::atan(B / p) + B / q * std::atan(A / q));
}

// A rectangle in space.
struct Place {
    Vec3 middle, right, up, normal;
    double wide, high;
    Vec3 at(double x, double y) const { return middle + right * (x * wide / 2) + up * (y * high / 2); }
};

std::string corners(const Place& p) {
    std::string text;
    for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
        const Vec3 c = p.at(x, y);
        text += fmt::format(" {:.17g} {:.17g} {:.17g}", c.x, c.y, c.z);
    }
    return text;
}

struct Sensor {
    Vec3 p, n;
    double exact;
};

std::vector<Sensor> sensors_at(const Place& p) {
    std::vector<Sensor> all;
    for (const double h : {0., 1e-5, 1e-3, 1.})
        for (const double side : {1., -1.})
            for (const double looks : {1., -1.}) {
                const double seen = h > 1e-4 && looks < 0 ? form_factor(p.wide, p.high, h) : 0;
                all.push_back({p.middle + p.normal * (side * h), p.normal * (side * looks), pi * (1 - seen / 2)});
            }
    return all;
}

std::vector<std::string> all_devices() {
    std::vector<std::string> names = devices();
    for (const char* lanes : {"cpu:lanes8", "cpu:lanes16"}) try {
            render::make_device(lanes);
            names.emplace_back(lanes);
        } catch (const base::Error&) {  // not built, or not on this processor
        }
    return names;
}

void expect(const std::string& text, const std::vector<Sensor>& sensors) {
    const scene::Scene scene = scene_of(
        "void plastic p 0 0 5 .5 .5 .5 0 0\nvoid glow g 0 0 4 1 1 1 0\n"
        "g source sky 0 0 4 0 0 1 360\n" +
        text);
    auto list = std::make_shared<render::PointList>();
    for (const Sensor& s : sensors) list->points.push_back({s.p, s.n});
    render::RenderView view;
    image::size_for(sensors.size(), view.nx, view.ny);
    view.points = list;
    render::RenderOptions options;
    options.ab = 2;
    options.eye = render::viewpoint_of(view);
    static const std::vector<std::string> names = all_devices();
    for (const std::string& device : names) {
        CAPTURE(device);
        render::Renderer renderer(scene, view, options, device, {});
        std::vector<double> sum(sensors.size()), squares(sensors.size());
        std::vector<float> zero;
        renderer.frames(0, frames + 1, [&](int64_t k, const std::vector<float>& rgb, const image::Moments&) {
            if (k == 0) return zero = rgb, true;
            for (size_t i = 0; i < sum.size(); i++) {
                const double v = double(zero[3 * i]) + double(rgb[3 * i]);
                sum[i] += v, squares[i] += v * v;
            }
            return true;
        });
        for (size_t i = 0; i < sensors.size(); i++) {
            const double mean = sum[i] / frames;
            const double error = std::sqrt(std::max(0., squares[i] / frames - mean * mean) / (frames - 1));
            CAPTURE(i);
            CAPTURE(mean);
            CAPTURE(sensors[i].exact);
            CHECK(std::abs(mean - sensors[i].exact) <= 4.5 * error + 2e-4 * sensors[i].exact);
            CHECK(error <= .02 * sensors[i].exact);
        }
    }
}

std::mt19937 random_numbers(59);
double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_numbers); }

// Somewhere in a model of this size, and what makes the model so large.
Place anywhere(double size, double wide, double high) {
    const double angle = between(0, 2 * pi), z = between(-1, 1), across = std::sqrt(1 - z * z);
    Place p{{between(-.5, .5) * size, between(-.5, .5) * size, between(-.5, .5) * size}, {}, {}, {}, wide, high};
    p.normal = {across * std::cos(angle), across * std::sin(angle), z};
    p.right = base::unit(cross(p.normal, {.3, .5, .8}));
    p.up = cross(p.normal, p.right);
    return p;
}
std::string stray(double size) {
    return size > 1 ? fmt::format("p ring far 0 0 8 0 0 {} 0 0 1 0 {}\n", size, size * 1e-3) : "";
}

const double sizes[] = {1, 30, 1e3, 2e4, 5e5};

}  // namespace

TEST_CASE("planes and slats in any direction") {
    for (const double size : sizes)
        for (const double wide : {4., .025}) {
            CAPTURE(size);
            CAPTURE(wide);
            const Place p = anywhere(size, wide, 4);
            expect("p polygon plane 0 0 12" + corners(p) + "\n" + stray(size), sensors_at(p));
        }
}

TEST_CASE("a ground as large as the model") {
    for (const double size : sizes) {
        CAPTURE(size);
        const Place ground{{0, 0, .8}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, size, size};
        std::vector<Sensor> sensors = sensors_at(ground);
        if (size > 100)
            for (Sensor& s : sensors) s.p = s.p + Vec3{size / 8, size / 16, 0};
        expect("p polygon ground 0 0 12" + corners(ground) + "\n", sensors);
    }
}

TEST_CASE("meshes and instances") {
    TempFolder folder;
    const std::string obj = folder.holding("m.obj", "v -2 -1 0\nv 2 -1 0\nv 2 1 0\nv -2 1 0\nf 1 2 3\nf 1 3 4\n");
    const std::string rad = folder.holding("i.rad", "void polygon r 0 0 12 -2 -1 0 2 -1 0 2 1 0 -2 1 0\n");
    for (const double size : sizes)
        for (const std::string what : {"mesh m ", "instance i "}) {
            CAPTURE(size);
            CAPTURE(what);
            const double rx = between(-180, 180), rz = between(-180, 180), a = rx * pi / 180, b = rz * pi / 180;
            const Vec3 at{between(-.5, .5) * size, between(-.5, .5) * size, between(-.5, .5) * size};
            Place p{at, {std::cos(b), std::sin(b), 0}, {}, {}, 4, 2};
            p.up = Vec3{-std::sin(b) * std::cos(a), std::cos(b) * std::cos(a), std::sin(a)};
            p.normal = cross(p.right, p.up);
            const std::string& file = what[0] == 'm' ? obj : rad;
            expect(fmt::format("p {}9 {} -rx {:.17g} -rz {:.17g} -t {:.17g}", what, file, rx, rz, at.x) +
                       fmt::format(" {:.17g} {:.17g} 0 0\n", at.y, at.z) + stray(size),
                   sensors_at(p));
        }
}

// 5 mm above a plate and 10 mm from its edge, looking out along it: of the strip before it, between the edge, an angle
// t below the line of sight, and straight down, the form factor is (1 - sin t)/2.
TEST_CASE("a sensor near an edge sees past it, whatever else the model holds") {
    const double h = .005, d = .01;
    for (const double size : {1., 5e3, 5e5}) {
        CAPTURE(size);
        const Sensor s{{0, 0, h}, {1, 0, 0}, pi * (1 - (1 - std::sin(std::atan2(h, d))) / 4)};
        expect(fmt::format("p polygon plate 0 0 12 -400 -400 0 {0} -400 0 {0} 400 0 -400 400 0\n", d) + stray(size),
               {s});
    }
}
