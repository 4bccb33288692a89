// SPDX-License-Identifier: BSD-3-Clause
// Pictures that differ in signs, measured at once and one by one: the same sources, the same numbers.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "comfort/columns.h"
#include "comfort/swayed_measure.h"
#include "comfort/swayed_rammg.h"
#include "comfort_pictures.h"

using namespace comfort;

namespace {

constexpr int width = 57, height = 50;

// Windows between 1000 and 100000 cd/m2 on a wall, all so noisy that pictures disagree about many pixels.
struct Noisy {
    std::vector<float> mean, off, calm, sway;
    std::vector<uint8_t> pattern;
    Signs signs;
    Noisy(uint32_t seed, int pictures, double noise) : signs(pictures, {0, 0, 0, 0}) {
        std::mt19937 random(seed);
        const auto uniform = [&](double low, double high) {
            return std::uniform_real_distribution<double>(low, high)(random);
        };
        std::array<uint32_t, 4> basis;
        for (uint32_t& word : basis) word = uint32_t(random()) & ((1u << pictures) - 1);
        signs = Signs(pictures, basis);
        pattern = Signs::weave(width, height, 0);
        mean.assign(size_t(width) * height, 0);
        for (float& v : mean) v = float(uniform(200, 900) / cdm2_per_grey);
        for (int k = 0; k < 6; ++k) {
            const int x0 = int(uniform(0, width - 9)), y0 = int(uniform(0, height - 9));
            const float light = float(1000 * std::pow(100., uniform(0, 1)) / cdm2_per_grey);
            for (int y = y0; y < y0 + int(uniform(3, 9)); ++y)
                for (int x = x0; x < x0 + 8; ++x) mean[size_t(y) * width + size_t(x)] = light;
        }
        for (size_t i = 0; i < mean.size(); ++i) {
            const bool glimpse = uniform(0, 1) < 0.03;
            off.push_back(mean[i] * float(uniform(-noise, noise) * (glimpse ? 3 : 1)));
            const bool doubtful = uniform(0, 1) < 0.3;
            calm.push_back(mean[i] * float(glimpse ? uniform(1, 6) : 1));
            sway.push_back(doubtful ? off.back() * 2 : 0);
        }
    }
    Swayed pictures() const { return {width, height, mean.data(), off.data(), pattern.data(), &signs}; }
    std::vector<Doubtful> in_doubt() const {
        std::vector<Doubtful> out;
        for (uint32_t p = 0; p < calm.size(); ++p)
            if (calm[p] != mean[p] || sway[p] != 0) out.push_back({p, calm[p], sway[p]});
        return out;
    }
};

using Sources = std::vector<GlareSource>;

void check_same(Sources a, Sources b) {
    const auto order = [](const GlareSource& s, const GlareSource& t) { return s.x + 1000 * s.y < t.x + 1000 * t.y; };
    std::sort(a.begin(), a.end(), order), std::sort(b.begin(), b.end(), order);
    REQUIRE(a.size() == b.size());
    for (size_t s = 0; s < a.size(); ++s) {
        CHECK(a[s].pixels == b[s].pixels);
        for (const auto member : {&GlareSource::omega, &GlareSource::lum, &GlareSource::x, &GlareSource::y,
                                  &GlareSource::eye_lux, &GlareSource::P, &GlareSource::sigma_deg})
            CHECK(a[s].*member == doctest::Approx(b[s].*member).epsilon(1e-11));
    }
}

// Returns how many different numbers of sources the pictures have.
size_t compare(const Settings& settings, const Noisy& noisy, double field_deg) {
    Needs needs;
    ColumnChoice choice;
    choice.names = {"Ev",   "DGP",       "class",  "DGI",       "UGR",           "VCP",       "CGI",  "UGP",
                    "UGP2", "DGImod",    "UGRexp", "DGR",       "Lveil",         "LveilCIE",  "Lavg", "Lmax",
                    "Lb",   "threshold", "Edir",   "n_sources", "omega_sources", "L_sources", "Lt"};
    const std::vector<Column> columns = choose_columns(choice, settings, needs);
    Meter meter(settings, needs);
    std::vector<double> cdm2;
    for (const float v : noisy.mean) cdm2.push_back(v * cdm2_per_grey);
    image::Picture p = fisheye_of(cdm2, width, field_deg);
    Luminance lum = meter.read(p, "mean");
    std::copy(noisy.mean.begin(), noisy.mean.end(), lum.grey);
    const Measurement m = meter.measure(lum, "mean");

    const Swayed pictures = noisy.pictures();
    const std::vector<Doubtful> in_doubt = noisy.in_doubt();
    const Calmed bright(pictures, in_doubt);
    const auto at_once = measure(pictures, bright, lum, m, meter);
    const auto one_by_one = measure_one_by_one(pictures, bright, lum, m, meter);
    REQUIRE(at_once.own.size() == one_by_one.own.size());
    std::set<size_t> counts;
    for (size_t k = 0; k < at_once.own.size(); ++k) {
        INFO("picture " << k);
        counts.insert(one_by_one.own[k].sources.size());
        check_same(at_once.own[k].sources, one_by_one.own[k].sources);
        check_same(at_once.of_mean[k].sources, one_by_one.of_mean[k].sources);
        for (const Column& c : columns) {
            INFO(c.name);
            CHECK(c.value(at_once.own[k]) == doctest::Approx(c.value(one_by_one.own[k])).epsilon(1e-6));
            CHECK(c.value(at_once.of_mean[k]) == doctest::Approx(c.value(one_by_one.of_mean[k])).epsilon(1e-6));
        }
    }
    check_same(at_once.calm.sources, one_by_one.calm.sources);
    return counts.size();
}

}  // namespace

