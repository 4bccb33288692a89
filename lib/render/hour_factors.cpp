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

// Its exponent is 112 less than a float's.
float float_of(uint16_t h) {
    const uint32_t bits = uint32_t(h & 0x8000u) << 16 | uint32_t(h & 0x7fffu) << 13;
    float f;
    std::memcpy(&f, &bits, 4);
    return f * 0x1p112f;
}

Factor pack(uint32_t of, const float* rgb, float by) {
    return {uint16_t(of), {half_of(by * rgb[0]), half_of(by * rgb[1]), half_of(by * rgb[2])}};
}

constexpr float most_of_half = 65504;
constexpr float most_pieces = 4096;  // nothing that a surface does is that bright

// A response beyond half precision, that of a narrow highlight whose ray counts for many, is cut into equal pieces.
void keep(uint32_t hour, const float* response, float per_sr, std::vector<Factor>& out) {
    float most = 0;
    for (int c = 0; c < 3; c++) {
        if (!std::isfinite(response[c] * per_sr)) return;
        most = std::max(most, std::fabs(response[c] * per_sr));
    }
    const float pieces = std::clamp(std::ceil(most / most_of_half), 1.f, most_pieces);
    out.insert(out.end(), size_t(pieces), pack(hour, response, per_sr / pieces));
}

}  // namespace

void unpack(const Factor& factor, float* rgb) {
    for (int c = 0; c < 3; c++) rgb[c] = float_of(factor.rgb[c]);
}

uint64_t PathFactors::bytes() const {
    return sizeof(device::SkyShare) * sky.size() + 8 * suns_at.size() + sizeof(Factor) * (suns.size() + shares.size()) +
           8 * shares_at.size() + 4 * (sample.size() + rest.size()) + (gathered ? gathered->bytes() : 0);
}

namespace {

// The pass in which the paths of a pass are sensors where they have ended: each a pixel, square by square.
device::Params params_of_gather(const device::Params& par, const device::HourPaths& paths) {
    ViewTables tables = *par.view_tables;
    tables.points.assign(paths.sky.size(), {});
    for (size_t i = 0; i < paths.sky.size(); i++) {
        if (paths.sky[i].kind != SKY_GATHERS) continue;
        PointRay& ray = tables.points[i];
        const float *p = &paths.end[3 * i], *n = paths.sky[i].dir;
        ray = {{p[0], p[1], p[2]}, {-n[0], -n[1], -n[2]}};
    }
    device::Params out = device::with_view(par, std::move(tables));
    out.nx = REUSE_SIDE;
    out.ny = par.path_count / REUSE_SIDE;
    out.samples_per_pass = 1;
    out.reuse_path_count = par.path_count;
    out.flags = (par.flags | PF_SENSORS) & ~uint32_t(PF_GATHERS | PF_EYE_ON_SURFACE);
    out.skip_direct_below = UINT32_MAX;  // known of the suffix vertices
    out.redraw = hash32(par.redraw ^ 0x7f4a7c15u);
    out.ab -= out.ab > 0;
    out.lr += out.lr < 0;
    return out;
}

}  // namespace

PathFactors draw_factors(device::Device& device, const device::Params& par, uint32_t samples,
                         const std::vector<uint32_t>& hour_of_sun) {
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
        const size_t begin = out.suns.size();
        for (uint64_t i = paths.suns_at[list - 1]; i < paths.suns_at[list]; i++)
            keep(hour_of_sun[paths.suns[i].sun], paths.suns[i].rgb, per_sr, out.suns);
        std::stable_sort(out.suns.begin() + long(begin), out.suns.end(),
                         [](const Factor& a, const Factor& b) { return a.of < b.of; });
        out.suns_at.push_back(out.suns.size());
    }
    if ((par.flags & PF_GATHERS) != 0 && par.reuse_path_count != 0)
        out.gathered =
            std::make_unique<const PathFactors>(draw_factors(device, params_of_gather(par, paths), 1, hour_of_sun));
    out.shares.reserve(paths.shares.size());
    for (const device::SuffixShare& s : paths.shares) out.shares.push_back(pack(s.suffix, s.rgb, 1));
    out.sky = std::move(paths.sky);
    out.shares_at = std::move(paths.shares_at);
    return out;
}

}  // namespace render
