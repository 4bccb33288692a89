// SPDX-License-Identifier: BSD-3-Clause
// One of the candidates that the tree of many sources gives: the mean over choices is the sum over sources.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "unit/light_crowd.h"

static float choose(const Crowd& crowd, float3 p, float3 n, uint32_t k, uint32_t* chosen) {
    Sampler rnd = sampler_start(3, 4, k, 0, 0);
    return choose_source(&crowd.s, &crowd.par, p, n, 0, &rnd, chosen);
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
        const std::vector<double> prob = crowd.probs(p, n);
        const auto value = [&](uint32_t i) { return prob[i] > 0 ? 1.0 + i % 3 : 0; };  // not what is promised
        Sum all;
        std::vector<Sum> each(prob.size());
        for (uint32_t i = 0; i < prob.size(); i++) {
            all.exact += value(i);
            each[i].exact = prob[i] > 0;
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
        const std::vector<double> promised = crowd.importances(p, n);
        double squares = 0;
        int cells = 0;
        for (uint32_t i = 0; i < prob.size(); i++) {
            each[i].choices = all.choices;
            if (prob[i] <= 0) CHECK(each[i].sum == 0);
            if (promised[i] < 5e-4) continue;  // chosen less than 200 times: its error is not known
            squares += each[i].off() * each[i].off();
            cells++;
        }
        CHECK(cells > 20);
        CHECK(squares < cells + 5 * std::sqrt(2.0 * cells));
    }
}

TEST_CASE("where a cut would have too many nodes fewer are opened, and the mean is the sum over sources") {
    const Crowd crowd(4000, 0, 0);
    int full = 0;
    for (int place = 0; place < 100 && full < 3; place++) {
        const float3 p = any_place(), n = any_unit();
        LightCut cut;
        if (cut_tree(&crowd.s, &crowd.par, p, n, 0, LIGHT_OPENED, &cut)) continue;
        full++;
        const std::vector<double> promised = crowd.importances(p, n);
        const auto value = [&](uint32_t i) { return promised[i] * (1 + i % 3); };
        Sum all;
        for (uint32_t i = 0; i < crowd.par.sources_count; i++) all.exact += value(i);
        for (int k = 0; k < 40000; k++) {
            uint32_t i = 0;
            const float counts = choose(crowd, p, n, uint32_t(k), &i);
            all.add(counts * value(i));
        }
        CHECK(std::abs(all.off()) < 4);
        CHECK(all.error() < .01 * all.exact);
    }
    CHECK(full == 3);
}
