// SPDX-License-Identifier: BSD-3-Clause
// The tree of many sources: each source stands in it once, is a candidate as often as the chance that is given for it
// says, has a chance wherever it gives light, and the mean over choices is the sum over sources.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>
#include <fmt/core.h>

#include <algorithm>
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
    float promise(uint32_t i, float3 p, float3 n) const { return light_promise(&s, node(i), p, n, 0); }

    // Of each source, its share of what all promise.
    std::vector<double> promises(float3 p, float3 n) const {
        std::vector<double> promised(par.source_count);
        double sum = 0;
        for (uint32_t i = 0; i < par.light_nodes; i++) {
            const uint32_t source = as_uint_(node(i)[LIGHT_SOURCE]);
            if (source != NONE) sum += promised[source] = promise(i, p, n);
        }
        for (double& w : promised) w /= sum;
        return promised;
    }

    // Of each source to be a candidate at p.  A second way to the numbers of candidate().
    std::vector<double> chances(float3 p, float3 n) const {
        std::vector<double> chance(par.source_count);
        std::vector<uint32_t> nodes;
        double sum = 0;
        for (uint32_t i = 0; i < par.light_nodes;) {
            const bool all = par.source_count <= LIGHT_CUT && as_uint_(node(i)[LIGHT_SOURCE]) == NONE;
            if (all || light_is_opened(node(i), p, LIGHT_OPENED)) {
                i++;
                continue;
            }
            nodes.push_back(i);
            sum += promise(i, p, n);
            i = as_uint_(node(i)[LIGHT_PAST]);
        }
        REQUIRE(nodes.size() <= LIGHT_CUT);
        for (uint32_t i : nodes)
            if (promise(i, p, n) > 0) descend(i, promise(i, p, n) / sum, p, n, chance);
        return chance;
    }

private:
    // A source that can give nothing is no candidate.
    void descend(uint32_t i, double chance, float3 p, float3 n, std::vector<double>& chances) const {
        const uint32_t source = as_uint_(node(i)[LIGHT_SOURCE]);
        if (source != NONE) {
            if (promise(i, p, n) > 0) chances[source] += chance;
            return;
        }
        const uint32_t second = as_uint_(node(i + 1)[LIGHT_PAST]);
        const double w1 = node(i + 1)[LIGHT_POWER], w2 = node(second)[LIGHT_POWER];
        const double first = std::clamp(w1 / (w1 + w2), 1 / 1024., 1023 / 1024.);
        descend(i + 1, chance * first, p, n, chances);
        descend(second, chance * (1 - first), p, n, chances);
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

TEST_CASE("sources are candidates as often as their chance says (Pearson's chi-square)") {
    for (const Crowd& crowd : {Crowd(40, 0, 0), Crowd(40, 2, 1), Crowd(100, 2, 2), Crowd(300, 0, 1)}) {
        for (int place = 0; place < 3; place++) {
            const float3 p = any_place(), n = any_unit();
            const std::vector<double> chance = crowd.chances(p, n);
            LightCut cut;
            REQUIRE(cut_tree(&crowd.s, &crowd.par, p, n, 0, LIGHT_OPENED, &cut));
            if (cut.count == 0) continue;
            const float all = cut.upto[cut.count - 1];
            std::vector<double> count(chance.size());
            const int draws = 40000;
            for (int k = 0; k < draws; k++) {
                uint32_t from = 0;
                const float y = float(any(0, 1)) * all;
                const LightCandidate c = light_candidate(&crowd.s, &crowd.par, &cut, p, n, 0, y, &from);
                if (!(c.promise > 0)) continue;
                const uint32_t i = as_uint_(crowd.node(c.at)[LIGHT_SOURCE]);
                CHECK(c.chance / all == doctest::Approx(chance[i]).epsilon(1e-4));
                count[i]++;
            }

            double chi2 = 0, rest = draws, rest_count = draws;  // the rest: rare ones, and none that shines
            int cells = 0;
            for (size_t i = 0; i < chance.size(); i++) {
                const double expected = draws * chance[i];
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

// What choices at a point make of a sum over sources.
struct Sum {
    double exact = 0, sum = 0, square = 0;
    int choices = 0;
    void add(double v) {
        sum += v;
        square += v * v;
        choices++;
    }
    double mean() const { return sum / choices; }
    double error() const { return std::sqrt((square / choices - mean() * mean()) / choices); }
    double off() const { return (mean() - exact) / (error() + 1e-6 * exact + 1e-30); }  // in standard errors
};

TEST_CASE("the mean over choices is the sum over sources, of all and of each") {
    for (const Crowd& crowd : {Crowd(30, 2, 1), Crowd(60, 2, 2), Crowd(1000, 0, 0)}) {
        const float3 p = F3(.3f, -.2f, .1f), n = unit3(F3(.1f, .2f, 1));
        const std::vector<double> chance = crowd.chances(p, n);
        const auto value = [&](uint32_t i) { return chance[i] > 0 ? 1.0 + i % 3 : 0; };  // not what is promised
        Sum all;
        std::vector<Sum> each(chance.size());
        for (uint32_t i = 0; i < chance.size(); i++) {
            all.exact += value(i);
            each[i].exact = chance[i] > 0;
        }
        for (int k = 0; k < 400000; k++) {
            uint32_t i = 0;
            const float counts = choose(crowd, p, n, uint32_t(k), &i);
            all.add(counts * value(i));
            each[i].sum += counts;
            each[i].square += counts * counts;
        }

        CHECK(std::abs(all.off()) < 4);
        CHECK(all.error() < .05 * all.exact);
        const std::vector<double> promised = crowd.promises(p, n);
        double squares = 0;
        int cells = 0;
        for (uint32_t i = 0; i < chance.size(); i++) {
            each[i].choices = all.choices;
            if (chance[i] <= 0) CHECK(each[i].sum == 0);
            if (promised[i] < 5e-4) continue;  // chosen less than 200 times: its error is not known
            squares += each[i].off() * each[i].off();
            cells++;
        }
        CHECK(cells > 20);
        CHECK(squares < cells + 5 * std::sqrt(2.0 * cells));
    }
}
