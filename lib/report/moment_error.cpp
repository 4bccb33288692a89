// SPDX-License-Identifier: BSD-3-Clause
// See moment_error.h.
#include "report/moment_error.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/processors.h"
#include "base/threads.h"
#include "uncertainty/frame0.h"

namespace report {
namespace {

// v + e (up: 1) or v - e (-1); below 0 there is none.
image::Moments moved(const std::vector<float>& moments, int pair, float up) {
    std::vector<float> out = moments;
    for (size_t i = 0; i < out.size(); i += image::moment_numbers) {
        const auto sign = float(uncertainty::random_sign(uint32_t(i / image::moment_numbers), pair));
        float& v = out[i + image::moment_variance];
        v = std::max(0.0f, v + up * sign * out[i + image::moment_difference]);
    }
    return std::make_shared<const std::vector<float>>(std::move(out));
}

}  // namespace

std::vector<uncertainty::Values> moment_values(const glare::Reading& whole, const std::vector<glare::Column>& columns) {
    const image::Moments& moments = whole.lum.moments;
    const auto of_filled = [](const glare::Column& c) { return c.of_filled; };
    if (!moments || std::none_of(columns.begin(), columns.end(), of_filled)) return {};
    std::vector<uncertainty::Values> seen(2 * moment_pairs);
    std::atomic<size_t> next{0};
    base::on_threads(std::min(base::processors(), unsigned(seen.size())), [&] {
        for (size_t k = next++; k < seen.size(); k = next++) {
            glare::Luminance here = whole.lum;
            here.moments = moved(*moments, int(k / 2), k % 2 ? -1 : 1);
            const glare::Measurement m = glare::measure(whole, here, here);
            for (const glare::Column& c : columns) seen[k].push_back(c.of_filled ? c.value(m) : 0);
        }
    });
    return seen;
}

}  // namespace report
