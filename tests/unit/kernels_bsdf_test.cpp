// SPDX-License-Identifier: BSD-3-Clause
// BSDF tables as the kernels use them: what the file says is found again, samples carry the hemispherical energy, and
// they fall where the evaluation says they should.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include "kernels/dialect/host.h"
namespace kernels {
#include "kernels/sampling/sampler.h"
#include "kernels/material/bsdf.h"
#include "kernels/material/bsdf_sample.h"
}  // namespace kernels
#include "flatten/bsdf.h"
#include "unit/bsdf_text.h"

using namespace kernels;
constexpr double PI = 3.14159265358979323846;

struct Tables {
    cal::Code code;
    flatten::BsdfRecords records;
    scene::Bsdf file;
    uint32_t at;
    SceneTables s = {};
    explicit Tables(const std::string& text) : file(scene::parse_bsdf(text, "test.xml")) {
        at = flatten::add_bsdf(file, nullptr, records, code, "test.xml");
        s.bsdf_components = records.components.data();
        s.bsdf_tables = records.tables.data();
        s.bsdf_rings = records.rings.data();
        s.u = code.words.data();
        s.f = code.floats.data();
    }
    // front: v on the side of the normal
    const BsdfComponent& component(int front, int transmit) const {
        return records.components[at + size_t((front ? 0 : 2) + transmit)];
    }
    const BsdfTable* table(int front, int transmit) const { return &records.tables[component(front, transmit).table]; }
    float diffuse(int front, int transmit) const { return component(front, transmit).lambertian; }
};

static float3 direction(double theta_deg, double phi_deg, double side = 1) {
    const double t = theta_deg * PI / 180, p = phi_deg * PI / 180;
    return F3(float(std::sin(t) * std::cos(p)), float(std::sin(t) * std::sin(p)), float(side * std::cos(t)));
}
static Sampler random_stream(uint32_t i) { return sampler_start(1, 2, i, 0, 0); }

TEST_CASE("disc and square are each other's inverse and keep areas") {
    for (double x = .01; x < 1; x += .07)
        for (double y = .01; y < 1; y += .07) {
            const float2 d = bsdf_disc(float(x), float(y)), q = bsdf_square(d.x, d.y);
            CHECK(q.x == doctest::Approx(x).epsilon(1e-5));
            CHECK(q.y == doctest::Approx(y).epsilon(1e-5));
            const double h = 1e-3;  // |d disc / d square| = pi, except on the diagonals
            if (std::fabs(x - y) < .01 || std::fabs(x + y - 1) < .01) continue;
            const float2 a = bsdf_disc(float(x + h), float(y)), b = bsdf_disc(float(x), float(y + h));
            CHECK(std::fabs((a.x - d.x) * (b.y - d.y) - (a.y - d.y) * (b.x - d.x)) / (h * h) ==
                  doctest::Approx(PI).epsilon(.02));
        }
}

// Patch centres: theta 0, 18, 36, 54, 76 degrees of the quarter basis, azimuth 45 degrees apart in its second ring.
TEST_CASE("a matrix gives the file's values, but for RADIANCE's perturbation of 3e-4") {
    const Tables t(bsdf_file("Columns", bsdf_block("Reflection Back", bsdf_numbers(41 * 41, 3)) +
                                            bsdf_block("Transmission Back", bsdf_numbers(41 * 41, 4))));
    float psa;
    for (int i = 0; i < 8; i++)
        for (int o = 0; o < 8; o++) {
            // incident cells are counted from the far side
            const float3 v = direction(18, 45 * i + 180);
            const auto& y = t.file.reflection[0].y;
            CHECK(bsdf_value(&t.s, t.table(1, 0), v, direction(18, 45 * o), &psa) ==
                  doctest::Approx(y[size_t((1 + i) * 41 + 1 + o)]).epsilon(4e-4));
            CHECK(psa == doctest::Approx(
                             PI * (std::pow(std::cos(9 * PI / 180), 2) - std::pow(std::cos(27 * PI / 180), 2)) / 8));
            CHECK(bsdf_value(&t.s, t.table(1, 1), v, direction(18, 45 * o, -1), &psa) ==
                  doctest::Approx(t.file.transmission[0].y[size_t((1 + i) * 41 + 1 + o)]).epsilon(4e-4));
        }
}

TEST_CASE("a missing transmission is the other one, turned round") {
    std::mt19937 random(8);
    for (const std::string& text :
         {bsdf_file("Columns", bsdf_block("Transmission Back", bsdf_numbers(41 * 41, 4))),
          bsdf_file("TensorTree4", bsdf_block("Transmission Back", bsdf_tree(4, 3, random))),
          bsdf_file("TensorTree3", bsdf_block("Transmission Back", bsdf_tree(3, 3, random)))}) {
        const Tables t(text);
        CHECK(t.component(1, 0).table == NONE);  // no reflection
        for (int i = 0; i < 200; i++) {
            float psa;
            const float3 a = direction(random() % 89, random() % 360), b = direction(random() % 89, random() % 360, -1);
            CHECK(bsdf_value(&t.s, t.table(1, 1), a, b, &psa) == bsdf_value(&t.s, t.table(0, 1), b, a, &psa));
        }
        CHECK(t.diffuse(0, 1) == t.diffuse(1, 1));
    }
}

