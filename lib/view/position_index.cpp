// SPDX-License-Identifier: BSD-3-Clause
// Guth's index and the older and the KIM model beside it (position_index.h).
#include "view/position_index.h"
#include <algorithm>
#include <cmath>

namespace view {
namespace {

double log_above(double sigma, double tau) {
    return (35.2 - 0.31889 * tau - 1.22 * std::exp(-2 * tau / 9)) * 1e-3 * sigma +
           (21 + 0.26667 * tau - 0.002963 * tau * tau) * 1e-5 * sigma * sigma;
}

double log_below(double tan_beta, bool behind = false) {
    const double beta = std::atan(tan_beta) * evalglare_deg + (behind && tan_beta < 0 ? 180 : 0);
    return 6.49e-3 * beta + 21e-5 * beta * beta;
}

double above(double sigma, double tau) { return std::exp(log_above(sigma, tau)); }

double below(const EyeAngles& a) {
    const double c = std::cos(a.tau_deg / evalglare_deg);
    return std::exp(log_below(std::tan(a.sigma_deg / evalglare_deg) * std::sqrt(1 + 0.3225 * c * c), a.behind));
}

// 1 + f R, R = sqrt(tan^2 azimuth + tan^2 elevation) seen from the point on the line of sight (Iwata et al. 1997):
// R capped at 3, f = 0.8, or 1.2 beyond 0.6.
double below_old(const Projector& p, Vec3 d) {
    const double phi = std::asin(std::clamp(dot(d, p.up()), -1.0, 1.0)),
                 theta = std::asin(std::clamp(dot(d, p.right()), -1.0, 1.0));
    const double ratio = std::tan(theta) / std::tan(phi);
    const double r = std::sqrt(ratio * ratio + 1) * std::fabs(std::tan(phi));
    return 1 + (r > 0.6 ? 1.2 : 0.8) * std::min(r, 3.0);
}

// Kim et al. 2009, degrees.
double kim(double sigma, double tau) {
    const double t2 = tau * tau, t3 = t2 * tau;
    return std::exp((sigma - (-9e-6 * t3 + 0.0014 * t2 + 0.0866 * tau + 21.633)) /
                    (-9e-6 * t3 + 0.0013 * t2 + 0.0853 * tau + 8.772));
}

}  // namespace

EyeAngles eye_angles(const Projector& p, Vec3 d, bool picture_up) {
    const double c = dot(p.forward(), d), sigma = std::acos(std::clamp(c, -1.0, 1.0));
    const Vec3 ahead = d * (1 / std::cos(sigma)) - p.forward(), t = c < 0 ? ahead * -1 : ahead;
    const double size = length(t);
    const Vec3 up = picture_up ? p.up() : unit(p.view().vu);
    const double tau = size > 0 ? std::acos(std::clamp(dot(up, t) / size, -1.0, 1.0)) : evalglare_pi / 2;
    return {sigma * evalglare_deg, tau * evalglare_deg,
            std::asin(std::clamp(dot(d, p.up()), -1.0, 1.0)) * evalglare_deg, c < 0};
}

double position_index(const EyeAngles& a, const Projector& p, Vec3 d, PositionModel model) {
    const bool accelerad = model == PositionModel::accelerad;
    if (model == PositionModel::kim) return float(kim(a.sigma_deg, a.tau_deg));
    if (a.elevation_deg >= 0) return float(std::min(above(a.sigma_deg, a.tau_deg), 16.0));
    return float(std::min(accelerad ? below_old(p, d) : below(a), 16.0));
}

double position_index(const Projector& p, Vec3 d, PositionModel model) {
    return position_index(eye_angles(p, d, model == PositionModel::accelerad), p, d, model);
}

double log_position_index(const Projector& p, Vec3 d) {
    const double c = std::min(dot(p.forward(), d), 1.0);
    const Vec3 t = d * (1 / c) - p.forward();  // length tan sigma, tan sigma cos tau along up
    const double tan2 = dot(t, t), along = dot(unit(p.view().vu), t), cap = std::log(16.0);
    if (dot(d, p.up()) < 0) return std::min(log_below(std::sqrt(tan2 + 0.3225 * along * along)), cap);
    const double cos_tau = tan2 > 0 ? std::clamp(along / std::sqrt(tan2), -1.0, 1.0) : 0;
    return std::min(log_above(std::acos(c) * evalglare_deg, std::acos(cos_tau) * evalglare_deg), cap);
}

}  // namespace view
