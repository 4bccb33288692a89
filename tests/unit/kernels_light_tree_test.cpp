// SPDX-License-Identifier: BSD-3-Clause
// The tree of many sources: each source stands in it once, is chosen as often as the chance that is given for it says,
// has a chance wherever it gives light, and the mean over choices is the sum over sources.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>
#include <fmt/core.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <vector>

#include "base/tempfile.h"
#include "flatten/flatten.h"
#include "kernels/host.h"
namespace kernels {
#include "kernels/cal_vm.h"
#include "kernels/sampler.h"
#include "kernels/instance.h"
#include "kernels/surface.h"
#include "kernels/lobes.h"
#include "kernels/modifier.h"
#include "kernels/sources.h"
#include "kernels/source_sample.h"
#include "kernels/gate.h"
#include "kernels/light_tree.h"
#include "kernels/choose_source.h"
}  // namespace kernels

using namespace kernels;

static std::mt19937 random_bits(3);
static double any(double lo, double hi) { return std::uniform_real_distribution<double>(lo, hi)(random_bits); }
static float3 any_unit() {
    for (;;) {
        const float3 v = F3(float(any(-1, 1)), float(any(-1, 1)), float(any(-1, 1)));
        if (length3(v) > .1f && length3(v) <= 1) return unit3(v);
    }
}
static float3 any_place() { return F3(float(any(-5, 5)), float(any(-5, 5)), float(any(0, 4))); }

static std::string number(double x, double y, double z) { return fmt::format(" {} {} {}", x, y, z); }

// A source of kind k somewhere in a room 10 x 10 x 4.
static std::string lamp(int k, int i) {
    const double x = any(-4, 4), y = any(-4, 4), z = any(1, 3.5), r = any(.02, .3), up = any(0, 1) < .5 ? 1 : -1;
    const std::string at = number(x, y, z), name = fmt::format("s{} 0 0 ", i), aim = number(any(-1, 1), any(-1, 1), -1);
    switch (k % 6) {
    case 0: return "l sphere " + name + "4" + at + fmt::format(" {}\n", r);
    case 1: return "l ring " + name + "8" + at + aim + fmt::format(" 0 {}\n", r);
    case 2: return "l cylinder " + name + "7" + at + number(x + 4 * r, y, z + r) + fmt::format(" {}\n", r / 4);
    case 3: return "near sphere " + name + "4" + at + fmt::format(" {}\n", r);
    case 4: return "spot ring " + name + "8" + at + aim + fmt::format(" 0 {}\n", r);
    default:
        return "l polygon " + name + "12" + at + number(x + r, y, z + r * up) + number(x + r, y + r, z + r * up) +
               number(x, y + r / 2, z) + "\n";
    }
}

// So many of them, suns and two mirrors.
struct Crowd {
    flatten::FlatScene flat;
    SceneTables s = {};
    Params par = {};
    Crowd(int lamps, int suns, int levels) {
        std::string text =
            "void light l 0 0 3 9 9 9\nvoid glow near 0 0 4 9 9 9 2.5\nvoid mirror m 0 0 3 .8 .8 .8\n"
            "void spotlight spot 0 0 7 9 9 9 120 0 0 -.5\n"
            "m polygon m1 0 0 12 -2 5 0 2 5 0 2 5 4 -2 5 4\nm polygon m2 0 0 12 5 -3 0 5 -3 4 5 3 4 5 3 0\n";
        for (int i = 0; i < lamps; i++) text += lamp(i, i);
        for (int i = 0; i < suns; i++)
            text += fmt::format("l source sun{} 0 0 4{} 2\n", i, number(any(-1, 1), any(-1, 1), any(.1, 1)));
        base::TempFile file((std::filesystem::temp_directory_path() / "luxpipe_crowd.rad").string());
        std::ofstream(file.path()) << text;
        flatten::Options options;
        options.sampling = flatten::Sampling::plain;
        options.dr = levels;
        flat = flatten::flatten(scene::read_scene({file.path()}, {}), options, {});
        s.f = flat.f.data();
        s.u = flat.u.data();
        par.sources_at = flat.sources_at;
        par.source_count = flat.source_count;
        par.light_tree_at = flat.light_tree_at;
        par.light_nodes = flat.light_nodes;
    }

