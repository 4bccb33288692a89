// SPDX-License-Identifier: BSD-3-Clause
// Zones around the line of sight: cones (central 30 degrees, ergorama 60, panorama 120, all full angles), bands of
// Guth's position index, and the total and binocular fields as evalglare's -G 1 and 2 cut them. sigma = angle from the
// line of sight, tau = angle around it from straight up, both in degrees.
#include "region/zone.h"
#include <algorithm>
#include <cmath>
#include "base/angle.h"
#include "base/error.h"
#include "view/position_index.h"
#include "region/arcs.h"

namespace region {
using namespace base;
namespace {

// ln P changes by at most 4.1 per radian (straight up, 90 degrees from the line of sight); 6 leaves room for tilted
// views.
Field band(const view::Projector& projector, double lowest, double highest) {
    const double low = std::log(std::max(lowest, 1e-6)), high = std::log(std::max(highest, 1e-6));
    return {[&projector, low, high](const Point& p) {
        double ahead = dot(p.dir, projector.forward());  // no more than the angle that is left: its sine
        if (ahead <= 0) return ahead;                    // behind the eye there is no position index
        double log_p = view::log_position_index(projector, p.dir);
        return std::min(std::min(log_p - low, high - log_p) / 6, ahead);
    }};
}

// The largest sigma, of both eyes or of either.
double sigma_limit(const view::EyeAngles& a, bool both) {
    const double t = a.tau_deg, c = 180 - t;
    if (both) {
        if (a.elevation_deg > 0 || c > 73) return 60;
        return (68.227109 - 2.9524084 * c + 0.046674262 * c * c) /
               (1 - 0.042317294 * c + 7.5698419e-4 * c * c - 6.5364285e-7 * c * c * c);
    }
    if (a.elevation_deg > 0) {
        double root = 7.7458218 + 5.7407915e-4 * t - 2.1746318e-4 * t * t + 8.5572726e-6 * t * t * t;
        return root * root;
    }
    if (t <= 135) return 180;
    return -1 / (-0.014699242 - 1.5541106e-5 * c + 4.6898068e-6 * c * c - 5.1539687e-8 * c * c * c);
}

Field eye_field(const view::Projector& projector, bool both) {
    return {[&projector, both](const Point& p) {
        double ahead = base::pi / 2 - angle_between(p.dir, projector.forward());
        if (ahead <= 0) return ahead;
        view::EyeAngles at = view::eye_angles(projector, p.dir);
        double v = std::min((sigma_limit(at, both) - at.sigma_deg) / 4, 90 - at.sigma_deg) * base::degree;
        if (both) return v;
        // The total field has steps at tau = 135 and along the horizon: never claim to know beyond them.
        double s = std::sin(at.sigma_deg * base::degree);
        double step = std::min(std::asin(std::min(1.0, s * std::fabs(std::sin((at.tau_deg - 135) * base::degree)))),
                               std::asin(std::min(1.0, s * std::fabs(std::cos(at.tau_deg * base::degree)))));
        step = std::max(step, 1e-9);
        return std::clamp(v, -step, step);
    }};
}

}  // namespace

Field make_zone(const Shape& s, const Space& space) {
    if (space.behind > 0) base::fail(s.place, "zones of the field of view need a view with an eye point, not -vtl");
    const Vec3 ahead = space.projector.forward();
    if (s.text == "central") return cone(ahead, s.numbers[0] / 2 * base::degree);
    if (s.text == "ergorama") return cone(ahead, 60. / 2 * base::degree);
    if (s.text == "panorama") return cone(ahead, 120. / 2 * base::degree);
    if (s.text == "position") return band(space.projector, s.numbers[0], s.numbers[1]);
    return eye_field(space.projector, s.text == "binocular");
}

}  // namespace region
