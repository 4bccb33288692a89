// SPDX-License-Identifier: BSD-3-Clause
// Means of a region's pixels, weighted by solid angle and coverage (region_pixels.h).
#include "glare/region_pixels.h"
#include <algorithm>
#include <limits>
#include "base/error.h"
#include "glare/statistics.h"

namespace glare {

RegionPixels::RegionPixels(const std::vector<float>& coverage, const Geometry& g) {
    for (size_t i = 0; i < coverage.size(); ++i) {
        if (!(coverage[i] > 0) || !g.valid(i)) continue;
        members_.push_back({uint32_t(i), coverage[i], coverage[i] * g.omega[i]});
        weight_ += members_.back().weight;
    }
    share_ = weight_ / g.omega_sum;
}

double RegionPixels::tal(const Luminance& lum) const {
    double flux = 0;
    for (const Member& m : members_) flux += m.weight * lum.at(m.pixel);
    return flux / weight_;  // nan without pixels
}

RegionValues RegionPixels::measure(const Luminance& lum) const {
    RegionValues out;
    out.tal = tal(lum);
    out.share = share_;
    out.lowest = std::numeric_limits<double>::infinity();
    out.highest = -out.lowest;
    double sum = 0, count = 0;
    std::vector<float> inside;
    for (const Member& m : members_) {
        const double L = lum.at(m.pixel);
        sum += m.coverage * L, count += m.coverage;
        out.lowest = std::min(out.lowest, L), out.highest = std::max(out.highest, L);
        if (m.coverage >= 0.5f) inside.push_back(float(L));
    }
    out.mean = sum / count;
    out.median = median(inside);
    if (members_.empty()) out.lowest = out.highest = std::numeric_limits<double>::quiet_NaN();
    return out;
}

ContrastPair parse_pair(const std::string& text) {
    const size_t equals = text.find('=');
    const std::string pair = equals == std::string::npos ? text : text.substr(equals + 1);
    const size_t slash = pair.find('/');
    if (slash == std::string::npos || slash == 0 || slash + 1 == pair.size() || equals == 0)
        base::fail("-cr", "\"" + text + "\" is not a contrast pair; write low/high or name=low/high");
    return {pair.substr(0, slash), pair.substr(slash + 1), equals == std::string::npos ? pair : text.substr(0, equals)};
}

void require_regions(const ContrastPair& pair, const std::vector<std::string>& regions) {
    for (const std::string& name : {pair.low, pair.high})
        if (std::find(regions.begin(), regions.end(), name) == regions.end())
            base::fail("-cr",
                       "there is no region \"" + name + "\"" + (regions.empty() ? "; name a file with -regions" : ""));
}

}  // namespace glare
