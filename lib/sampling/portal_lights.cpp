// SPDX-License-Identifier: BSD-3-Clause
// In sunlight, portals are sampled in proportion to the light that they send to each point, scaled by one factor; under
// the sky alone the mixture weight is the same everywhere.  Candidates are compared by the second moment of the pilots'
// light. A glossy reflector is added if it clearly reduces the variance where its highlight is visible.
#include "sampling/portal_lights.h"

#include <algorithm>

namespace kernels {
#include "kernels/bvh/instance.h"
#include "kernels/geom/surface.h"
#include "kernels/sampling/mixture.h"
}  // namespace kernels

namespace sampling {
namespace {

using namespace kernels;

constexpr double MIN_SELECTION_PROB = .015;  // probability below which a portal only costs time
constexpr double MIN_VARIANCE_GAIN =
    10;  // least ratio of the second moment that a glossy reflector saves to what it adds
constexpr double MIN_REFLECTOR_PROB = .0005;  // the same for a glossy reflector
constexpr size_t BRIGHTEST = 500;  // one in this number of pilots, the brightest, is excluded: too few to estimate from
constexpr double DIMMED[] = {1, .5, .25, .125};  // factors of all portals' light to try
constexpr int STEPS = 8;                         // of constant mixture weights to try: 0, 1/8 .. 7/8

// Mean of the squares without the greatest.
double trimmed_mean(std::vector<double>& squares) {
    if (squares.empty()) return 0;
    const size_t kept = squares.size() - squares.size() / BRIGHTEST;
    std::nth_element(squares.begin(), squares.begin() + long(kept) - 1, squares.end());
    double sum = 0;
    for (size_t i = 0; i < kept; i++) sum += squares[i];
    return sum / double(kept);
}

class MixtureOptimiser {
public:
    MixtureOptimiser(const SceneTables& tables, std::vector<PilotPath>& pilots,
                     const std::vector<PilotPath>& to_reflectors, double mean, Params& par)
        : tables_(tables), pilots_(pilots), to_reflectors_(to_reflectors), mean_(mean), par_(par) {}

    void optimise() {
        const uint32_t all = par_.portals_count;
        while (par_.portals_count > 0 && is_reflector(par_.portals_count - 1)) par_.portals_count--;  // they come last
        const uint32_t reflectors = par_.portals_count;
        const bool sun_comes_in = reflectors > par_.window_count;
        update_aimed();
        if (sun_comes_in) {
            drop_improbable();
            update_aimed();
            choose_light();
            add_reflectors(reflectors, all);
        } else {
            choose_share();
        }
        for (size_t i = 0; i < pilots_.size(); i++) pilots_[i].portal_pdf = mixed(i, 1);
    }

private:
    // Light of all portals at a pilot's origin, and the pdf of its direction among those toward portals, over the
    // cosine's.
    struct Aimed {
        double total = 0, pdf = 0;
    };
    const SceneTables& tables_;
    std::vector<PilotPath>& pilots_;
    const std::vector<PilotPath>& to_reflectors_;
    const double mean_;
    Params& par_;
    std::vector<Aimed> aimed_;

    double light(const PilotPath& pilot) const { return pilot.gathered + pilot.throughput * mean_; }

    // Sets aimed_ for each pilot, and the light from other directions where portals are in view.
    void update_aimed() {
        aimed_.clear();
        std::vector<double> squares;
        for (const PilotPath& pilot : pilots_) {
            Aimed aimed;
            const float total = portals_light(&tables_, &par_, pilot.p, pilot.n), c = dot3(pilot.dir, pilot.n);
            if (total > 0 && c > 0) {
                aimed.total = double(total);
                const float pdf = portals_pdf(&tables_, &par_, pilot.p, pilot.n, pilot.dir, total);
                aimed.pdf = double(pdf) / (double(c) * K_INV_PI);
                if (aimed.pdf <= 0) squares.push_back(light(pilot) * light(pilot));
            }
            aimed_.push_back(aimed);
        }
        par_.portal_rest = K_PI * float(std::sqrt(trimmed_mean(squares)));
    }

    bool is_reflector(uint32_t k) const { return portal_record(&tables_, &par_, k)->gloss2 > 0; }

    // Mean probability of a portal.
    double share_of(uint32_t k) const {
        double share = 0;
        for (size_t i = 0; i < pilots_.size(); i++) {
            const float view = portal_view(portal_record(&tables_, &par_, k), pilots_[i].p, pilots_[i].n);
            const double sent = double(par_.portal_light[k]) * double(view);
            if (sent > 0) share += sent / (aimed_[i].total + double(par_.portal_rest)) / double(pilots_.size());
        }
        return share;
    }

    void keep(uint32_t k) {
        par_.portal_pick[par_.portals_count] = par_.portal_pick[k];
        par_.portal_light[par_.portals_count++] = par_.portal_light[k];
    }

    // Removes portals of small probability.
    void drop_improbable() {
        std::vector<double> shares;
        for (uint32_t k = 0; k < par_.portals_count; k++) shares.push_back(share_of(k));
        const double least = std::min(MIN_SELECTION_PROB, .2 * *std::max_element(shares.begin(), shares.end()));
        par_.portals_count = 0;
        for (uint32_t k = 0; k < shares.size(); k++)
            if (!(shares[k] < least)) keep(k);
    }

