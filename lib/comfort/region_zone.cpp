// SPDX-License-Identifier: BSD-3-Clause
// Zones around the line of sight: cones (central 30 degrees, ergorama 60, panorama 120, all full angles), bands of Guth's
// position index, and the total and binocular fields as evalglare's -G 1 and 2 cut them.
// sigma = angle from the line of sight, tau = angle around it from straight up, both in degrees.
#include "comfort/region_zone.h"
#include <algorithm>
#include <cmath>
#include "base/error.h"
#include "comfort/region_arcs.h"

namespace region {
using namespace base;
namespace {

const double DEG = M_PI / 180;

// Where a direction lies in the field of view.
struct Polar {
    double sigma, tau;
    bool above;  // the line of sight
};
class Axes {
public:
    explicit Axes(const Space& s) : forward_(s.projector.forward()), up_(s.projector.up()), vu_(unit(s.projector.view().vu)) {}
    Polar polar(Vec3 d) const {
        Polar p;
        p.sigma = angle_between(d, forward_) / DEG;
        Vec3 t = d - forward_ * dot(d, forward_);  // tau is measured against the up vector as given, as evalglare does
        double l = length(t);
        p.tau = l > 1e-12 ? std::acos(std::clamp(dot(t, vu_) / l, -1.0, 1.0)) / DEG : 90;
        p.above = dot(d, up_) >= 0;
        return p;
    }
private:
    Vec3 forward_, up_, vu_;
};

// ln of the position index (Guth; below the line of sight Iwata's form as in evalglare 3.02), at most ln 16.
double log_position_index(const Polar& p) {
    double s = p.sigma, t = p.tau, log_p;
    if (p.above) {
        log_p = (35.2 - 0.31889 * t - 1.22 * std::exp(-2 * t / 9)) * 1e-3 * s + (21 + 0.26667 * t - 0.002963 * t * t) * 1e-5 * s * s;
    } else {
        double c = std::cos(t * DEG), beta = std::atan(std::tan(std::min(s, 89.999) * DEG) * std::sqrt(1 + 0.3225 * c * c)) / DEG;
        log_p = 6.49e-3 * beta + 21e-5 * beta * beta;
    }
    return std::min(log_p, std::log(16.0));
}

class Cone : public Field {
public:
    Cone(const Space& s, double full_deg) : axis_(s.projector.forward()), half_(full_deg / 2 * DEG) {}
    double value(const Point& p) const override { return half_ - angle_between(p.dir, axis_); }
private:
    Vec3 axis_;
    double half_;
};

// ln P changes by at most 4.1 per radian (straight up, 90 degrees from the line of sight); 6 leaves room for tilted views.
class Band : public Field {
public:
    Band(const Space& s, double low, double high) : axes_(s), low_(std::log(std::max(low, 1e-6))), high_(std::log(std::max(high, 1e-6))) {}
    double value(const Point& p) const override {
        Polar at = axes_.polar(p.dir);
        double log_p = log_position_index(at);
        return std::min(std::min(log_p - low_, high_ - log_p) / 6, (90 - at.sigma) * DEG);
    }
private:
    Axes axes_;
    double low_, high_;
};

// sigma limited as a function of tau.
class Eye : public Field {
public:
    Eye(const Space& s, bool both) : axes_(s), both_(both) {}
    double value(const Point& p) const override {
        Polar at = axes_.polar(p.dir);
        double v = std::min((limit(at) - at.sigma) / 4, 90 - at.sigma) * DEG;
        if (both_) return v;
        // The total field has steps at tau = 135 and along the horizon: never claim to know beyond them.
        double s = std::sin(at.sigma * DEG);
        double step = std::min(std::asin(std::min(1.0, s * std::fabs(std::sin((at.tau - 135) * DEG)))),
                               std::asin(std::min(1.0, s * std::fabs(std::cos(at.tau * DEG)))));
        step = std::max(step, 1e-9);
        return std::clamp(v, -step, step);
    }
private:
    double limit(const Polar& p) const {
        double t = p.tau, c = 180 - t;
        if (both_) {
            if (p.above || c > 73) return 60;
            return (68.227109 - 2.9524084 * c + 0.046674262 * c * c) /
                   (1 - 0.042317294 * c + 7.5698419e-4 * c * c - 6.5364285e-7 * c * c * c);
        }
        if (p.above) {
            double root = 7.7458218 + 5.7407915e-4 * t - 2.1746318e-4 * t * t + 8.5572726e-6 * t * t * t;
            return root * root;
        }
        if (t <= 135) return 180;
        return -1 / (-0.014699242 - 1.5541106e-5 * c + 4.6898068e-6 * c * c - 5.1539687e-8 * c * c * c);
    }
    Axes axes_;
    bool both_;
};

}  // namespace

std::unique_ptr<Field> make_zone(const Shape& s, const Space& space) {
    if (space.behind > 0) base::fail(s.place, "zones of the field of view need a view with an eye point, not -vtl");
    if (s.text == "central") return std::make_unique<Cone>(space, s.numbers[0]);
    if (s.text == "ergorama") return std::make_unique<Cone>(space, 60);
    if (s.text == "panorama") return std::make_unique<Cone>(space, 120);
    if (s.text == "position") return std::make_unique<Band>(space, s.numbers[0], s.numbers[1]);
    return std::make_unique<Eye>(space, s.text == "binocular");
}

}  // namespace region
