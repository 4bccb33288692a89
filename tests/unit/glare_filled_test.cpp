// SPDX-License-Identifier: BSD-3-Clause
// Columns of sources by what fills their pixels (filled.h): the same numbers whatever the size of the picture.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <random>

#include "base/warnings.h"
#include "glare/columns.h"
#include "report/sum.h"
#include "glare/filled.h"
#include "glare_pictures.h"

using namespace glare;
using namespace report;

namespace {

constexpr double pi = 3.14159265358979323846;

// An angular fisheye of a uniform surround with a disc of light in it, as small as the sun's, and the moments of its
// pixels.  place: of the disc's centre, in pixels from the left and from the bottom; on a corner of pixels it is in
// four of them.
struct SunPicture {
    double surround = 1000, L = 1e6, half_deg = .25;
    double beside = 0;  // share of the disc in the pixel on its left
    int side = 64;
    double omega() const { return 2 * pi * (1 - std::cos(half_deg * pi / 180)); }
    image::Picture at(double right, double up) const {
        image::Picture p = fisheye_of(std::vector<double>(size_t(side) * size_t(side), surround), side);
        const Geometry g(*p.header.view, side, side);
        std::vector<float> moments(image::moment_numbers * g.omega.size(), 0.0f);
        const bool corner = right == std::floor(right);
        for (int k = 0; k < (corner ? 4 : beside > 0 ? 2 : 1); ++k) {
            const int x = int(right) - k % 2, y = int(up) - k / 2;
            const size_t i = g.index(x, y);
            const double share = corner ? .25 : k == 1 ? beside : 1 - beside;
            const double c = share * omega() / g.omega[i], mean = c * L + (1 - c) * surround;
            for (size_t n = 0; n < 3; ++n) p.rgb[3 * i + n] = float(mean / cdm2_per_grey);
            float* m = &moments[image::moment_numbers * i];
            m[image::moment_variance] = float(c * (1 - c) * std::pow((L - surround) / cdm2_per_grey, 2));
            m[image::moment_right] = float((right - x - .5) * c * L / mean);
            m[image::moment_up] = float((up - y - .5) * c * L / mean);
        }
        p.moments = std::make_shared<const std::vector<float>>(std::move(moments));
        return p;
    }
    double dgp(double right, double up) const {
        const view::Projector projector(*fisheye_of({0}, 1).header.view);
        const auto dir = *projector.direction(right / side, up / side);
        const double P = position_index(projector, dir), cosine = dot(dir, *projector.direction(.5, .5));
        const double ev = pi * surround + (L - surround) * omega() * cosine;
        return 5.87e-5 * ev + .092 * std::log10(1 + L * L * omega() / (std::pow(ev, 1.87) * P * P)) + .159;
    }
};

std::map<std::string, double> measured(image::Picture p, const std::vector<std::string>& names) {
    ColumnChoice choice;
    choice.names = names;
    Requirements requirements;
    const Settings settings;
    const std::vector<Column> columns = choose_columns(choice, settings, requirements);
    const Measurement m = measure(read(make_plan({settings, requirements}), p, "picture"));
    std::map<std::string, double> out;
    for (const Column& c : columns) out[c.name] = c.value(m);
    return out;
}

const std::vector<std::string> metrics = {"DGP", "DGI", "UGR", "VCP", "CGI", "UGP", "n_sources"};

}  // namespace

TEST_CASE("the sun in a uniform surround, at any place of pixels of any size") {
    for (const int side : {64, 128, 256})
        for (const double place : {0., .5, .3, .9}) {
            CAPTURE(side);
            CAPTURE(place);
            SunPicture sun;
            sun.side = side;
            const double right = side / 2 + place, up = std::round(side * (.5 + 25. / 180)) + place;
            const auto m = measured(sun.at(right, up), {"DGP", "DGPf", "DGP.px", "DGPf.px", "n_sourcesf"});
            CHECK(m.at("DGPf") == doctest::Approx(sun.dgp(right, up)).epsilon(.001 / .5));
            CHECK(m.at("DGP.px") == doctest::Approx(m.at("DGPf") - m.at("DGP")));
            CHECK(m.at("n_sourcesf") == 1);
            CHECK(m.at("DGPf.px") == 0);
            if (side == 64) CHECK(m.at("DGP") < m.at("DGPf") - .02);
        }
}

