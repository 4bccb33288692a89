// SPDX-License-Identifier: BSD-3-Clause
// See part_offsets.h.
#include "image/part_offsets.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace image {
namespace {

constexpr int digits = 3;          // behind the first one
constexpr int largest_power = 14;  // half floats end below 2^16

float rounded(float v) {
    constexpr uint32_t tail = 23 - digits;
    uint32_t bits = 0;
    std::memcpy(&bits, &v, sizeof bits);
    bits = (bits + (1u << (tail - 1))) & ~((1u << tail) - 1);
    std::memcpy(&v, &bits, sizeof bits);
    return v;
}

}  // namespace

PartOffsets part_offsets(const std::vector<Part>& parts, const std::vector<float>& mean) {
    PartOffsets out;
    float largest = 0;
    for (const Part& part : parts)
        for (size_t i = 0; i < mean.size(); ++i) largest = std::max(largest, std::fabs(part.grey[i] - mean[i]));
    if (largest > 0 && std::isfinite(largest)) out.scale = std::ilogb(largest) - largest_power;
    for (const Part& part : parts) {
        std::vector<float>& off = out.of.emplace_back(mean.size());
        for (size_t i = 0; i < mean.size(); ++i) off[i] = rounded(std::ldexp(part.grey[i] - mean[i], -out.scale));
    }
    return out;
}

void add_offsets(std::vector<Part>& parts, int scale, const std::vector<float>& mean) {
    const double frames = double(frames_of(parts));
    for (size_t i = 0; i < mean.size(); ++i) {
        double off = 0;
        for (const Part& part : parts) off += double(part.frames) / frames * double(part.grey[i]);
        for (Part& part : parts) part.grey[i] = float(double(mean[i]) + std::ldexp(double(part.grey[i]) - off, scale));
    }
}

}  // namespace image
