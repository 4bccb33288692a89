// SPDX-License-Identifier: BSD-3-Clause
// Sensors (ptrace -points) against closed forms: irradiances from sources and skies, on every device.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <functional>

#include "physics/laws.h"
#include "uncertainty/points.h"

namespace {
using laws::pi;

struct Sensor {
    base::Vec3 p, n;
    double exact;  // irradiance
};

// The red channel of each frame, frame 0 added.
std::vector<image::Part> frames_of(const scene::Scene& scene, const std::vector<Sensor>& sensors, bool irradiance,
                                   int frames, const std::string& device, render::RenderOptions options) {
    auto list = std::make_shared<render::PointList>();
    list->sensors = irradiance;
    for (const Sensor& s : sensors) list->points.push_back({s.p, base::unit(s.n)});
    render::RenderView view;
    image::size_for(sensors.size(), view.nx, view.ny);
    view.points = list;
    view.view.vp = sensors[0].p;
    options.eye = render::viewpoint_of(view);
    render::Renderer renderer(scene, view, options, device, {});
    std::vector<image::Part> out;
    std::vector<float> zero;
    renderer.frames(0, frames + 1, [&](int64_t k, const std::vector<float>& rgb, const image::Moments&) {
        if (k == 0) return zero = rgb, true;
        image::Part& part = out.emplace_back();
        part.frames = 1;
        for (size_t i = 0; i < sensors.size(); ++i) part.grey.push_back(zero[3 * i] + rgb[3 * i]);
        return true;
    });
    return out;
}

// Mean over frames and its standard error.
struct Mean {
    double value = 0, error = 0;
};

std::vector<Mean> means_of(const scene::Scene& scene, const std::vector<Sensor>& sensors, bool irradiance, int frames,
                           const std::string& device, render::RenderOptions options) {
    std::vector<double> sum(sensors.size()), squares(sensors.size());
    for (const image::Part& part : frames_of(scene, sensors, irradiance, frames, device, options))
        for (size_t i = 0; i < sum.size(); ++i)
            sum[i] += double(part.grey[i]), squares[i] += double(part.grey[i]) * double(part.grey[i]);
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

namespace {
// The configuration factor of a rectangle from (x, y) to (x + a, y + b) in a parallel plane at the height h (Lambert).
double corner(double a, double b, double h) {
    const double r = std::hypot(a, h), s = std::hypot(b, h);
    return (a / r * std::atan(b / r) + b / s * std::atan(a / s)) / (2 * pi);
}
double rectangle(double x0, double x1, double y0, double y1, double h) {
    return corner(x1, y1, h) - corner(x0, y1, h) - corner(x1, y0, h) + corner(x0, y0, h);
}

struct Case {
    const char* name;
    std::string scene;
    std::vector<Sensor> sensors;
};

const base::Vec3 up{0, 0, 1};

std::vector<Sensor> along_x(const std::function<double(double)>& exact) {
    std::vector<Sensor> out;
    for (const double x : {0., .4, .8, 1.2}) out.push_back({{x, 0, 0}, up, exact(x)});
    return out;
}

std::vector<Case> nine_cases() {
    const std::string light = "void light l 0 0 3 5 5 5\n", black = "void plastic k 0 0 5 0 0 0 0 0\n",
                      walls =
                          "k polygon a 0 0 12 -8 -8 -1 8 -8 -1 8 -8 2 -8 -8 2\n"
                          "k polygon b 0 0 12 -8 8 -1 8 8 -1 8 8 2 -8 8 2\n"
                          "k polygon c 0 0 12 -8 -8 -1 -8 8 -1 -8 8 2 -8 -8 2\n"
                          "k polygon d 0 0 12 8 -8 -1 8 8 -1 8 8 2 8 -8 2\n",
                      square_hole = walls +
                                    "k polygon roof 0 0 30 -8 -8 2 -8 8 2 8 8 2 8 -8 2 -8 -8 2"
                                    " -1 -1 2 1 -1 2 1 1 2 -1 1 2 -1 -1 2\n",
                      overcast =
                          "void brightfunc b 2 skybr skybright.cal 0 3 2 1 .2\nb glow g 0 0 4 1 1 1 0\n"
                          "g source s 0 0 4 0 0 1 180\n";
    const auto square = [](double x) { return 5 * pi * rectangle(-1 - x, 1 - x, -1, 1, 2); };
    const double c = std::sqrt(.5);  // cosine of the rim of a round hole of radius 1 at the height 1
    return {{"a point", light + "l sphere s 0 0 4 0 0 3 .001\n",
             along_x([](double x) { return 5 * pi * 1e-6 * 3 / std::pow(9 + x * x, 1.5); })},
            {"a square", light + "l polygon p 0 0 12 -1 -1 2 -1 1 2 1 1 2 1 -1 2\n", along_x(square)},
            {"a disc",
             light + "l ring r 0 0 8 0 0 2 0 0 -1 0 1\n",
             {{{0, 0, 0}, up, 5 * pi / 5}, {{0, 0, 1}, up, 5 * pi / 2}, {{0, 0, -1}, up, 5 * pi / 10}}},
            {"a long source", light + "l polygon p 0 0 12 -.05 -10 2 -.05 10 2 .05 10 2 .05 -10 2\n",
             along_x([](double x) { return 5 * pi * rectangle(-.05 - x, .05 - x, -10, 10, 2); })},
            {"a uniform sky through an opening", uniform + black + square_hole,
             along_x([&](double x) { return square(x) / 5; })},
            {"an overcast sky through an opening",
             overcast + black + walls + "k ring roof 0 0 8 0 0 1 0 0 -1 1 12\n",
             {{{0, 0, 0}, up, 2 * pi / 3 * ((1 - c * c) / 2 + 2 * (1 - c * c * c) / 3)}}},
            {"a ball around a sensor",
             "void glow g 0 0 4 1 1 1 0\ng bubble b 0 0 4 0 0 0 3\n",
             {{{0, 0, 0}, up, pi}, {{1, 1, 1}, {1, 0, 0}, pi}}},
            {"a sensor on a wall",
             uniform + black + "k polygon w 0 0 12 0 -9 -9 0 9 -9 0 9 9 0 -9 9\n",
             {{{0, 0, -.5}, {1, 0, 0}, pi / 2}}},
            {"a sensor facing away",
             light + "l sphere s 0 0 4 0 0 3 .1\n",
             {{{0, 0, 0}, {0, 0, -1}, 0}, {{.2, 0, 5}, up, 0}}}};
}
}  // namespace

TEST_CASE("nine closed forms lie in their 95 % intervals, 16 frames, in 93 % of runs less three standard errors") {
    constexpr int runs = 6;
    int all = 0, held = 0;
    for (const Case& c : nine_cases()) {
        CAPTURE(c.name);
        const scene::Scene scene = laws::scene_of(c.scene);
        int of_case = 0, misses = 0;
        for (int run = 0; run < runs; ++run) {
            render::RenderOptions options;
            options.seed = uint64_t(run + 1);
            const std::vector<image::Part> parts = frames_of(scene, c.sensors, true, 16, "cpu", options);
            std::vector<float> mean(c.sensors.size());
            for (const image::Part& part : parts)
                for (size_t i = 0; i < mean.size(); ++i) mean[i] += part.grey[i] / float(parts.size());
            const auto values = uncertainty::noisy_values(parts, mean.data(), 0, mean.size(), 1);
            for (size_t i = 0; i < mean.size(); ++i) {
                const double exact = c.sensors[i].exact, rounding = 1e-5 * exact;
                const uncertainty::Interval limits = point_limits(values, i, .05);
                const bool holds = limits.low - rounding <= exact && exact <= limits.high + rounding;
                CAPTURE(exact);
                CAPTURE(limits.low);
                CAPTURE(limits.high);
                CHECK(limits.half_width() <= .05 * exact);
                of_case++, misses += !holds;
            }
        }
        CHECK(misses <= of_case / 4 + 1);
        all += of_case, held += of_case - misses;
    }
    CHECK(held >= .93 * all - 3 * std::sqrt(.05 * .95 * all));
}

// Pilots of the mixture weights begin at bounces, in the room, not on the sensors.
TEST_CASE("behind a window the sensors' directions are drawn toward it") {
    std::string text = uniform + "void glass pane 0 0 3 .96 .96 .96\nvoid plastic wall 0 0 5 .3 .3 .3 0 0\n";
    const auto polygon = [&](const std::string& corners) { text += "wall polygon w 0 0 12 " + corners + "\n"; };
    polygon("0 0 0  4 0 0  4 4 0  0 4 0");
    polygon("0 0 3  0 4 3  4 4 3  4 0 3");
    polygon("0 4 0  4 4 0  4 4 3  0 4 3");
    polygon("0 0 0  0 4 0  0 4 3  0 0 3");
    polygon("4 0 0  4 0 3  4 4 3  4 4 0");
    polygon("0 0 0  0 0 1.5  4 0 1.5  4 0 0");
    polygon("0 0 2.5  0 0 3  4 0 3  4 0 2.5");
    text += "pane polygon p 0 0 12  0 0 1.5  4 0 1.5  4 0 2.5  0 0 2.5\n";
    const scene::Scene scene = laws::scene_of(text);
    const std::vector<Sensor> sensors = {{{2, 3.5, .8}, {0, 0, 1}, 0}, {{2, 3.9, 1.5}, {0, -1, 0}, 0}};
    render::RenderOptions toward, plain;
    toward.sampling = render::Sampling::portals, plain.sampling = render::Sampling::plain;
    for (const std::string& device : laws::devices()) {
        CAPTURE(device);
        const std::vector<Mean> a = means_of(scene, sensors, true, 32, device, toward),
                                b = means_of(scene, sensors, true, 32, device, plain);
        for (size_t i = 0; i < sensors.size(); ++i) {
            CHECK(std::abs(a[i].value - b[i].value) <= 4 * std::hypot(a[i].error, b[i].error));
            CHECK(a[i].error < .7 * b[i].error);
        }
    }
}