    GLOBAL const float* node(uint32_t i) const { return light_node(&s, &par, i); }
    float promise(uint32_t i, float3 p, float3 n) const {
        return light_promise(node(i), p, n, 0, light_gates(&s, node(i), p));
    }

    // Of each source, at p.  A second way to the numbers of choose_light().
    std::vector<double> chances(float3 p, float3 n) const {
        std::vector<double> chance(par.source_count);
        std::vector<uint32_t> cut;
        double sum = 0;
        for (uint32_t i = 0; i < par.light_nodes;) {
            if (light_is_opened(&par, node(i), p, light_gates(&s, node(i), p))) {
                i++;
                continue;
            }
            cut.push_back(i);
            sum += promise(i, p, n);
            i = as_uint_(node(i)[LIGHT_PAST]);
        }
        for (uint32_t i : cut)
            if (promise(i, p, n) > 0) descend(i, promise(i, p, n) / sum, p, n, chance);
        return chance;
    }

private:
    void descend(uint32_t i, double share, float3 p, float3 n, std::vector<double>& chance) const {
        const uint32_t source = as_uint_(node(i)[LIGHT_SOURCE]);
        if (source != NONE) {
            chance[source] += share;
            return;
        }
        const uint32_t second = as_uint_(node(i + 1)[LIGHT_PAST]);
        const double w1 = promise(i + 1, p, n), w2 = promise(second, p, n);
        if (w1 > 0) descend(i + 1, share * w1 / (w1 + w2), p, n, chance);
        if (w2 > 0) descend(second, share * w2 / (w1 + w2), p, n, chance);
    }
};

static float choose(const Crowd& crowd, float3 p, float3 n, uint32_t k, uint32_t* chosen) {
    Sampler rnd = sampler_start(3, 4, k, 0, 0);
    return choose_source(&crowd.s, &crowd.par, p, n, 0, &rnd, chosen);
}

TEST_CASE("few sources make no tree; of many each stands in it once, and each node comes before its halves") {
    CHECK(Crowd(20, 1, 0).par.light_nodes == 0);
    for (const Crowd& crowd : {Crowd(40, 0, 0), Crowd(60, 3, 2), Crowd(0, 40, 1), Crowd(1000, 0, 1)}) {
        REQUIRE(crowd.par.light_nodes > 0);
        std::vector<int> seen(crowd.par.source_count);
        for (uint32_t i = 0; i < crowd.par.light_nodes; i++) {
            const uint32_t source = as_uint_(crowd.node(i)[LIGHT_SOURCE]), past = as_uint_(crowd.node(i)[LIGHT_PAST]);
            if (source != NONE) {
                REQUIRE(source < seen.size());
                seen[source]++;
                CHECK(past == i + 1);
            } else {
                CHECK(as_uint_(crowd.node(as_uint_(crowd.node(i + 1)[LIGHT_PAST]))[LIGHT_PAST]) == past);
            }
        }
        for (int times : seen) CHECK(times == 1);
    }
}