TEST_CASE("sources of many pictures are those of each") {
    size_t different = 0;
    for (uint32_t seed = 1; seed <= 12; ++seed) {
        INFO("seed " << seed);
        Settings s;
        const Noisy noisy(seed, seed % 3 ? 16 : 4, seed % 2 ? 0.3 : 0.02);
        different += compare(s, noisy, seed % 4 ? 180 : 60);
    }
    CHECK(different > 24);  // 12 if pictures never disagreed
}

TEST_CASE("the same with other thresholds, radii and peaks") {
    const Noisy noisy(78, 16, 0.3);
    Settings s;
    s.threshold = 4;  // times the mean of each picture
    CHECK(compare(s, noisy, 180) > 1);
    for (const double opening : {0.03, 0.07, 0.5, 7.}) {  // pixels that do not touch; all that is bright is one
        s = {};
        s.search_opening = opening;
        CHECK(compare(s, noisy, 180) > (opening == 7 ? 0 : 1));
    }
    s = {};
    s.peak_limit = 6000;
    CHECK(compare(s, noisy, 180) > 1);
    s.peaks = false;
    CHECK(compare(s, noisy, 180) > 1);
}

// What sums by word rest on: the product of two words is a word, pixels 16 apart in a row have the same one, and each
// row has all that are wanted.
TEST_CASE("words of signs") {
    const Signs signs(16, {0xaaaa, 0xcccc, 0xf0f0, 0x1234});
    for (unsigned v = 0; v < Signs::words; ++v)
        for (unsigned w = 0; w < Signs::words; ++w) CHECK(signs.minus[v ^ w] == (signs.minus[v] ^ signs.minus[w]));
    for (unsigned p = 0; p < Signs::words; ++p) CHECK(signs.minus[p | Signs::turned] == (signs.minus[p] ^ 0xffff));

    const int w = 70, h = 200;
    const std::vector<uint8_t> pattern = Signs::weave(w, h, 1);
    int turned = 0;
    for (size_t row = 0; row < pattern.size(); row += w) {
        std::set<unsigned> words;
        for (size_t x = 0; x < w; ++x) {
            words.insert(pattern[row + x] % Signs::turned);
            CHECK(pattern[row + x] % Signs::turned == pattern[row + x % Signs::words] % Signs::turned);
            turned += (pattern[row + x] & Signs::turned) != 0;
        }
        CHECK(words.size() == 15);
        CHECK(words.count(0) == 0);
    }
    CHECK(std::abs(turned - w * h / 2) < 3 * std::sqrt(w * h / 4.));
}

TEST_CASE("RAMMG of many pictures is that of each") {
    for (const auto& [w, h, field] : {std::tuple(57, 50, 180.), {64, 33, 60.}, {3, 3, 180.}, {2, 40, 60.}})
        for (const RammgArea area : {RammgArea::view, RammgArea::rectangle}) {
            INFO(w << " x " << h);
            const Noisy noisy(5, 16, 0.3);
            const std::vector<uint8_t> pattern = Signs::weave(w, h, 0);
            const Swayed s{w, h, noisy.mean.data(), noisy.off.data(), pattern.data(), &noisy.signs};
            view::View view;
            view.type = 'a';
            view.vh = view.vv = field;
            const Geometry geometry(view, w, h);
            const auto all = rammg(s, geometry, area);
            GreyPicture picture;
            for (int k = 0; k < s.count(); ++k) {
                s.picture(k, picture);
                const double own = rammg(picture.luminance(), geometry, area);
                if (std::isnan(own)) CHECK(std::isnan(all[size_t(k)]));
                else CHECK(all[size_t(k)] == doctest::Approx(own).epsilon(1e-7));
            }
        }
}
