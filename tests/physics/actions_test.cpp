// SPDX-License-Identifier: BSD-3-Clause
// Light by an action, in scenes whose light can be written down: by bands, on every device, and by the product of the
// spectra.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "physics/laws.h"

#include <fmt/core.h>

#include <algorithm>

#include "render/action.h"
#include "spectrum/illuminants.h"
#include "unit/renderer.h"
#include "unit/scene_text.h"

using namespace laws;
using spectrum::Colour, spectrum::Spectrum;

static flatten::LightSpectra lit_by(const std::string& illuminant = "D65") {
    return {{}, spectrum::illuminant(illuminant, "")};
}

static std::vector<render::ActionPart> parts_of(const std::string& action, const flatten::LightSpectra& lights) {
    return render::parts_of(spectrum::action_of(action), 9, lights);
}

// The value of a ray by the action: the sum of all parts, whose expected colours are those of a function.
template <class ColourOf>
static double value_by_bands(const std::string& text, const std::string& action, const flatten::LightSpectra& lights,
                             const Ray& ray, const ColourOf& colour_of, long samples = 64) {
    double sum = 0;
    for (const render::ActionPart& part : parts_of(action, lights)) {
        const Colour c = colour_of(part.colours->bands);
        render::RenderOptions options;
        options.bands = part.colours;
        expect(text, options, ray, {c[0], c[1], c[2]}, samples, .03);
        for (size_t k = 0; k < 3; k++) sum += part.weights[k] * c[k];
    }
    return sum;
}

static double off_percent(double value, double truth) { return 100 * std::fabs(value / truth - 1); }

// A spectral primitive with these values from 380 to 780 nm by 5 nm.
static std::string primitive(const std::string& name, const Spectrum& s) {
    std::string text = "void spectrum " + name + " 0 0 83 380 780";
    for (size_t i = 0; i < s.size(); i += 5) text += fmt::format(" {:.9g}", s[i]);
    return text + "\n";
}
static Spectrum by_5_nm(const Spectrum& s) {
    double values[81];
    for (size_t i = 0; i < 81; i++) values[i] = s[5 * i];
    return spectrum::of_table(values, 5);
}

static const std::string sky = "sky source dome 0 0 4 0 0 1 360\n";
static const std::string grey_sky = "void glow sky 0 0 4 10 10 10 0\n" + sky;
static const Ray up{{0, 0, 0}, {0, 0, 1}};

TEST_CASE("a grey sky under D65 has by each action the value that it has by V, whatever the action") {
    for (const char* action : {"mel", "rh", "sc", "mc", "lc", "V"}) {
        const double v = value_by_bands(grey_sky, action, lit_by(), up, [&](const spectrum::Bands& b) {
            return colour_of_light(b, Colour{10, 10, 10}, spectrum::d65());
        });
        CHECK(v == doctest::Approx(10));
    }
}

TEST_CASE("a sky with the spectrum of an illuminant has its daylight ratio, from a primitive and by name") {
    for (const char* name : {"A", "E", "F11", "LED-B3"}) {
        const Spectrum s = by_5_nm(spectrum::illuminant(name, ""));
        const auto of_spectrum = [&](const spectrum::Bands& b) { return colour_of_light(b, s); };
        const std::string text = primitive("s", s) + "s glow sky 0 0 4 1 1 1 0\n" + sky;
        const double mel = value_by_bands(text, "mel", lit_by(), up, of_spectrum);
        const double v = value_by_bands(text, "V", lit_by(), up, of_spectrum);
        CHECK(off_percent(mel / v, daylight_ratio(spectrum::action_of("mel"), s)) < 1e-6);
        const double by_name = value_by_bands(grey_sky, "mel", lit_by(name), up, [&](const spectrum::Bands& b) {
            return colour_of_light(b, Colour{10, 10, 10}, spectrum::illuminant(name, ""));
        });
        const Spectrum exact = spectrum::illuminant(name, "");
        CHECK(off_percent(by_name / 10, daylight_ratio(spectrum::action_of("mel"), exact)) < 1e-6);
    }
}

