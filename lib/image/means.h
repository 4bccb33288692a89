// SPDX-License-Identifier: BSD-3-Clause
// A growing sum at the ends of batches of its frames, from which its error is told (comfort/batches.h).
// The sum of L(0) + L(k) over frames a+1..b is b L'(b) - a L'(a), so the grey means L'(n) at the batches' ends are all
// that is kept, and two neighbouring batches become one by forgetting the mean between them.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace image {

constexpr size_t most_means = 16;

struct GreyMean {
    int64_t frames = 0;       // n, above 0
    std::vector<float> grey;  // L'(n) (grey.h), row 0 = top
};

// Forgets means until there are `most`: each time between the neighbours that hold the fewest frames together.
// Returns the memory of one that was forgotten.
std::vector<float> forget_means(std::vector<GreyMean>& means, size_t most);

// L'(n), n above those before it; a mean of as many frames as the last one is that one.
void add_mean(std::vector<GreyMean>& means, int64_t frames, const std::vector<float>& rgb, size_t most);

}  // namespace image