TEST_CASE("sources are chosen as often as their chance says (Pearson's chi-square)") {
    for (const Crowd& crowd : {Crowd(40, 0, 0), Crowd(40, 2, 1), Crowd(100, 2, 2), Crowd(300, 0, 1)}) {
        for (int place = 0; place < 3; place++) {
            const float3 p = any_place(), n = any_unit();
            const std::vector<double> chance = crowd.chances(p, n);
            std::vector<double> count(chance.size());
            const int choices = 40000;
            for (int k = 0; k < choices; k++) {
                uint32_t i = 0;
                const float inv_p = choose(crowd, p, n, uint32_t(k), &i);
                if (!(inv_p > 0)) continue;
                CHECK(inv_p == doctest::Approx(1 / chance[i]).epsilon(1e-4));
                count[i]++;
            }

            double chi2 = 0, rest = choices, rest_count = choices;  // the rest: rare ones, and nobody
            int cells = 0;
            for (size_t i = 0; i < chance.size(); i++) {
                const double expected = choices * chance[i];
                if (expected < 10) continue;
                chi2 += (count[i] - expected) * (count[i] - expected) / expected;
                rest -= expected;
                rest_count -= count[i];
                cells++;
            }
            if (rest > 10) chi2 += (rest_count - rest) * (rest_count - rest) / rest;
            CHECK(rest_count <= rest + 4 * std::sqrt(rest + 10));
            CHECK(chi2 < cells + 4 * std::sqrt(2.0 * cells) + 4);
        }
    }
}

// Does a ray from p pass the gates of source i?
static bool passes(const Crowd& crowd, uint32_t i, float3 p, float3 dir) {
    const uint32_t relay = as_uint_(source_record(&crowd.s, &crowd.par, i)[SRC_VIRTUAL]);
    if (relay == NONE) return true;
    const float* gate = crowd.s.f + crowd.s.u[relay + RELAY_GATES_AT];
    for (uint32_t k = 0; k < crowd.s.u[relay + RELAY_GATES]; k++, gate += GATE_FLOATS) {
        const float3 c = sub3(f3_at(gate + GATE_CENTRE), p), n = f3_at(gate + GATE_NORMAL);
        const float t = dot3(n, c) / dot3(n, dir);
        const float3 off = sub3(scale3(dir, t), c);
        if (!(t > 0) || dot3(n, dir) > 0 || std::fabs(dot3(off, f3_at(gate + GATE_U))) > 1 ||
            std::fabs(dot3(off, f3_at(gate + GATE_V))) > 1)
            return false;
    }
    return true;
}

TEST_CASE("whatever gives light to a point has a chance there") {
    int lit = 0, none = 0;
    for (const Crowd& crowd : {Crowd(60, 2, 2), Crowd(400, 0, 0)}) {
        for (int k = 0; k < 1000; k++) {
            const float3 p = any_place(), n = any_unit();
            const std::vector<double> chance = crowd.chances(p, n);
            for (uint32_t i = 0; i < crowd.par.source_count; i++) {
                float2 x;
                x.x = float(any(0, 1));
                x.y = float(any(0, 1));
                LightSample light;
                sample_source(&crowd.s, &crowd.par, i, p, x, 1, &light);
                none += chance[i] <= 0;
                if (!(light.w > 0) || !(dot3(light.dir, n) > 1e-4f) || !passes(crowd, i, p, light.dir)) continue;
                lit++;
                if (chance[i] <= 0) FAIL_CHECK("source " << i << " is left out");
            }
        }
    }
    CHECK(lit > 10000);
    CHECK(none > 10000);
}

TEST_CASE("the mean over choices is the sum over sources") {
    for (const Crowd& crowd : {Crowd(60, 2, 2), Crowd(1000, 0, 0)}) {
        const float3 p = F3(.3f, -.2f, .1f), n = unit3(F3(.1f, .2f, 1));
        const std::vector<double> chance = crowd.chances(p, n);
        const auto value = [&](uint32_t i) { return chance[i] > 0 ? 1.0 + i % 3 : 0; };  // not what is promised
        double exact = 0, sum = 0, square = 0;
        for (uint32_t i = 0; i < crowd.par.source_count; i++) exact += value(i);
        const int choices = 400000;
        for (int k = 0; k < choices; k++) {
            uint32_t i = 0;
            const float inv_p = choose(crowd, p, n, uint32_t(k), &i);
            const double v = inv_p > 0 ? inv_p * value(i) : 0;
            sum += v;
            square += v * v;
        }
        const double mean = sum / choices, error = std::sqrt((square / choices - mean * mean) / choices);
        CHECK(std::abs(mean - exact) < 4 * error + 1e-6 * exact);
        CHECK(error < .05 * exact);
    }
}