// Diffuse, under a uniform sky: all samples are the reflectance times the sky.
TEST_CASE("coloured ground under a grey sky: by RGB, by a pattern and by a spectrum") {
    const std::string ground = "m ring ground 0 0 8 0 0 0 0 0 1 0 100\n";
    const Ray down{{0, 0, 1}, {0, 0, -1}};
    const Colour rgb{.7, .3, .1};
    const auto of_rgb = [&](const spectrum::Bands& b) {
        Colour c = colour_of_light(b, Colour{10, 10, 10}, spectrum::d65());
        const Colour r = colour_of_surface(b, rgb);
        for (size_t k = 0; k < 3; k++) c[k] *= r[k];
        return c;
    };
    const double v =
        value_by_bands(grey_sky + "void plastic m 0 0 5 .7 .3 .1 0 0\n" + ground, "mel", lit_by(), down, of_rgb);
    value_by_bands(grey_sky + "void colorfunc c 4 .7 .3 .1 . 0 0\nc plastic m 0 0 5 1 1 1 0 0\n" + ground, "mel",
                   lit_by(), down, of_rgb);
    value_by_bands(grey_sky + "void spectrum c 0 0 5 780 380 .7 .3 .1\nc plastic m 0 0 5 1 1 1 0 0\n" + ground, "mel",
                   lit_by(), down, of_rgb);
    const Spectrum up = spectrum::upsampled(rgb);
    double truth = 0;
    for (size_t i = 0; i < up.size(); i++) truth += spectrum::action_of("mel").value[i] * spectrum::d65()[i] * up[i];
    CHECK(off_percent(v, 10 * truth / spectrum::dot(spectrum::by_v().value, spectrum::d65())) < .01);
}

// Panes of glass: transmittance t (1 - r)^2 / (1 - (r t)^2) straight through, r = .0426 for the index 1.52.
TEST_CASE("a tinted pane before a sky") {
    const Spectrum tint =
        by_5_nm(spectrum::sampled([](double nm) { return .1 + .8 * std::exp(-std::pow((nm - 460) / 60, 2)); }));
    const std::string text = "void glow sky 0 0 4 10 10 10 0\nsky source dome 0 0 4 0 0 1 180\n" +
                             primitive("t", tint) +
                             "t glass pane 0 0 3 1 1 1\npane ring window 0 0 8 0 0 1 0 0 1 0 9\n";
    const auto through = [](double t) {
        const double r = std::pow(.52 / 2.52, 2);
        return t * (1 - r) * (1 - r) / (1 - r * r * t * t);
    };
    const double v = value_by_bands(
        text, "mel", lit_by(), up,
        [&](const spectrum::Bands& b) {
            Colour c = colour_of_light(b, Colour{10, 10, 10}, spectrum::d65());
            const Colour t = colour_of_surface(b, tint);
            for (size_t k = 0; k < 3; k++) c[k] *= through(t[k]);
            return c;
        },
        1024);
    double truth = 0;
    for (size_t i = 0; i < tint.size(); i++)
        truth += spectrum::action_of("mel").value[i] * spectrum::d65()[i] * through(tint[i]);
    CHECK(off_percent(v, 10 * truth / spectrum::dot(spectrum::by_v().value, spectrum::d65())) < .1);
}

// The closed sphere of closed_forms_test: L = L0 (r/R)^2 p/(1 - p (1 - (r/R)^2)), now for each wavelength.  The wall
// has .3, .6 or .9 at 450 nm and .8 at 600.
TEST_CASE("light trapped in a coloured sphere") {
    const std::string room = "lm sphere bulb 0 0 4 0 0 0 .01\nwall bubble room 0 0 4 0 0 0 1\n";
    const auto trapped = [](double p) { return 1e-4 * p / (1 - p * (1 - 1e-4)); };
    const Spectrum lamp = spectrum::illuminant("LED-B3", "");
    const flatten::LightSpectra lights{{{"lm", lamp}}, spectrum::illuminant("A", "")};
    for (const double blue : {.3, .6, .9}) {
        CAPTURE(blue);
        const Spectrum wall = by_5_nm(spectrum::sampled([&](double nm) {
            const double t = std::clamp((nm - 450) / 150, 0., 1.);
            return blue + (.8 - blue) * t * t * (3 - 2 * t);
        }));
        const std::string text =
            "void light lm 0 0 3 1000 1000 1000\n" + primitive("c", wall) + "c plastic wall 0 0 5 1 1 1 0 0\n" + room;
        const double v = value_by_bands(
            text, "mel", lights, {{.5, 0, 0}, {1, .3, .2}},
            [&](const spectrum::Bands& b) {
                Colour c = colour_of_light(b, Colour{1000, 1000, 1000}, lamp);
                const Colour p = colour_of_surface(b, wall);
                for (size_t k = 0; k < 3; k++) c[k] *= trapped(p[k]);
                return c;
            },
            1024);
        double truth = 0;
        for (size_t i = 0; i < wall.size(); i++)
            truth += spectrum::action_of("mel").value[i] * lamp[i] * trapped(wall[i]);
        CHECK(off_percent(v, 1000 * truth / spectrum::dot(spectrum::by_v().value, lamp)) < 1.2);
    }
}

