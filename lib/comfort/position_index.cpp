// SPDX-License-Identifier: BSD-3-Clause
#include "comfort/position_index.h"
#include <algorithm>
#include <cmath>

namespace comfort {
namespace {

double above(double sigma, double tau) {
    return std::exp((35.2 - 0.31889 * tau - 1.22 * std::exp(-2 * tau / 9)) * 1e-3 * sigma +
                    (21 + 0.26667 * tau - 0.002963 * tau * tau) * 1e-5 * sigma * sigma);
}

double below(double sigma, double tau) {
    const double c = std::cos(tau / evalglare_deg);
    const double beta = std::atan(std::tan(sigma / evalglare_deg) * std::sqrt(1 + 0.3225 * c * c)) * evalglare_deg;
    return std::exp(6.49e-3 * beta + 21e-5 * beta * beta);
}

// 1 + f R, R = sqrt(tan^2 azimuth + tan^2 elevation) seen from the point on the line of sight (Iwata et al. 1997):
// R capped at 3, f = 0.8, or 1.2 beyond 0.6.
double below_old(const view::Projector& p, Vec3 d) {
    const double phi = std::asin(std::clamp(dot(d, p.up()), -1.0, 1.0)), theta = std::asin(std::clamp(dot(d, p.right()), -1.0, 1.0));
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

EyeAngles eye_angles(const view::Projector& p, Vec3 d, bool picture_up) {
    const double c = dot(p.forward(), d), sigma = std::acos(std::clamp(c, -1.0, 1.0));
    const Vec3 t = d * (1 / std::cos(sigma)) - p.forward();
    const double size = length(t);
    const Vec3 up = picture_up ? p.up() : unit(p.view().vu);
    const double tau = size > 0 ? std::acos(std::clamp(dot(up, t) / size, -1.0, 1.0)) : evalglare_pi / 2;
    return {sigma * evalglare_deg, tau * evalglare_deg, std::asin(std::clamp(dot(d, p.up()), -1.0, 1.0)) * evalglare_deg};
}

double position_index(const view::Projector& p, Vec3 d, PositionModel model) {
    const bool accelerad = model == PositionModel::accelerad;
    const EyeAngles a = eye_angles(p, d, accelerad);
    if (model == PositionModel::kim) return float(kim(a.sigma_deg, a.tau_deg));
    if (a.elevation_deg >= 0) return float(std::min(above(a.sigma_deg, a.tau_deg), 16.0));
    return float(std::min(accelerad ? below_old(p, d) : below(a.sigma_deg, a.tau_deg), 16.0));
}

}  // namespace comfort
