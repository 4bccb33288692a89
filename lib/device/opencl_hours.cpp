// SPDX-License-Identifier: BSD-3-Clause
// See opencl_hours.h.
#include "device/opencl_hours.h"

#include <algorithm>

#include "base/shutdown.h"
#include "device/device.h"
#include "device/hour_shares.h"
#include "device/wavefront.h"

namespace device {
using kernels::float4;
namespace {

constexpr uint64_t most_bytes = uint64_t(1) << 27;  // of responses, 24 for each path and sun

void find_suns(OpenclPaths& paths, uint32_t suns, FoundSuns& found) {
    std::vector<uint32_t> queue;
    std::vector<float> rows;
    paths.suns(suns, queue, rows);
    for (size_t i = 0; i < queue.size(); i++)
        for (uint32_t sun = 0; sun < suns; sun++) {
            const float* rgb = &rows[6 * (i * suns + sun)];
            found.add(2 * queue[i], sun, rgb, 1);
            found.add(2 * queue[i] + 1, sun, rgb + 3, 1);
        }
}

// Suffix vertices meet the prefix vertices of their groups.
void light_suffixes(OpenclPaths& paths, const kernels::Params& part, std::vector<float4>& rad, HourPaths& out) {
    constexpr size_t square = REUSE_SQUARE * REUSE_GROUP;
    std::vector<float4> suffix_rad(rad.size()), found, of_square;
    meet_suffixes(paths, part.reuse_rounds, [&] { paths.suffix_shares(found); });
    paths.read(PATH_suffix_rad, suffix_rad);
    for (size_t first = 0; first < rad.size(); first += REUSE_SQUARE) {
        of_square.clear();
        for (uint32_t round = 0; round < part.reuse_rounds; round++) {
            const auto at = found.begin() + long((round * rad.size() + first) * REUSE_GROUP);
            of_square.insert(of_square.end(), at, at + square);
        }
        weigh_shares(part.reuse_rounds, of_square.data(), &suffix_rad[first], &rad[first], out);
    }
}

// rest: by path.
void run_part(OpenclPaths& paths, const kernels::Params& part, HourPaths& out) {
    FoundSuns found;
    paths.reserve(part);
    paths.generate();
    while (paths.has_paths()) {
        if (base::shutdown_requested()) throw Cancelled{};
        paths.extend();
        find_suns(paths, part.suns_count, found);
        paths.shade();
        paths.shadow();
        paths.next_bounce();
    }
    found.sort(2 * part.path_count, out);
    std::vector<float4> rad(part.path_count), way(rad.size()), share(rad.size()), org(rad.size());
    paths.read(PATH_rad, rad);
    if (part.reuse_path_count != 0) light_suffixes(paths, part, rad, out);
    paths.read(PATH_sky_way, way);
    paths.read(PATH_sky_share, share);
    paths.read(PATH_org, org);
    for (size_t i = 0; i < rad.size(); i++) {
        const kernels::Row_sky_way w = kernels::sky_way_of(way[i]);
        out.rest.insert(out.rest.end(), {rad[i].x, rad[i].y, rad[i].z});
        out.sky.push_back({{w.dir.x, w.dir.y, w.dir.z}, {0, 0, 0}, w.kind});
        out.end.insert(out.end.end(), {org[i].x, org[i].y, org[i].z});
        if (w.kind != SKY_NONE) std::copy_n(&share[i].x, 3, out.sky.back().rgb);
    }
}

}  // namespace

void opencl_hours(OpenclPaths& paths, const kernels::Params& par, uint32_t most_paths, HourPaths& out) {
    out = {};
    const bool reuse = par.reuse_path_count != 0;
    std::vector<float> film(reuse ? 3 * size_t(kernels::film_places(&par)) : 0);
    const uint64_t fit = most_bytes / (24 * std::max(1u, par.suns_count));
    const uint32_t most =
        std::max(REUSE_SQUARE, uint32_t(std::min<uint64_t>(most_paths, fit)) / REUSE_SQUARE * REUSE_SQUARE);
    kernels::Params part = par;
    for (uint32_t done = 0; done < par.path_count; done += part.path_count) {
        part.first = par.first + done;
        part.path_count = std::min(most, par.path_count - done);
        HourPaths some;
        run_part(paths, part, some);
        if (!reuse) out.rest.insert(out.rest.end(), some.rest.begin(), some.rest.end());
        for (uint32_t i = 0; reuse && i < part.path_count; i++) {
            const uint32_t place = kernels::film_place(&part, i);
            if (place != NONE) std::copy_n(&some.rest[3 * size_t(i)], 3, &film[3 * size_t(place)]);
        }
        out.append(std::move(some));
    }
    if (reuse) out.rest = std::move(film);
}

}  // namespace device