TEST_CASE("frames of an action: grey, the sum of their parts, the same for light given by daylight") {
    const scene::Scene scene =
        scene_of(grey_sky + "void plastic m 0 0 5 .7 .3 .1 0 0\nm ring ground 0 0 8 0 0 0 0 0 1 0 100\n");
    const auto device = render::make_device("cpu");
    view::View eye;
    eye.vp = {0, 0, 1};
    eye.vd = {0, 1, -.2};
    std::vector<render::ActionPart> parts = parts_of("mel", lit_by());
    std::vector<std::vector<float>> frames;
    std::vector<std::string> fingerprints;
    for (int of_daylight = 0; of_daylight < 2; of_daylight++) {
        std::vector<render::ViewPlan> plans;
        for (const render::ActionPart& part : parts) {
            const render::Setup setup = in_bands({{eye, 8, 8}, {}, {}}, part);
            plans.push_back(plan_view(*device, load_scene(scene, setup.options, {}), setup.view, setup.options));
            fingerprints.push_back(plans.back().fingerprint);
        }
        fingerprints.push_back(render::action_fingerprint(plans));
        render_action(*device, parts, plans, 0, 3, [&](int64_t, const std::vector<float>& rgb) {
            frames.push_back(rgb);
            return true;
        });
        parts = render::parts_by_daylight(parts_of("mel", lit_by()));
    }
    REQUIRE(frames.size() == 6);
    for (size_t i = 0; i < frames[0].size(); i++) {
        const size_t row = i / 24;  // the sky fills the first ones, the ground the last
        CHECK(frames[0][i] == frames[0][i - i % 3]);
        if (row < 2) CHECK(frames[0][i] == doctest::Approx(10).epsilon(1e-5));
        for (size_t k = 0; k < 3; k++) CHECK(frames[3 + k][i] == doctest::Approx(frames[k][i]).epsilon(1e-3));
    }
    std::sort(fingerprints.begin(), fingerprints.end());
    CHECK(std::unique(fingerprints.begin(), fingerprints.end()) == fingerprints.end());
}

TEST_CASE("faults of spectra in a scene are told with their place") {
    const auto fault = [](const std::string& text) {
        render::RenderOptions options;
        options.bands = parts_of("mel", lit_by())[0].colours;
        const std::string said = error_of([&] { flatten::flatten(scene_of(text), options, {}); });
        return said.substr(std::min(said.size(), said.find(":")));
    };
    const std::string ball = "m sphere ball 0 0 4 0 0 0 1\n";
    CHECK(fault("void spectrum s 0 0 6 380 780 .1 -.2 .3 .4\ns plastic m 0 0 5 1 1 1 0 0\n" + ball) ==
          ":1: a spectrum is not negative: -0.2 at 513.333 nm");
    CHECK(fault("void spectrum s 0 0 6 800 900 .1 .2 .3 .4\ns plastic m 0 0 5 1 1 1 0 0\n" + ball) ==
          ":1: 800 to 900 nm is outside of 380 to 780 nm");
    CHECK(fault("void spectrum s 0 0 6 380 780 .1 .2 .3 .4\ns plastic m 0 0 5 1 1 1 0 0\n" + ball +
                "s glow g 0 0 4 1 1 1 0\ng source sky 0 0 4 0 0 1 360\n") ==
          ":1: a spectrum of lights and of surfaces: with -action, give each its own");
}

TEST_CASE("what has no spectrum is named once") {
    const scene::Scene scene = scene_of(
        "void glow sky 0 0 4 1 1 1 0\nsky source dome 0 0 4 0 0 1 360\nvoid light lamp 0 0 3 1 1 1\n"
        "lamp sphere bulb 0 0 4 0 0 0 1\nvoid plastic red 0 0 5 .5 .1 .1 0 0\nred sphere a 0 0 4 9 0 0 1\n"
        "red sphere b 0 0 4 0 9 0 1\nvoid plastic grey 0 0 5 .5 .5 .5 0 0\ngrey sphere c 0 0 4 0 9 9 1\n" +
        primitive("s", spectrum::d65()) + "s light sun 0 0 3 1 1 1\nsun source disc 0 0 4 0 1 1 .5\n");
    flatten::LightSpectra lights = lit_by();
    lights.lamps = {{"lamp", lights.daylight}, {"lampe", lights.daylight}, {"sun", lights.daylight}};
    const flatten::Guessed guessed = flatten::guessed_spectra(scene, lights);
    CHECK(guessed.lights == std::vector<std::string>{"sky"});
    CHECK(guessed.surfaces == std::vector<std::string>{"red"});
    CHECK(guessed.lamps == std::vector<std::string>{"lampe", "sun"});
}
