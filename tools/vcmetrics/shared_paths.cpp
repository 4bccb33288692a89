// SPDX-License-Identifier: BSD-3-Clause
// See shared_paths.h.
#include "shared_paths.h"

#include "base/hash.h"
#include "image/header.h"

bool prints_halves(const Options& o, const image::Header& h) {
    return o.halves || !h.shared_paths.empty() || ((o.last || o.each) && !h.sky_name.empty());
}

std::string paths_of(const image::Header& h) {
    constexpr size_t digits = 8;  // rows of a table are many, the runs in it few
    if (h.shared_paths.empty() || h.shared_paths == image::no_shared_paths) return h.shared_paths;
    base::Hash hash;
    hash.add_all(h.shared_paths);
    hash.add({h.seed.value_or(0), uint64_t(h.frames.value_or(0))});
    hash.add_all(image::to_text(h.ranges));
    for (const auto& [seed, ranges] : h.other_seeds) hash.add({seed}), hash.add_all(image::to_text(ranges));
    return hash.text().substr(0, digits);
}

std::string hour_of(const image::Header& h) {
    if (h.hour && h.hour->second == 0) return "-";
    return h.hour ? std::to_string(h.hour->first) + "/" + std::to_string(h.hour->second) : "";
}
