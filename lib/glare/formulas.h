// SPDX-License-Identifier: BSD-3-Clause
// Glare formulas over a list of sources, rounded to single precision where evalglare does (otherwise the 7th digit
// differs); logarithms and powers are double.  Units cd/m2, sr, lux, degrees.  Sources: DGP Wienold and Christoffersen
// 2006 (paper Eq. 2); DGI Hopkinson/Chauvel; UGR CIE 117; CGI Einhorn 1979; VCP and DGR Guth 1963; UGP Hirning et al.
// 2014/2017; veiling luminance Poynter, CIE 146.
#pragma once
#include <vector>

namespace glare {

struct GlareTerm {  // a source, as the formulas see it
    double lum, omega, P, sigma_deg, eye_lux, theta_deg;
};
using GlareTerms = std::vector<GlareTerm>;

// L^a1 w^a2 E^a3 P^a4 E^a5 c1 c2 c3 of evalglare's -w:  c1 E^a5 + c3 + c2 log10(1 + sum L^a1 w^a2 / P^a4 / E^a3)
struct DgpConstants {
    double a1 = 2, a2 = 1, a3 = 1.87, a4 = 2, a5 = 1, c1 = 5.87e-5, c2 = 0.092, c3 = 0.159;
};
constexpr DgpConstants paper_dgp{2, 1, 1.87, 2, 1, 5.87e-5, 0.0918, 0.16};

double dgp_term(const GlareTerm& s, const DgpConstants& k);                 // L^a1 w^a2 / P^a4
double dgp_of_sum(double sum, bool any, double ev, const DgpConstants& k);  // at most 1
double dgp(const GlareTerms& s, double ev, const DgpConstants& k);
// The DGP of light that reaches the eye without any source of glare, by the paper: sources only add to it.  0 where the
// correction of low light counts (below 1000 lx), and for nan.
double least_dgp(double ev);
std::vector<double> dgp_shares(const GlareTerms& s, const DgpConstants& k);  // of each source in the sum
double low_light_factor(double ev);                                          // below 1000 lux, else 1

// Class of DGP (paper, section 2): 0 imperceptible, below 0.35; 1 perceptible; 2 disturbing, from 0.40; 3 intolerable,
// above 0.45.  Index into dgp_classes.
int dgp_class(double dgp);
extern const char* const dgp_classes[5];  // the last one is "unknown"
extern const double dgp_limits[3];

double dgi(const GlareTerms& s, double background);
double dgi_mod(const GlareTerms& s, double background, double ev);
double ugr(const GlareTerms& s, double background);
double ugr_exp(const GlareTerms& s, double background, double ev);
double ugp(const GlareTerms& s, double background);
double ugp2(const GlareTerms& s, double background);
double cgi(const GlareTerms& s, double direct_lux, double ev);
double dgr(const GlareTerms& s, double mean_lum);
double vcp(const GlareTerms& s, double dgr);
double veil_poynter(const GlareTerms& s);
double veil_cie(const GlareTerms& s, double cut);  // terms up to `cut` are left out (-k)

}  // namespace glare
