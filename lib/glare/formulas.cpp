// SPDX-License-Identifier: BSD-3-Clause
// The formulas, each with its source (formulas.h; for users vcmetrics-formulas(7)).
#include "glare/formulas.h"
#include <algorithm>
#include <cmath>
#include "glare/geometry.h"

namespace glare {
namespace {

double lg(double x) { return std::log10(x); }  // of a double, also where the argument was rounded to float

double guth_sum(const GlareTerms& sources) {  // sum (L/P)^2 w
    double sum = 0;
    for (const GlareTerm& s : sources) sum += std::pow(s.lum / s.P, 2) * s.omega;
    return sum;
}

// 10 lg sum 0.478 L^1.6 W^0.8 / (B + 0.07 w^0.5 L), W = w/P^2
double dgi_over(const GlareTerms& sources, double background) {
    if (sources.empty()) return 0;
    float sum = 0;
    for (const GlareTerm& s : sources) {
        const float weighted = float(s.omega / (s.P * s.P));
        sum = float(sum + 0.478 * std::pow(s.lum, 1.6) * std::pow(double(weighted), 0.8) /
                              (background + 0.07 * std::sqrt(s.omega) * s.lum));
    }
    return float(10 * lg(sum));
}

}  // namespace

double dgp_term(const GlareTerm& s, const DgpConstants& k) {
    return std::pow(s.lum, k.a1) * std::pow(s.omega, k.a2) / std::pow(s.P, k.a4);
}

double dgp_of_sum(double sum, bool any, double ev, const DgpConstants& k) {
    const double value = k.c1 * std::pow(ev, k.a5) + k.c3 + (any ? k.c2 * lg(1 + sum / std::pow(ev, k.a3)) : 0);
    return value > 1 ? 1 : value;
}

double dgp(const GlareTerms& sources, double ev, const DgpConstants& k) {
    double sum = 0;
    for (const GlareTerm& s : sources) sum += dgp_term(s, k);
    return dgp_of_sum(sum, !sources.empty(), ev, k);
}

double least_dgp(double ev) { return ev >= 1000 ? dgp_of_sum(0, false, ev, paper_dgp) : 0; }

std::vector<double> dgp_shares(const GlareTerms& sources, const DgpConstants& k) {
    double sum = 0;
    for (const GlareTerm& s : sources) sum += dgp_term(s, k);
    std::vector<double> out;
    for (const GlareTerm& s : sources) out.push_back(dgp_term(s, k) / sum);
    return out;
}

double low_light_factor(double ev) {
    if (!(ev < 1000)) return 1;
    const double e = std::exp(0.024 * ev - 4);
    return e / (1 + e);
}

const char* const dgp_classes[5] = {"imperceptible", "perceptible", "disturbing", "intolerable", "unknown"};
const double dgp_limits[3] = {0.35, 0.40, 0.45};

int dgp_class(double dgp) {
    if (std::isnan(dgp)) return 4;
    return dgp > dgp_limits[2] ? 3 : dgp >= dgp_limits[1] ? 2 : dgp >= dgp_limits[0] ? 1 : 0;
}

double dgi(const GlareTerms& s, double background) { return dgi_over(s, float(background)); }

double dgi_mod(const GlareTerms& s, double, double ev) {
    return dgi_over(s, std::pow(double(float(ev / evalglare_pi)), 0.85));
}

double ugr(const GlareTerms& s, double background) {
    const double sum = guth_sum(s), b = float(background);
    if (s.empty() || sum == 0) return 0;
    if (!(b > 0)) return -99;
    return float(8 * lg(0.25 / b * sum));
}

double ugr_exp(const GlareTerms& sources, double background, double ev) {
    if (sources.empty()) return 0;
    double sum = 0;
    for (const GlareTerm& s : sources) {
        const float inverse = float(1 / s.P);
        sum += s.lum * s.omega * double(inverse) * double(inverse);
    }
    const double adaptation = float(ev / evalglare_pi);
    return float(8 * lg(adaptation) + 8 * lg(sum / double(float(background))));
}

double ugp(const GlareTerms& s, double background) {
    return s.empty() ? 0 : float(0.26 * lg(0.25 / double(float(background)) * guth_sum(s)));
}

double ugp2(const GlareTerms& s, double background) {
    return s.empty() ? 0 : float(std::pow(1 + 2. / 7 * std::pow(guth_sum(s) / double(float(background)), -0.2), -10));
}

double cgi(const GlareTerms& s, double direct_lux, double ev) {
    return s.empty() ? 0 : float(8 * lg(2 * (1 + direct_lux / 500) / ev * guth_sum(s)));
}

double dgr(const GlareTerms& sources, double mean_lum) {
    if (sources.empty()) return 0;
    double sum = 0;
    for (const GlareTerm& s : sources)
        sum +=
            0.5 * s.lum * (20.4 * s.omega + 1.52 * std::pow(s.omega, 0.2) - 0.075) / (s.P * std::pow(mean_lum, 0.44));
    return float(std::pow(sum, std::pow(double(sources.size()), -0.0914)));
}

double vcp(const GlareTerms& s, double value) {
    if (s.empty() || value < 20) return 100;
    if (value > 750) return 0;
    return float(50 * std::erf((6.374 - 1.3227 * std::log(value)) / 1.414213562373) + 50);
}

double veil_poynter(const GlareTerms& sources) {
    double sum = 0;
    for (const GlareTerm& s : sources)
        sum += s.lum * s.omega * std::cos(s.sigma_deg / evalglare_deg + 1e-11) / (s.sigma_deg + 1e-11);
    return float(5 * sum);
}

double veil_cie(const GlareTerms& sources, double cut) {
    double sum = 0;
    for (const GlareTerm& s : sources) {
        const double term = 10 * s.eye_lux / (s.theta_deg * s.theta_deg + 1e-16);
        if (!(term <= cut)) sum += term;
    }
    return sum;
}

}  // namespace glare
