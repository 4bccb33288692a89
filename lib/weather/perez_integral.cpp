// SPDX-License-Identifier: BSD-3-Clause
// Gauss-Legendre nodes in height and azimuth.  The indicatrix has a cusp in the sun and the gradation is steep at the
// horizon: heights are cut at the sun's, and nodes gather at both ends of each part and around the sun's azimuth.
#include "weather/perez_integral.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/angle.h"

namespace weather {
namespace {

struct Node {
    double x, weight;
};

// Nodes in 0..1: roots of Legendre's polynomial by Newton's method from Chebyshev's.
template <int n>
std::vector<Node> gauss() {
    std::vector<Node> nodes;
    for (int i = 0; i < n; ++i) {
        double x = std::cos(base::pi * (i + .75) / (n + .5)), slope = 1;
        for (int step = 0; step < 8; ++step) {
            double p = 1, before = 0;
            for (int k = 1; k <= n; ++k) {
                const double next = ((2 * k - 1) * x * p - (k - 1) * before) / k;
                before = p;
                p = next;
            }
            slope = n * (x * p - before) / (x * x - 1);
            x -= p / slope;
        }
        nodes.push_back({(1 + x) / 2, 1 / ((1 - x * x) * slope * slope)});
    }
    return nodes;
}

// Nodes that gather at both ends, by 3x^2 - 2x^3.
template <int n>
std::vector<Node> gathered() {
    std::vector<Node> nodes = gauss<n>();
    for (Node& a : nodes) a = {a.x * a.x * (3 - 2 * a.x), a.weight * 6 * a.x * (1 - a.x)};
    return nodes;
}

// Integral of the indicatrix around the horizon at this height, to both sides of the sun.
double ring(const generators::PerezShape& shape, double height, double sun_height) {
    static const std::vector<Node> nodes = gauss<24>();
    const double along = height * sun_height, across = std::sqrt((1 - height * height) * (1 - sun_height * sun_height));
    double sum = 0;
    for (const Node& a : nodes) {
        const double cosine = std::clamp(along + across * std::cos(base::pi * a.x * a.x), -1., 1.);
        sum += a.weight * 4 * base::pi * a.x *
               (1 + shape.c[2] * std::exp(shape.c[3] * std::acos(cosine)) + shape.c[4] * cosine * cosine);
    }
    return sum;
}

}  // namespace

PerezIntegral integrate(const generators::PerezShape& shape, double sun_zenith_angle) {
    static const std::vector<Node> nodes = gathered<24>();
    const double sun_height = std::clamp(std::cos(sun_zenith_angle), 0., 1.);
    PerezIntegral sum;
    for (const auto& [from, to] : {Node{0, sun_height}, Node{sun_height, 1}})
        for (const Node& a : nodes) {
            const double height = from + (to - from) * a.x, area = (to - from) * a.weight * height;
            const double gradation = 1 + shape.c[0] * std::exp(shape.c[1] / std::max(height, lowest_cosine));
            const double share = 1 / (horizon_weight(height) + 1);
            sum.sky += area * (1 - share) * gradation * ring(shape, height, sun_height);
            sum.ground += area * share * 2 * base::pi;
        }
    return sum;
}

}  // namespace weather