TEST_CASE("a corner of the sun in a bright pixel: DGPf.px holds what a larger picture changes") {
    SunPicture sun;
    sun.L = 6e6, sun.half_deg = .1, sun.surround = 1800, sun.beside = .03;
    const double right = 32.01, up = 41.5;
    const auto m = measured(sun.at(right, up), {"DGPf", "DGPf.px"});
    const double off = sun.dgp(right, up) - m.at("DGPf");
    CHECK(off > .003);
    CHECK(m.at("DGPf.px") > off);
    CHECK(m.at("DGPf.px") < 3 * off);
}

TEST_CASE("light that samples found in pixels may be less even; a sun that is drawn is exact") {
    SunPicture lamp;
    lamp.L = 1e5, lamp.half_deg = .5, lamp.surround = 500;
    const SunPicture sun;
    const auto px = [](image::Picture p) { return measured(std::move(p), {"DGPf.px"}).at("DGPf.px"); };
    CHECK(px(sun.at(32.5, 41.5)) == 0);
    CHECK(px(lamp.at(32.7, 41.5)) < -.001);
}

TEST_CASE("a picture without structure inside of its pixels keeps its numbers; one without moments has no others") {
    std::vector<double> cdm2(64 * 64, 300);
    for (int y = 20; y < 25; ++y)
        for (int x = 30; x < 36; ++x) cdm2[size_t(64 * y + x)] = 9000;
    image::Picture plain = fisheye_of(cdm2, 64), even = plain;
    even.moments = std::make_shared<const std::vector<float>>(image::moment_numbers * 64 * 64, 0.0f);
    std::vector<std::string> names = metrics;
    for (const std::string& name : metrics) names.push_back(name + "f");
    names.insert(names.end(), {"classf", "DGP.px", "DGPf.px", "UGR.px", "UGRf.px"});
    base::set_warning_sink([](const std::string&) {});
    const auto without = measured(plain, names), with = measured(even, names);
    for (const std::string& name : metrics) {
        CAPTURE(name);
        CHECK(std::isnan(without.at(name + "f")));
        CHECK(with.at(name) == without.at(name));
    }
    for (const std::string name : {"classf", "DGP.px", "DGPf.px", "UGR.px", "UGRf.px"})
        CHECK_MESSAGE(std::isnan(without.at(name)), name);
    // the position index is that of the source's centre, not of the pixel there
    CHECK(with.at("DGPf") == doctest::Approx(with.at("DGP")).epsilon(.02));
    CHECK(with.at("n_sourcesf") == with.at("n_sources"));
}

TEST_CASE("both moments of a pixel are kept, and what no picture can have is borne") {
    image::Picture p = fisheye_of({100, 0, -5, 1e-9}, 2);
    std::vector<float> moments(16, 0.0f);
    for (size_t i = 0; i < 4; ++i) moments[image::moment_numbers * i] = 3.f;
    p.moments = std::make_shared<const std::vector<float>>(moments);
    const Luminance lum = make_luminance(p);
    const FilledPixels f = filled_pixels(lum);
    const double m1 = 100 / cdm2_per_grey;
    CHECK(f.grey[0] * f.share[0] == doctest::Approx(m1));
    CHECK(f.grey[0] * f.grey[0] * f.share[0] == doctest::Approx(m1 * m1 + 3));
    for (size_t i = 1; i < 4; ++i) CHECK(std::isfinite(f.grey[i] / f.share[i]));
    CHECK(f.share[1] == 1);
    CHECK(f.share[2] == 1);
}

