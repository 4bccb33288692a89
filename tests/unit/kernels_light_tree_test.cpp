// SPDX-License-Identifier: BSD-3-Clause
// The tree of many sources: each source stands in it once, is a candidate as often as the chance that is given for it
// says, and has a chance wherever it gives light (kernels_light_choice_test.cpp: the choice among candidates).
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "unit/light_crowd.h"

TEST_CASE("few sources make no tree; of many each stands in it once, and each node comes before its halves") {
    CHECK(Crowd(20, 1, 0).par.light_nodes_count == 0);
    for (const Crowd& crowd : {Crowd(40, 0, 0), Crowd(60, 3, 2), Crowd(0, 40, 1), Crowd(1000, 0, 1)}) {
        REQUIRE(crowd.par.light_nodes_count > 0);
        std::vector<int> seen(crowd.par.sources_count);
        for (uint32_t i = 0; i < crowd.par.light_nodes_count; i++) {
            const uint32_t source = crowd.node(i)->source, past = crowd.node(i)->past;
            if (source != NONE) {
                REQUIRE(source < seen.size());
                seen[source]++;
                CHECK(past == i + 1);
            } else {
                CHECK(crowd.node(crowd.node(i + 1)->past)->past == past);
            }
        }
        for (int times : seen) CHECK(times == 1);
    }
}

TEST_CASE("sources are candidates as often as their prob says (Pearson's chi-square)") {
    for (const Crowd& crowd : {Crowd(40, 0, 0), Crowd(40, 2, 1), Crowd(100, 2, 2), Crowd(300, 0, 1)}) {
        for (int place = 0; place < 3; place++) {
            const float3 p = any_place(), n = any_unit();
            const std::vector<double> prob = crowd.probs(p, n);
            LightCut cut;
            REQUIRE(cut_tree(&crowd.s, &crowd.par, p, n, 0, LIGHT_OPENED, &cut));
            if (cut.count == 0) continue;
            const float all = cut.upto[cut.count - 1];
            std::vector<double> count(prob.size());
            const int draws = 40000;
            for (int k = 0; k < draws; k++) {
                uint32_t from = 0;
                const float y = float(any(0, 1)) * all;
                const LightCandidate c = light_candidate(&crowd.s, &cut, p, n, 0, y, &from);
                if (!(c.importance > 0)) continue;
                const uint32_t i = crowd.node(c.at)->source;
                CHECK(c.prob / all == doctest::Approx(prob[i]).epsilon(1e-4));
                count[i]++;
            }

            double chi2 = 0, rest = draws, rest_count = draws;  // the rest: rare ones, and none that shines
            int cells = 0;
            for (size_t i = 0; i < prob.size(); i++) {
                const double expected = draws * prob[i];
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

// Does a ray from p pass the apertures of source i?
static bool passes(const Crowd& crowd, uint32_t i, float3 p, float3 dir) {
    const uint32_t relay = crowd.s.sources[i].relay;
    if (relay == NONE) return true;
    for (uint32_t k = 0; k < crowd.s.relays[relay].aperture_count; k++) {
        const Aperture& aperture = crowd.s.apertures[crowd.s.relays[relay].aperture_at + k];
        const float3 c = sub3(f3_of(aperture.centre), p), n = f3_of(aperture.normal);
        const float t = dot3(n, c) / dot3(n, dir);
        const float3 off = sub3(scale3(dir, t), c);
        if (!(t > 0) || dot3(n, dir) > 0 || std::fabs(dot3(off, f3_of(aperture.u))) > 1 ||
            std::fabs(dot3(off, f3_of(aperture.v))) > 1)
            return false;
    }
    return true;
}

TEST_CASE("whatever gives light to a point has a prob there") {
    int lit = 0, none = 0;
    for (const Crowd& crowd : {Crowd(60, 2, 2), Crowd(400, 0, 0)}) {
        for (int k = 0; k < 1000; k++) {
            const float3 p = any_place(), n = any_unit();
            const std::vector<double> prob = crowd.probs(p, n);
            for (uint32_t i = 0; i < crowd.par.sources_count; i++) {
                float2 x;
                x.x = float(any(0, 1));
                x.y = float(any(0, 1));
                LightSample light;
                sample_source(&crowd.s, &crowd.par, i, p, x, 1, &light);
                none += prob[i] <= 0;
                if (!(light.w > 0) || !(dot3(light.dir, n) > 1e-4f) || !passes(crowd, i, p, light.dir)) continue;
                lit++;
                if (prob[i] <= 0) FAIL_CHECK("source " << i << " is left out");
            }
        }
    }
    CHECK(lit > 10000);
    CHECK(none > 10000);
}
