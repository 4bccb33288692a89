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

class ConeOfSight : public Field {
public:
    ConeOfSight(const Space& s, double full_deg) : axis_(s.projector.forward()), half_(full_deg / 2 * base::degree) {}
    double value(const Point& p) const override { return half_ - angle_between(p.dir, axis_); }

private:
    Vec3 axis_;
    double half_;
};

// ln P changes by at most 4.1 per radian (straight up, 90 degrees from the line of sight); 6 leaves room for tilted
// views.
class Band : public Field {
public:
    Band(const Space& s, double low, double high)
        : projector_(s.projector), low_(std::log(std::max(low, 1e-6))), high_(std::log(std::max(high, 1e-6))) {}
    double value(const Point& p) const override {
        double ahead = dot(p.dir, projector_.forward());  // no more than the angle that is left: its sine
        if (ahead <= 0) return ahead;                     // behind the eye there is no position index
        double log_p = view::log_position_index(projector_, p.dir);
        return std::min(std::min(log_p - low_, high_ - log_p) / 6, ahead);
    }

private:
    const view::Projector& projector_;
    double low_, high_;
};

// sigma limited as a function of tau.
class Eye : public Field {
public:
    Eye(const Space& s, bool both) : projector_(s.projector), both_(both) {}
    double value(const Point& p) const override {
        double ahead = base::pi / 2 - angle_between(p.dir, projector_.forward());
        if (ahead <= 0) return ahead;
        view::EyeAngles at = view::eye_angles(projector_, p.dir);
        double v = std::min((limit(at) - at.sigma_deg) / 4, 90 - at.sigma_deg) * base::degree;
        if (both_) return v;
        // The total field has steps at tau = 135 and along the horizon: never claim to know beyond them.
        double s = std::sin(at.sigma_deg * base::degree);
        double step = std::min(std::asin(std::min(1.0, s * std::fabs(std::sin((at.tau_deg - 135) * base::degree)))),
                               std::asin(std::min(1.0, s * std::fabs(std::cos(at.tau_deg * base::degree)))));
        step = std::max(step, 1e-9);
        return std::clamp(v, -step, step);
    }

private:
    double limit(const view::EyeAngles& a) const {
        const double t = a.tau_deg, c = 180 - t;
        if (both_) {
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
    const view::Projector& projector_;
    bool both_;
};

}  // namespace

std::unique_ptr<Field> make_zone(const Shape& s, const Space& space) {
    if (space.behind > 0) base::fail(s.place, "zones of the field of view need a view with an eye point, not -vtl");
    if (s.text == "central") return std::make_unique<ConeOfSight>(space, s.numbers[0]);
    if (s.text == "ergorama") return std::make_unique<ConeOfSight>(space, 60);
    if (s.text == "panorama") return std::make_unique<ConeOfSight>(space, 120);
    if (s.text == "position") return std::make_unique<Band>(space, s.numbers[0], s.numbers[1]);
    return std::make_unique<Eye>(space, s.text == "binocular");
}

}  // namespace region
