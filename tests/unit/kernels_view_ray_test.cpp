// SPDX-License-Identifier: BSD-3-Clause
// The device's rays against lib/view's double-precision ones, for the six projections with shift, lift and clipping:
// directions within 1e-6, origins within 1e-5 of the clipping distance.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>
#include "render/view_params.h"
#include "view/view.h"
namespace kernels {
#include "kernels/sampling/sampler.h"
#include "kernels/geom/view_ray.h"
}  // namespace kernels

TEST_CASE("the device looks where the view does") {
    for (const char type : {'v', 'l', 'a', 'h', 's', 'c'}) {
        view::View v;
        v.type = type;
        v.vp = {1, 2, 3};
        v.vd = {1, 2, -.3};
        v.vh = 70;
        v.vv = 50;
        v.vo = .25;
        v.va = 9;
        v.vs = .1;
        v.vl = -.2;
        const view::Projector projector(v);
        kernels::Params params{};
        render::set_view(params, v, {1, 1, 1});
        int rays = 0;
        for (int i = 0; i <= 20; ++i)
            for (int j = 0; j <= 20; ++j) {
                const double X = i / 20., Y = j / 20.;
                CAPTURE(type);
                CAPTURE(X);
                CAPTURE(Y);
                const auto want = projector.ray(X, Y);
                kernels::Ray got;
                const bool some = kernels::view_ray(&params, float(X), float(Y), &got) != 0;
                REQUIRE(some == bool(want));
                if (!some) continue;
                rays++;
                CHECK(std::abs(got.dir.x - want->dir.x) < 1e-6);
                CHECK(std::abs(got.dir.y - want->dir.y) < 1e-6);
                CHECK(std::abs(got.dir.z - want->dir.z) < 1e-6);
                CHECK(got.org.x + 1 == doctest::Approx(want->origin.x).epsilon(1e-5));
                CHECK(got.org.y + 1 == doctest::Approx(want->origin.y).epsilon(1e-5));
                CHECK(got.org.z + 1 == doctest::Approx(want->origin.z).epsilon(1e-5));
                CHECK(got.tmax == doctest::Approx(want->tmax).epsilon(1e-5));
            }
        CHECK(rays > 200);
    }
}

// With a lens the rays of one place start on a disc of that diameter and meet again at the focal distance |vd|: along
// the view axis in perspective and parallel views, along the ray in the round ones.
TEST_CASE("rays through the lens meet at the focal distance") {
    for (const char type : {'v', 'l', 'a', 'h', 's', 'c'}) {
        view::View v;
        v.type = type;
        v.vd = {0, 3, 0};
        v.vh = 70;
        v.vv = 50;
        const view::Projector projector(v);
        kernels::Params params{};
        render::set_view(params, v, {0, 0, 0});
        const auto middle = projector.ray(.3, .6);
        REQUIRE(bool(middle));
        const double to_focus = type == 'v' ? 3 / middle->dir.y : 3;
        const base::Vec3 focus = middle->origin + middle->dir * to_focus;
        params.lens_diameter = .4f;
        double widest = 0, sum = 0;
        int n = 0;
        for (int i = 0; i < 20; ++i)
            for (int j = 0; j < 20; ++j, ++n) {
                kernels::Ray ray{};
                kernels::float3 lens;
                lens.x = (float(i) + .5f) / 20;
                lens.y = (float(j) + .5f) / 20;
                lens.z = .25f;
                REQUIRE(kernels::view_lens_ray(&params, .3f, .6f, lens, &ray) != 0);
                const base::Vec3 o{ray.org.x, ray.org.y, ray.org.z}, d{ray.dir.x, ray.dir.y, ray.dir.z};
                CAPTURE(type);
                CHECK(length(cross(focus - o, d)) < 2e-6);
                const double across = std::hypot(o.x - middle->origin.x, o.z - middle->origin.z);
                widest = std::max(widest, across);
                sum += across * across;
            }
        CHECK(widest == doctest::Approx(.2).epsilon(.03));
        CHECK(sum / n == doctest::Approx(.02).epsilon(.01));  // even over the disc: half the squared radius
    }
}
