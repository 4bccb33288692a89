// SPDX-License-Identifier: BSD-3-Clause
// See hour_factors.h.
#include "render/hour_factors.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace render {
using namespace kernels;

namespace {

// IEEE 754 half precision, rounded to nearest; values below 6e-8 are 0.
uint16_t half_of(float f) {
    uint32_t bits;
    std::memcpy(&bits, &f, 4);
    const uint32_t sign = bits >> 16 & 0x8000u, magnitude = bits & 0x7fffffffu;
    if (magnitude >= 0x477fe000u) return uint16_t(sign | 0x7bffu);  // most_of_half
    if (magnitude < 0x38800000u) return uint16_t(sign | uint32_t(std::lrintf(std::fabs(f) * 16777216.f)));
    return uint16_t(sign | ((magnitude - 0x38000000u + 0xfffu + (magnitude >> 13 & 1u)) >> 13));
}

float float_of(uint16_t h) {
    const uint32_t sign = uint32_t(h & 0x8000u) << 16, magnitude = h & 0x7fffu;
    float f;
    if (magnitude < 0x400u) f = float(magnitude) / 16777216.f;
    else {
        const uint32_t bits = (magnitude << 13) + 0x38000000u;
        std::memcpy(&f, &bits, 4);
    }
    return sign ? -f : f;
}

constexpr float most_of_half = 65504;
constexpr float most_pieces = 4096;  // nothing that a surface does is that bright

// A response beyond half precision, that of a narrow highlight whose ray counts for many, is cut into equal pieces.
void keep(const device::SunShare& share, float per_sr, std::vector<SunFactor>& out) {
    float rgb[3], most = 0;
    for (int c = 0; c < 3; c++) {
        rgb[c] = share.rgb[c] * per_sr;
        if (!std::isfinite(rgb[c])) return;
        most = std::max(most, std::fabs(rgb[c]));
    }
    const float pieces = std::clamp(std::ceil(most / most_of_half), 1.f, most_pieces);
    SunFactor f{uint16_t(share.sun), {}};
    for (int c = 0; c < 3; c++) f.rgb[c] = half_of(rgb[c] / pieces);
    out.insert(out.end(), size_t(pieces), f);
}

}  // namespace

void unpack(const SunFactor& factor, float* rgb) {
    for (int c = 0; c < 3; c++) rgb[c] = float_of(factor.rgb[c]);
}

uint64_t PathFactors::bytes() const {
    return sizeof(device::SkyShare) * sky.size() + 8 * suns_at.size() + sizeof(SunFactor) * suns.size() +
           4 * (shares.size() + sample.size() + rest.size());
}

PathFactors draw_factors(device::Device& device, const device::Params& par, uint32_t samples) {
    device::HourPaths paths;
    device.run_hours(par, paths);
    PathFactors out;
    out.samples = samples;
    scrub(paths.rest);
    out.rest = std::move(paths.rest);
    if (par.reuse_path_count != 0)
        for (uint32_t path = 0; path < par.path_count; path++) out.sample.push_back(film_place(&par, path));
    const float per_sr = par.suns_count > 0 ? 1 / par.view_tables->suns[0].area : 0;
    out.suns.reserve(paths.suns.size());
    out.suns_at.push_back(0);
    for (size_t list = 1; list < paths.suns_at.size(); list++) {
        for (uint64_t i = paths.suns_at[list - 1]; i < paths.suns_at[list]; i++) keep(paths.suns[i], per_sr, out.suns);
        out.suns_at.push_back(out.suns.size());
    }
    out.sky = std::move(paths.sky);
    out.shares = std::move(paths.shares);
    return out;
}

}  // namespace render
