// SPDX-License-Identifier: BSD-3-Clause
// Lamps of four to eight corners, each up to 1 % of the size off their plane, on a grid above a floor, against a closed
// form, on every device.  `lamps_test -ns` takes a thousand of them.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "physics/laws.h"

#include <fmt/core.h>
#include <random>

#include "base/vec.h"

using namespace laws;
using base::Vec3;

namespace {

// A polygon is drawn flat: its corners go to their mean plane, along the axis that it faces most.  With unit directions
// r_i to these, a radiance of 1 gives the irradiance  1/2 sum_i acos(r_i . r_i+1) z . (r_i x r_i+1) / |r_i x r_i+1|
// (Lambert, Photometria, 1760).
class Lamp {
public:
    explicit Lamp(std::vector<Vec3> given) : corners_(std::move(given)) {
        const auto& v = corners_;
        for (size_t i = 1; i + 1 < v.size(); i++) normal_ = normal_ + cross(v[i] - v[0], v[i + 1] - v[0]);
        normal_ = unit(normal_);
        for (const Vec3& p : v) middle_ = middle_ + p * (1 / double(v.size()));
        int axis = 0;
        for (int k : {1, 2})
            if (std::abs(normal_[k]) > std::abs(normal_[axis])) axis = k;
        for (Vec3& p : corners_) p[axis] += dot(middle_ - p, normal_) / normal_[axis];
    }
    double irradiance(Vec3 p) const {
        if (dot(p - middle_, normal_) <= 0) return 0;
        double sum = 0;
        for (size_t i = 0; i < corners_.size(); i++) {
            const Vec3 a = unit(corners_[i] - p), b = unit(corners_[(i + 1) % corners_.size()] - p);
            sum += std::acos(dot(a, b)) * unit(cross(a, b)).z / 2;
        }
        return std::abs(sum);
    }

private:
    std::vector<Vec3> corners_;
    Vec3 middle_, normal_;
};

constexpr int lamps_in_scene = 36, row = 6;
constexpr double spacing = 12, height = 2;

Vec3 place_of(int lamp, double z) { return {(lamp % row - 2.5) * spacing, (lamp / row - 2.5) * spacing, z}; }

void expect_lamps(unsigned seed, double off_plane, long samples) {
    std::mt19937 random(seed);
    const auto uniform = [&](double least, double most) {
        return std::uniform_real_distribution<double>(least, most)(random);
    };
    std::string text =
        "void plastic mat 0 0 5 .5 .5 .5 0 0\nmat ring floor 0 0 8 0 0 0 0 0 1 0 60\n"
        "void light l 0 0 3 1 1 1\nvoid glow g 0 0 4 1 1 1 200\nvoid spotlight s 0 0 7 1 1 1 360 0 0 -1e-6\n";
    std::vector<Lamp> lamps;
    for (int i = 0; i < lamps_in_scene; i++) {
        const double size = uniform(.3, 1.3), tilt = uniform(0, .9), turn = uniform(0, 2 * pi);
        const Vec3 down{std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn), -std::cos(tilt)};
        const Vec3 u = unit(cross(down, {.3, 1, .2})), v = cross(down, u);
        const int count = 4 + i % 5;
        const double off = count == 4 && i % 2 ? off_plane / 100 : off_plane;
        text += fmt::format("{} polygon p{} 0 0 {}", "lgs"[i % 3], i, 3 * count);
        std::vector<Vec3> corners;
        for (int k = 0; k < count; k++) {
            const double angle = 2 * pi * (k + uniform(0, .6)) / count, r = size * uniform(.25, .5);
            corners.push_back(place_of(i, height) + u * (r * std::cos(angle)) + v * (r * std::sin(angle)) +
                              down * (size * uniform(-off, off)));
            text += fmt::format(" {} {} {}", corners.back().x, corners.back().y, corners.back().z);
        }
        text += "\n";
        lamps.emplace_back(corners);
    }

    const scene::Scene scene = scene_of(text);
    for (const std::string& device : devices()) {
        CAPTURE(device);
        render::Renderer renderer(scene, view::View(), 1, 1, direct_only(), device, {});
        for (int i = 0; i < lamps_in_scene; i++) {
            CAPTURE(i);
            const Vec3 at = place_of(i, 0), eye = at + Vec3{.3, .2, .5}, dir = at - eye;
            double want = 0;
            for (const Lamp& lamp : lamps) want += .5 / pi * lamp.irradiance(at);
            const auto value = trace_ray(renderer, &eye.x, &dir.x, samples);
            CHECK_MESSAGE(std::abs(value.mean[0] - want) <= 4 * value.error[0] + 1e-4 * want, value.mean[0], " +- ",
                          value.error[0], ", exact ", want);
            CHECK(value.error[0] <= .01 * want);
        }
    }
}

}  // namespace

TEST_CASE("lamps whose corners are not in a plane shine as they are drawn") {
    expect_lamps(1, .01, 4096);
    expect_lamps(2, 1e-5, 4096);
}

TEST_CASE("a thousand lamps" * doctest::skip()) {
    for (unsigned seed = 100; seed < 128; seed++) expect_lamps(seed, seed % 2 ? .01 : .001, 16384);
}
