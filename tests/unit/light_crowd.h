// SPDX-License-Identifier: BSD-3-Clause
// Many sources of all kinds, suns and mirrors for the tests of the light tree, and what the tree should say of them.
#pragma once
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
#include "kernels/dialect/host.h"
namespace kernels {
#include "kernels/cal/cal_vm.h"
#include "kernels/sampling/sampler.h"
#include "kernels/bvh/instance.h"
#include "kernels/geom/surface.h"
#include "kernels/material/lobes.h"
#include "kernels/material/modifier.h"
#include "kernels/light/sources.h"
#include "kernels/light/source_sample.h"
#include "kernels/light/relay_aperture.h"
#include "kernels/light/light_tree.h"
#include "kernels/light/choose_source.h"
}  // namespace kernels

using namespace kernels;

inline std::mt19937 random_bits(3);
inline double any(double lo, double hi) { return std::uniform_real_distribution<double>(lo, hi)(random_bits); }
inline float3 any_unit() {
    for (;;) {
        const float3 v = F3(float(any(-1, 1)), float(any(-1, 1)), float(any(-1, 1)));
        if (length3(v) > .1f && length3(v) <= 1) return unit3(v);
    }
}
inline float3 any_place() { return F3(float(any(-5, 5)), float(any(-5, 5)), float(any(0, 4))); }

inline std::string number(double x, double y, double z) { return fmt::format(" {} {} {}", x, y, z); }

// A source of kind k somewhere in a room 10 x 10 x 4.
inline std::string lamp(int k, int i) {
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
#define POINT_AT(type, name) s.name = flat.name.data();
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
        options.dr = levels;
        flat = flatten::flatten(scene::read_scene({file.path()}, {}), options, {});
        FLAT_TABLES(POINT_AT)
        par.sources_count = uint32_t(flat.sources.size());
        par.light_nodes_count = uint32_t(flat.light_nodes.size());
    }

    const LightNode* node(uint32_t i) const { return &s.light_nodes[i]; }
    float importance(uint32_t i, float3 p, float3 n) const { return light_importance(&s, node(i), p, n, 0); }

    // Of each source, its share of what all importance.
    std::vector<double> importances(float3 p, float3 n) const {
        std::vector<double> promised(par.sources_count);
        double sum = 0;
        for (uint32_t i = 0; i < par.light_nodes_count; i++) {
            const uint32_t source = node(i)->source;
            if (source != NONE) sum += promised[source] = importance(i, p, n);
        }
        for (double& w : promised) w /= sum;
        return promised;
    }

    // Of each source to be a candidate at p.  A second way to the numbers of candidate().
    std::vector<double> probs(float3 p, float3 n) const {
        std::vector<double> prob(par.sources_count);
        std::vector<uint32_t> nodes;
        double sum = 0;
        for (uint32_t i = 0; i < par.light_nodes_count;) {
            const bool all = par.sources_count <= LIGHT_CUT && node(i)->source == NONE;
            if (all || light_is_opened(node(i), p, LIGHT_OPENED)) {
                i++;
                continue;
            }
            nodes.push_back(i);
            sum += importance(i, p, n);
            i = node(i)->past;
        }
        REQUIRE(nodes.size() <= LIGHT_CUT);
        for (uint32_t i : nodes)
            if (importance(i, p, n) > 0) descend(i, importance(i, p, n) / sum, p, n, prob);
        return prob;
    }

private:
    // A source that can give nothing is no candidate.
    void descend(uint32_t i, double prob, float3 p, float3 n, std::vector<double>& probs) const {
        const uint32_t source = node(i)->source;
        if (source != NONE) {
            if (importance(i, p, n) > 0) probs[source] += prob;
            return;
        }
        const uint32_t second = node(i + 1)->past;
        const double w1 = node(i + 1)->power, w2 = node(second)->power;
        const double first = std::clamp(w1 / (w1 + w2), 1 / 1024., 1023 / 1024.);
        descend(i + 1, prob * first, p, n, probs);
        descend(second, prob * (1 - first), p, n, probs);
    }
};