// f = 0.1 everywhere: albedo 0.1 pi, all of it Lambertian; less than .01 / pi stays in the table.
TEST_CASE("the smallest value is the Lambertian part") {
    const Tables t(bsdf_file("Columns", bsdf_block("Reflection Back", bsdf_numbers(41 * 41, 1, .1, .1)) +
                                            bsdf_block("Reflection Front", bsdf_numbers(41 * 41, 1, .002, .002))));
    CHECK(t.diffuse(1, 0) == doctest::Approx(.1 * PI).epsilon(4e-4));
    CHECK(bsdf_hemispherical(&t.s, t.table(1, 0), direction(40, 10)) < .001f * PI);
    CHECK(t.diffuse(0, 0) == 0);
    CHECK(bsdf_hemispherical(&t.s, t.table(0, 0), direction(40, 10)) == doctest::Approx(.002 * PI).epsilon(4e-4));
}

TEST_CASE("white stays white, and XYZ becomes RADIANCE's RGB") {
    const auto blocks = [](double x, double z) {
        return bsdf_block("Reflection Back", bsdf_numbers(41 * 41, 1, .5, .5)) +
               bsdf_block("Reflection Back", bsdf_numbers(41 * 41, 1, .5 * x, .5 * x), "LBNL/Klems Quarter", "CIE-X") +
               bsdf_block("Reflection Back", bsdf_numbers(41 * 41, 1, .5 * z, .5 * z), "LBNL/Klems Quarter", "CIE-Z");
    };
    const float3 v = direction(20, 20), l = direction(50, 70);
    Tables white(bsdf_file("Columns", blocks(1, 1)));
    float3 c = bsdf_color(&white.s, white.table(1, 0), v, l);
    CHECK(c.x == doctest::Approx(1).epsilon(1e-5));
    CHECK(c.y == doctest::Approx(1).epsilon(1e-5));
    CHECK(c.z == doctest::Approx(1).epsilon(1e-5));
    Tables warm(bsdf_file("Columns", blocks(1.1, .5)));
    c = bsdf_color(&warm.s, warm.table(1, 0), v, l);
    CHECK(.265106 * c.x + .670106 * c.y + .064788 * c.z == doctest::Approx(1).epsilon(1e-5));  // luminance is kept
    CHECK(c.x > c.z);
    // the same chromaticity as u'v' of a tree: u' = 4X/(X+15Y+3Z), v' = 9Y/(X+15Y+3Z)
    const double d = 1.1 + 15 + 3 * .5;
    Tables tree(bsdf_file("TensorTree4",
                          bsdf_block("Reflection Back", "{.5}") +
                              bsdf_block("Reflection Back", "{" + std::to_string(4 * 1.1 / d) + "}", "", "CIE-u") +
                              bsdf_block("Reflection Back", "{" + std::to_string(9 / d) + "}", "", "CIE-v")));
    const float3 e = bsdf_color(&tree.s, tree.table(1, 0), v, l);
    CHECK(e.x == doctest::Approx(c.x).epsilon(1e-4));
    CHECK(e.y == doctest::Approx(c.y).epsilon(1e-4));
    CHECK(e.z == doctest::Approx(c.z).epsilon(1e-4));
}

// 200000 samples in 41 cells, expected f * psa / hemispherical value each: chi-square of 40 degrees of freedom has mean
// 40 and variance 80; 5 standard deviations above is 85.
TEST_CASE("samples of a matrix follow its values") {
    const Tables t(bsdf_file("Columns", bsdf_block("Transmission Back", bsdf_numbers(41 * 41, 9))));
    const int n = 200000;
    for (int front = 0; front < 2; front++) {
        const BsdfTable* table = t.table(front, 1);
        const float3 v = direction(40, 77, front ? 1 : -1);
        const double hemi = bsdf_hemispherical(&t.s, table, v);
        std::vector<double> seen(41, 0.0);
        for (int i = 0; i < n; i++) {
            Sampler rnd = random_stream(uint32_t(i));
            float3 l;
            REQUIRE(bsdf_sample(&t.s, table, v, &rnd, &l) == float(hemi));
            REQUIRE(std::fabs(dot3(l, l) - 1) < 1e-5);
            seen[bsdf_l_cell(&t.s, table, l)]++;
        }
        double chi2 = 0, total = 0;
        for (int cell = 0; cell < 41; cell++) {
            const float3 l =
                basis_direction(t.s.bsdf_rings + table->l_rings_at, table->l_rings, uint32_t(cell), float2{.5f, .5f});
            const float k = table->swap ? -1.0f : 1.0f;
            float psa;
            const double part = double(bsdf_value(&t.s, table, v, F3(k * l.x, k * l.y, l.z), &psa)) *
                                t.s.f[table->l_psa + uint32_t(cell)];
            const double expected = n * part / hemi;
            total += part;
            if (expected > 0) chi2 += (seen[size_t(cell)] - expected) * (seen[size_t(cell)] - expected) / expected;
            else CHECK(seen[size_t(cell)] == 0);
        }
        CHECK(total == doctest::Approx(hemi).epsilon(1e-5));
        CHECK(chi2 < 85);
    }
}

