// SPDX-License-Identifier: BSD-3-Clause
// Means over seeds and their standard errors, squared.
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

namespace laws {

struct Means {
    std::vector<double> mean, variance;
    explicit Means(size_t values = 0) : mean(values), variance(values) {}
};

inline Means over_seeds(int seeds, size_t values, const std::function<std::vector<double>(uint64_t)>& of) {
    Means out(values);
    for (int seed = 1; seed <= seeds; seed++) {
        const std::vector<double> value = of(uint64_t(seed));
        for (size_t i = 0; i < values; i++) {
            out.mean[i] += value[i] / seeds;
            out.variance[i] += value[i] * value[i] / seeds;
        }
    }
    for (size_t i = 0; i < values; i++) out.variance[i] = (out.variance[i] - out.mean[i] * out.mean[i]) / (seeds - 1);
    return out;
}

}  // namespace laws