    // Portals first .. end - 1 are glossy reflectors.  Pilots by the cosine rarely hit a highlight, so pilots toward
    // the reflectors decide.
    void add_reflectors(uint32_t first, uint32_t end) {
        const float rest = par_.portal_rest;
        for (uint32_t k = first; k < end; k++)
            if (reduces_variance(k)) keep(k);
        update_aimed();
        par_.portal_rest = rest;
    }

    // Over the points with pilots to reflector k: returns true if the second moment of the reflector's light falls by
    // more than that of all other light rises, which is sampled less often.
    bool reduces_variance(uint32_t k) const {
        const Portal* reflector = portal_record(&tables_, &par_, k);
        double saved = 0, lost = 0;
        for (const PilotPath& pilot : to_reflectors_) {
            const float view = portal_view(reflector, pilot.p, pilot.n),
                        aimed = portal_pdf(reflector, pilot.p, pilot.dir);
            if (pilot.target != par_.portal_pick[k] || !(view > 0 && aimed > 0)) continue;
            const float total = portals_light(&tables_, &par_, pilot.p, pilot.n);
            const double others = double(total), sent = double(par_.portal_light[k]) * double(view);
            const double before = double(portals_weight(&par_, total));
            const double now = double(portals_weight(&par_, float(others + sent))),
                         reflectors = now * sent / (others + sent);

            const double cosine = double(dot3(pilot.dir, pilot.n)) * K_INV_PI, f = light(pilot) * cosine;
            const double by_cosine = (1 - before) * cosine, mixed = (1 - now) * cosine + reflectors * double(aimed);
            saved += (f * f / by_cosine - f * f / mixed) / double(aimed);
            const double rest = double(par_.portal_rest) * K_INV_PI, through = others * K_INV_PI;
            lost += rest * rest * (1 / (1 - now) - 1 / (1 - before));
            if (before > 0) lost += through * through * (1 / (now - reflectors) - 1 / before);
        }
        return saved > MIN_VARIANCE_GAIN * lost && share_of(k) >= MIN_REFLECTOR_PROB;
    }

    // Pdf of a pilot's direction over the cosine's, with `dimmed` times the portals' light.
    double mixed(size_t i, double dimmed) const {
        const double share = double(portals_weight(&par_, float(dimmed * aimed_[i].total)));
        return 1 - share + share * aimed_[i].pdf;
    }

    double moment(const PilotSums& sums) const { return sums.all_bounces(par_, double(pilots_.size())).square; }

    double moment(double dimmed) const {
        PilotSums all;
        for (size_t i = 0; i < pilots_.size(); i++) all.add(pilots_[i], 1, mixed(i, dimmed));
        return moment(all);
    }

    // The same without the brightest pilots, which are too few to compare by.
    double moment_of_most(double dimmed) const {
        std::vector<double> squares, order;
        for (size_t i = 0; i < pilots_.size(); i++)
            squares.push_back(light(pilots_[i]) * light(pilots_[i]) / mixed(i, dimmed));
        order = squares;
        const auto brightest = order.end() - long(order.size() / BRIGHTEST) - 1;
        std::nth_element(order.begin(), brightest, order.end());
        PilotSums most;
        for (size_t i = 0; i < pilots_.size(); i++)
            if (squares[i] <= *brightest) most.add(pilots_[i], 1, mixed(i, dimmed));
        return moment(most);
    }

    // Sunlight: portals in proportion to their light.  Among the factors whose second moment is at most the cosine's,
    // with all pilots, chooses the one with the least second moment without the brightest.
    void choose_light() {
        const double plain = moment(0);
        double best = 0, least = moment_of_most(0);
        for (const double dimmed : DIMMED) {
            const double found = moment_of_most(dimmed);
            if (!(found < least && moment(dimmed) <= plain)) continue;
            least = found;
            best = dimmed;
        }
        for (uint32_t k = 0; k < par_.portals_count; k++) par_.portal_light[k] *= float(best);
        for (Aimed& aimed : aimed_) aimed.total *= best;
        if (best <= 0) par_.portals_count = 0;
    }

    // Sky alone: the largest constant mixture weight whose second moment is at most the cosine's.  Light through
    // windows is smooth, so the sequence of samples estimates it with less variance than independent samples suggest.
    void choose_share() {
        const double plain = moment(0);
        int step = STEPS;
        do {
            step--;
            par_.portal_least = par_.portal_most = float(step) / STEPS;
        } while (step > 0 && !(moment(1) <= plain));
        if (step == 0) par_.portals_count = 0;
    }
};

}  // namespace

void PilotPath::set_end(const device::PilotEnd& end) {
    const auto luminance = [](const float(&c)[3]) {
        const double v = luminance3(F3(c[0], c[1], c[2]));
        return std::isfinite(v) && v > 0 ? v : 0;
    };
    gathered = luminance(end.gathered);
    throughput = end.bounce ? luminance(end.throughput) : 0;
}

void weigh_portals(const SceneTables& tables, std::vector<PilotPath>& pilots,
                   const std::vector<PilotPath>& to_reflectors, double mean, Params& par) {
    MixtureOptimiser(tables, pilots, to_reflectors, mean, par).optimise();
}

}  // namespace sampling
