// SPDX-License-Identifier: BSD-3-Clause
// Sensors (ptrace -points) against closed forms: irradiances from sources and skies, on every device.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "physics/laws.h"

namespace {
using laws::pi;

struct Sensor {
    base::Vec3 p, n;
    double exact;  // irradiance
};

// Mean over frames and its standard error, of the red channel.
struct Mean {
    double value = 0, error = 0;
};

std::vector<Mean> means_of(const scene::Scene& scene, const std::vector<Sensor>& sensors, bool irradiance, int frames,
                           const std::string& device, render::RenderOptions options) {
    auto list = std::make_shared<render::PointList>();
    list->sensors = irradiance;
    for (const Sensor& s : sensors) list->points.push_back({s.p, base::unit(s.n)});
    render::RenderView view;
    image::size_for(sensors.size(), view.nx, view.ny);
    view.points = list;
    view.view.vp = sensors[0].p;
    render::Renderer renderer(device);
    options.eye = view.view.vp;
    renderer.load(scene, options, {});
    renderer.select_view(view, options);
    std::vector<double> sum(sensors.size()), squares(sensors.size());
    std::vector<float> zero;
    renderer.frames(0, frames + 1, [&](int64_t k, const std::vector<float>& rgb, const image::Moments&) {
        if (k == 0) return zero = rgb, true;
        for (size_t i = 0; i < sum.size(); ++i) {
            const double v = double(zero[3 * i]) + double(rgb[3 * i]);
            sum[i] += v, squares[i] += v * v;
        }
        return true;
    });
    std::vector<Mean> means;
    for (size_t i = 0; i < sum.size(); ++i) {
        const double mean = sum[i] / frames;
        means.push_back({mean, std::sqrt(std::max(0., squares[i] / frames - mean * mean) / (frames - 1))});
    }
    return means;
}

// Within 4 standard errors, which are small beside the value.
void expect(const std::string& text, const std::vector<Sensor>& sensors, render::RenderOptions options = {}) {
    const scene::Scene scene = laws::scene_of(text);
    for (const std::string& device : laws::devices()) {
        CAPTURE(device);
        const std::vector<Mean> means = means_of(scene, sensors, true, 16, device, options);
        for (size_t i = 0; i < sensors.size(); ++i) {
            CAPTURE(i);
            CAPTURE(means[i].value);
            CAPTURE(means[i].error);
            CAPTURE(sensors[i].exact);
            CHECK(std::abs(means[i].value - sensors[i].exact) <= 4 * means[i].error + 3e-5 * sensors[i].exact);
            CHECK(means[i].error <= .02 * sensors[i].exact);
        }
    }
}

const std::string uniform = "void glow g 0 0 4 1 1 1 0\ng source s 0 0 4 0 0 1 180\n";
}  // namespace

TEST_CASE("a uniform sky: facing up, tilted, on its side, at a surface of black ground") {
    const std::string ground = "void plastic black 0 0 5 0 0 0 0 0\nblack ring r 0 0 8 0 0 0 0 0 1 0 50\n";
    const double tilt = pi / 6;  // (1 + cos) pi / 2
    expect(uniform + ground, {{{1, 2, 0}, {0, 0, 1}, pi},
                              {{1, 2, 0}, {0, std::sin(tilt), std::cos(tilt)}, pi * (1 + std::cos(tilt)) / 2},
                              {{3, 2, .5}, {1, 0, 0}, pi / 2},
                              {{3, 2, .5}, {0, 0, -1}, 0}});
}

TEST_CASE("a small ball of light, far and near: pi L (r/d)^2 cos") {
    const std::string ball = "void light l 0 0 3 10 10 10\nl sphere s 0 0 4 0 0 3 .1\n";
    expect(ball, {{{0, 0, 0}, {0, 0, 1}, 10 * pi * .01 / 9},
                  {{4, 0, 0}, {0, 0, 1}, 10 * pi * .01 / 25 * .6},
                  {{0, 0, 2}, {0, 0, 1}, 10 * pi * .01},
                  {{0, 0, 2}, {0, 0, -1}, 0}});
}

TEST_CASE("a disc of light above a sensor: pi L r^2/(r^2 + h^2); a square: by Lambert's sum over its edges") {
    expect("void light l 0 0 3 5 5 5\nl ring r 0 0 8 0 0 2 0 0 -1 0 1\n", {{{0, 0, 0}, {0, 0, 1}, 5 * pi / 5}});
    // at the height h below the corner of a square of side a, for four of which: E = 4 L/2 sum of edges
    const double a = 1, h = 2, r = std::sqrt(a * a + h * h), corner = a / r * std::atan(a / r);
    expect("void light l 0 0 3 5 5 5\nl polygon p 0 0 12 -1 -1 2 -1 1 2 1 1 2 1 -1 2\n",
           {{{0, 0, 0}, {0, 0, 1}, 4 * 5 * corner}});
}

TEST_CASE("in a sphere of light: its hemisphere is the first bounce of -ab") {
    const std::string room = "void glow g 0 0 4 1 1 1 0\ng bubble b 0 0 4 0 0 0 3\n";
    expect(room, {{{0, 0, 0}, {0, 0, 1}, pi}, {{1, 1, 1}, {1, 0, 0}, pi}});
    render::RenderOptions none;
    none.ab = 0;
    expect(room, {{{0, 0, 0}, {0, 0, 1}, 0}}, none);
}

TEST_CASE("far from the origin a sensor is as exact") {
    const std::string ball =
        "void light l 0 0 3 10 10 10\nl sphere s 0 0 4 500000 4000000 3 .1\n"
        "void plastic black 0 0 5 0 0 0 0 0\nblack ring r 0 0 8 500000 4000000 0 0 0 1 0 5\n";
    expect(ball, {{{500000, 4000000, 0}, {0, 0, 1}, 10 * pi * .01 / 9},
                  {{500004, 4000000, 0}, {0, 0, 1}, 10 * pi * .01 / 25 * .6}});
}

TEST_CASE("one point or many: each has its value, in the order of the file") {
    const scene::Scene scene = laws::scene_of("void light l 0 0 3 10 10 10\nl sphere s 0 0 4 0 0 3 .1\n");
    for (const size_t n : {1u, 2u, 15u, 17u, 255u, 257u, 1000u}) {
        std::vector<Sensor> sensors;
        for (size_t i = 0; i < n; ++i) {
            const double x = .01 * double(i * 7919 % n), d2 = 9 + x * x;
            sensors.push_back({{x, 0, 0}, {0, 0, 1}, 10 * pi * .01 / d2 * 3 / std::sqrt(d2)});
        }
        const std::vector<Mean> means = means_of(scene, sensors, true, 4, "cpu", {});
        size_t wrong = 0;
        for (size_t i = 0; i < n; ++i) wrong += std::abs(means[i].value / sensors[i].exact - 1) > .03;
        CAPTURE(n);
        CHECK(wrong == 0);
    }
}

TEST_CASE("rays: the radiance of what they meet, also from a surface") {
    const scene::Scene scene = laws::scene_of(uniform + "void glow w 0 0 4 3 3 3 0\nw ring r 0 0 8 0 0 0 0 0 1 0 5\n");
    const std::vector<Mean> means =
        means_of(scene, {{{0, 0, 1}, {0, 0, -1}, 3}, {{0, 0, 0}, {0, 0, 1}, 1}}, false, 2, "cpu", {});
    CHECK(means[0].value == doctest::Approx(3));
    CHECK(means[1].value == doctest::Approx(1));
}
