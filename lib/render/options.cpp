// SPDX-License-Identifier: BSD-3-Clause
// Declarations of the rendering options (CONTRIBUTING.md, "Add an option").  moves_pixels() adds an option to the
// fingerprint (fingerprint.cpp); tests/unit/ptrace_options_test.cpp lists the others.
#include "render/options.h"

#include "base/options.h"

namespace render {
namespace {

// A number or a word.
base::Action bounces(int& ab) {
    const auto read = [&ab](base::Arguments& a) {
        ab = a.next_is("unlimited") ? no_limit : int(a.integer(base::within(0, 10000)));
    };
    return {read, [&ab] { return ab == no_limit ? "unlimited" : std::to_string(ab); }};
}

}  // namespace

void declare_options(base::OptionTable& t, RenderOptions& r) {
    t.group("Picture");
    t.add("-pj f", "Pixel jitter: 0 samples pixel centres, 1 the whole pixel", r.pj)
        .within(0, 1)
        .share()
        .from_scene()
        .moves_pixels();
    t.add("-pd d", "Diameter of the lens for depth of field", r.pd).at_least(0).from_scene().moves_pixels();
    t.add("-i[+-]", "Irradiance on the surfaces seen instead of radiance", r.i).from_scene().moves_pixels();

    t.group("Light");
    t.add("-ab n", "Diffuse bounces, a number or unlimited", bounces(r.ab)).from_scene().moves_pixels();
    t.add("-av r g b", "Radiance in place of all light beyond the last bounce of -ab n", r.av)
        .at_least(0)
        .from_scene()
        .moves_pixels();
    t.add("-st f", "Specular threshold: highlights weaker than this are left out", r.st)
        .within(0, 1)
        .share()
        .from_scene()
        .moves_pixels();
    t.add("-ss f", "Specular sampling", r.ss).at_least(0).from_scene().moves_pixels();
    t.add("-dj f", "Direct jitter: 0 samples the centre of a source, 1 all of it", r.dj)
        .within(0, 1)
        .share()
        .from_scene()
        .moves_pixels();
    t.add("-ds f", "Divide light sources as RADIANCE does; 0 samples their true shape", r.ds)
        .at_least(0)
        .from_scene()
        .moves_pixels();
    t.add("-dr n", "Virtual source relays: how many mirrors and prisms light may pass", r.dr)
        .within(0, 100)
        .from_scene()
        .moves_pixels();
    t.add("-dp n", "Presampling of virtual sources: no effect", r.dp).at_least(0).from_scene();
    t.add("-dv[+-]", "Light sources are visible", r.dv).from_scene().moves_pixels();
    t.add("-bv[+-]", "Back faces of opaque surfaces are visible", r.bv).from_scene().moves_pixels();
    t.add("-any-reflectance[+-]", "Render materials that give back twice the light that they get, or more",
          r.any_reflectance);
    t.add("-sampling name", "How diffuse rays are sampled: plain, portals or reuse",
          base::one_of(r.sampling, {{"plain", Sampling::plain},
                                    {"portals", Sampling::portals},
                                    {"reuse", Sampling::reuse},
                                    {"shared", Sampling::reuse}}))  // the name before 0.1.0
        .moves_pixels();
    t.add("-noisy-share f", "Extra samples for the noisiest pixels, as a share of the picture's; 0 for none",
          r.noisy_share)
        .within(0, 100)
        .share()
        .moves_pixels();
    t.add("-u[+-]", "Uncorrelated samples: no effect", r.u).from_scene();
    t.add("-lr n", "Largest number of reflections of a path; 0 for no limit, below 0 without the limit of -lw", r.lr)
        .within(-10000, 10000)
        .from_scene()
        .moves_pixels();
    t.add("-lw f", "Weight below which a path ends, where -lr is above 0", r.lw)
        .at_least(0)
        .from_scene()
        .moves_pixels();
    t.add("-me r g b", "Extinction coefficient of the air, per unit of length", r.me)
        .at_least(0)
        .from_scene()
        .moves_pixels();
    t.add("-ma r g b", "Scattering albedo of the air", r.ma).at_least(0).from_scene().moves_pixels();
    t.add("-mg f", "Scattering eccentricity of the air", r.mg).within(0, 1).from_scene().moves_pixels();
    t.add("-ms d", "Sampling distance in mist: no effect", r.ms).at_least(0).from_scene();
}

}  // namespace render
