// SPDX-License-Identifier: BSD-3-Clause
// See means.h.
#include "image/means.h"

#include "image/grey.h"

namespace image {

std::vector<float> forget_means(std::vector<GreyMean>& means, size_t most) {
    std::vector<float> memory;
    while (means.size() > most) {
        // Frames in batches k and k + 1 together.
        const auto frames = [&](size_t k) { return means[k + 1].frames - (k ? means[k - 1].frames : 0); };
        size_t least = 0;
        for (size_t k = 1; k + 1 < means.size(); ++k)
            if (frames(k) < frames(least)) least = k;
        memory = std::move(means[least].grey);
        means.erase(means.begin() + std::ptrdiff_t(least));
    }
    return memory;
}

void add_mean(std::vector<GreyMean>& means, int64_t frames, const std::vector<float>& rgb, size_t most) {
    if (frames <= (means.empty() ? 0 : means.back().frames)) return;
    means.push_back({frames, std::vector<float>(rgb.size() / 3)});
    to_grey(rgb.data(), rgb.size() / 3, means.back().grey.data());
    forget_means(means, most);
}

}  // namespace image
