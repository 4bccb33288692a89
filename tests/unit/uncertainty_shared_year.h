// SPDX-License-Identifier: BSD-3-Clause
// A made-up year of hours that were rendered with one set of paths: of each part of the frames an error that all hours
// have in common, one that hours with near suns have in common, and one of the hour's own.
#pragma once
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "uncertainty/replication.h"
#include "uncertainty/shared_counts.h"

struct SharedYear {
    std::vector<double> truth;
    std::vector<uncertainty::Shared> seen;
    double strata = 0;
};

class SharedYears {
public:
    // error: of an hour, relative; shares: of its variance, in the order of above.
    SharedYears(unsigned seed, int parts, double error, std::array<double, 3> shares)
        : parts_(parts), error_(error), shares_(shares), random_(seed) {}

    SharedYear draw(size_t hours) {
        using namespace uncertainty;
        SharedYear year;
        const Frames frames(size_t(parts_), 1);
        year.strata = degrees_of_freedom(frames);
        std::vector<std::vector<double>> of_part(hours, std::vector<double>(size_t(parts_)));
        std::vector<std::array<double, 2>> suns(hours);
        for (size_t h = 0; h < hours; ++h) {
            year.truth.push_back(400 * std::exp(normal_(random_)));
            suns[h] = {uniform_(random_), uniform_(random_)};
        }
        for (int p = 0; p < parts_; ++p) add_part(year.truth, suns, size_t(p), of_part);
        for (size_t h = 0; h < hours; ++h) year.seen.push_back(estimated(of_part[h], frames));
        return year;
    }

private:
    void add_part(const std::vector<double>& truth, const std::vector<std::array<double, 2>>& suns, size_t part,
                  std::vector<std::vector<double>>& of_part) {
        constexpr int waves = 12;  // whose sum is a smooth random function of the sun
        constexpr double pi = 3.14159265358979;
        double direction[waves][3];
        for (auto& d : direction)
            d[0] = 4 * normal_(random_), d[1] = 4 * normal_(random_), d[2] = 2 * pi * uniform_(random_);
        const double all = normal_(random_), scale = error_ * std::sqrt(parts_);
        for (size_t h = 0; h < truth.size(); ++h) {
            double near = 0;
            for (const auto& d : direction)
                near += std::sqrt(2. / waves) * std::cos(2 * pi * (d[0] * suns[h][0] + d[1] * suns[h][1]) + d[2]);
            const double e =
                std::sqrt(shares_[0]) * all + std::sqrt(shares_[1]) * near + std::sqrt(shares_[2]) * normal_(random_);
            of_part[h][part] = truth[h] * (1 + scale * e);
        }
    }

    // As vcmetrics estimates a mean and its error.
    static uncertainty::Shared estimated(const std::vector<double>& parts, const uncertainty::Frames& frames) {
        using namespace uncertainty;
        double whole = 0;
        for (const double p : parts) whole += p / double(parts.size());
        std::vector<double> halves;
        for (int k = 0; k < half_samples; ++k) {
            const Weights w = half_sample(frames, k);
            halves.push_back(0);
            for (size_t p = 0; p < parts.size(); ++p) halves.back() += w[p] * parts[p];
        }
        const Estimate e = brr(whole, halves, frames, NoiseBias::none, 0);
        Shared out;
        out.of = {e.value, e.error, 0, 0, e.degrees};
        out.off = off(halves_of(halves, e.degrees).codes);
        return out;
    }

    int parts_;
    double error_;
    std::array<double, 3> shares_;
    std::mt19937 random_;
    std::normal_distribution<double> normal_;
    std::uniform_real_distribution<double> uniform_;
};