// A window over a patch of sun, so many radians below it, by means and variances of the pixels.
static image::Picture window_and_patch(double gap_rad, int side) {
    constexpr int places = 16;
    const auto lum = [&](double right, double up) {  // from the middle, 1 at the rim
        const double edge = 3.7 / 32, gap = gap_rad / (pi / 2);
        if (std::fabs(right) < .3 && up > edge && up < .5) return 6000.;
        return std::fabs(right) < .4 && up < edge - gap && up > -.5 ? 2500. : 300.;
    };
    std::vector<double> means;
    std::vector<float> moments;
    for (int row = 0; row < side; ++row)
        for (int x = 0; x < side; ++x) {
            double sum = 0, squares = 0;
            for (int k = 0; k < places * places; ++k) {
                const double right = x + (k % places + .5) / places, down = row + (k / places + .5) / places;
                const double L = lum(2 * right / side - 1, 1 - 2 * down / side) / (places * places);
                sum += L, squares += L * L * places * places;
            }
            means.push_back(sum);
            moments.insert(moments.end(), {float((squares - sum * sum) / std::pow(cdm2_per_grey, 2)), 0, 0, 0});
        }
    image::Picture p = fisheye_of(means, side);
    p.moments = std::make_shared<const std::vector<float>>(std::move(moments));
    return p;
}

TEST_CASE("DGPf.px holds what a larger picture changes that parts two sources, and is 0 where their gap is clear") {
    const std::vector<std::string> names{"DGPf", "DGPf.px", "n_sourcesf"};
    const auto small = measured(window_and_patch(.115, 64), names),
               large = measured(window_and_patch(.115, 128), names);
    CHECK(small.at("n_sourcesf") == 1);
    CHECK(large.at("n_sourcesf") == 2);
    const double change = large.at("DGPf") - small.at("DGPf");
    CHECK(std::fabs(change) > .01);
    CHECK(small.at("DGPf.px") == doctest::Approx(change).epsilon(.05));
    for (const double gap : {.03, .25}) CHECK(measured(window_and_patch(gap, 64), names).at("DGPf.px") == 0);
}

// 200 streams in which the variance inside of each of four bright pixels is known from two noisy halves.
TEST_CASE("intervals of filled pixels know the error of their variance") {
    const SunPicture sun;
    const double right = 32, up = 41;
    std::mt19937 random(1);
    std::normal_distribution<double> noise;
    ColumnChoice choice;
    choice.names = {"DGPf"};
    Requirements requirements;
    const Settings settings;
    const std::vector<Column> columns = choose_columns(choice, settings, requirements);
    int covered = 0;
    constexpr int streams = 200;
    for (int s = 0; s < streams; ++s) {
        image::Picture p = sun.at(right, up);
        std::vector<float> moments = *p.moments;
        for (size_t i = 0; i < moments.size(); i += image::moment_numbers) {
            const double v = moments[i], first = v * (1 + .1 * noise(random)), second = v * (1 + .1 * noise(random));
            moments[i] = float((first + second) / 2), moments[i + 1] = float((first - second) / 2);
        }
        p.moments = std::make_shared<const std::vector<float>>(std::move(moments));
        const SharedPlan plan = make_plan({settings, requirements});
        Reading reading;
        Sum sum;
        for (int n = 1; n <= 4; ++n) {
            image::Picture step = p;
            for (float& value : step.rgb) value *= float(1 + 1e-4 * noise(random) / n);
            as_sum(step, n);
            reading = read(plan, step, "step", {}, std::move(reading));
            sum = add(std::move(sum), step, reading, "step", true);
            sum = look(std::move(sum), reading, measure(reading), columns, 0);
        }
        const uncertainty::Interval off = sum.look.estimate(0).around(.05, 4);
        const double value = sum.look.estimate(0).value, truth = sun.dgp(right, up);
        covered += value + off.low <= truth && truth <= value + off.high;
    }
    CHECK(covered >= .9 * streams);
}