// An isotropic table knows the angle between v and l only, so turning v turns the samples.
TEST_CASE("an isotropic tree turns with the viewer") {
    std::mt19937 random(4);
    const Tables t(bsdf_file("TensorTree3", bsdf_block("Reflection Back", bsdf_tree(3, 3, random))));
    const BsdfTable* table = t.table(1, 0);
    const float3 v = direction(33, 180), turned = direction(33, 180 + 50);
    const double c = std::cos(50 * PI / 180), s = std::sin(50 * PI / 180);
    for (uint32_t i = 0; i < 100; i++) {
        Sampler one = random_stream(i), two = one;
        float3 a = F3(0, 0, 1), b = a;
        const float w = bsdf_sample(&t.s, table, v, &one, &a);
        CHECK(bsdf_sample(&t.s, table, turned, &two, &b) == doctest::Approx(w));
        if (w <= 0) continue;
        CHECK(std::fabs(b.x - (a.x * c - a.y * s)) < 1e-5);
        CHECK(std::fabs(b.y - (a.y * c + a.x * s)) < 1e-5);
        float psa;
        CHECK(bsdf_value(&t.s, table, turned, b, &psa) == bsdf_value(&t.s, table, v, a, &psa));
    }
}

// Trees: the weights' sum over each of 8 x 8 squares of the disc is pi times the integral of f there (64 x 64 points,
// the trees' finest cells are 8); their mean is the hemispherical value.  All within 5 standard errors, and a
// chi-square of 64 squares below 64 + 5 sqrt(128) = 121.
TEST_CASE("weighted samples of a tree are its values") {
    std::mt19937 random(21);
    const int n = 200000, squares = 8;
    for (int dims = 3; dims <= 4; dims++) {
        const Tables t(bsdf_file(dims == 3 ? "TensorTree3" : "TensorTree4",
                                 bsdf_block("Reflection Back", bsdf_tree(dims, 3, random)) +
                                     bsdf_block("Transmission Back", bsdf_tree(dims, 3, random))));
        for (int kind = 0; kind < 3; kind++) {  // reflection, transmission, transmission the other way round
            const int front = kind<2, transmit = kind> 0;
            const BsdfTable* table = t.table(front, transmit);
            const double side = transmit ? -1 : 1;
            const float3 v = direction(33, 180, front ? 1 : -1);
            std::vector<double> sum(squares * squares, 0.0), sum2(sum.size(), 0.0);
            double all = 0, all2 = 0;
            for (int i = 0; i < n; i++) {
                Sampler rnd = random_stream(uint32_t(i));
                float3 l = F3(0, 0, 1);
                const double w = bsdf_sample(&t.s, table, v, &rnd, &l);
                const float2 q = bsdf_square(l.x, l.y);
                const size_t at = size_t(q.x * squares) + squares * size_t(q.y * squares);
                sum[at] += w;
                sum2[at] += w * w;
                all += w;
                all2 += w * w;
            }
            double chi2 = 0, exact = 0;
            for (int b = 0; b < squares * squares; b++) {
                double integral = 0;
                for (int k = 0; k < 64; k++) {
                    float psa;
                    const float2 d = bsdf_disc((float(b % squares) + (float(k % 8) + .5f) / 8) / squares,
                                               (float(b / squares) + (float(k / 8) + .5f) / 8) / squares);
                    const float3 l = F3(d.x, d.y, float(side * (front ? 1 : -1)) * bsdf_height(d.x, d.y));
                    integral += PI * double(bsdf_value(&t.s, table, v, l, &psa)) / (64 * squares * squares);
                }
                exact += integral;
                const double mean = sum[size_t(b)] / n, variance = (sum2[size_t(b)] / n - mean * mean) / n;
                if (variance > 0) chi2 += (mean - integral) * (mean - integral) / variance;
            }
            const double mean = all / n, error = std::sqrt((all2 / n - mean * mean) / n) + 1e-6;
            INFO("dimensions ", dims, " kind ", kind);
            CHECK(chi2 < 121);
            CHECK(std::fabs(mean - exact) < 5 * error);
            // the turned isotropic tree's table is by quadrature over the disc
            CHECK(bsdf_hemispherical(&t.s, table, v) ==
                  doctest::Approx(exact).epsilon(dims == 3 && kind == 2 ? .02 : 1e-4));
        }
    }
}
