// SPDX-License-Identifier: BSD-3-Clause
// See merge_parts.h.
#include "film/merge_parts.h"

#include <algorithm>
#include <numeric>

#include "base/error.h"
#include "image/grey.h"

namespace film {
namespace {

// The diffuse frames of a picture.
image::SeedRanges diffuse_ranges(const image::Header& h) {
    image::SeedRanges out{{h.seed, h.ranges}};
    out.insert(out.end(), h.other_seeds.begin(), h.other_seeds.end());
    for (auto& [seed, ranges] : out) {
        for (auto& r : ranges) r.first = std::max<int64_t>(r.first, 1);
        ranges.erase(std::remove_if(ranges.begin(), ranges.end(), [](const auto& r) { return r.second < r.first; }),
                     ranges.end());
    }
    return out;
}

}  // namespace

void PartsMerger::add(const image::Picture& picture, size_t seed, const std::string& name) {
    const image::Header& h = picture.header;
    if (*h.frames == 0) return;
    if (picture.parts.empty()) without_ = name;
    if (picture.parts.empty() && picture.sum.empty()) coarse_ = name;
    if (!coarse_.empty()) return parts_.clear(), lacking_.clear();
    const bool lacks = image::lacks_frame0(h);
    for (const image::Part& part : picture.parts) insert(image::Part(part), seed, lacks);
    if (picture.parts.empty()) insert({*h.frames, image::grey_of(picture.rgb), diffuse_ranges(h)}, seed, lacks);
}

void PartsMerger::insert(image::Part&& part, size_t seed, bool lacks) {
    const int64_t frames = part.frames;
    const size_t at = image::add_part(parts_, std::move(part), most());
    lacking_.resize(parts_.size());
    if (!lacks) return;
    lacking_[at].resize(std::max(lacking_[at].size(), seed + 1));
    lacking_[at][seed] += frames;
}

void PartsMerger::result(const std::vector<const std::vector<float>*>& frame0, image::Picture& merged) const {
    merged.parts.clear();
    if (!most_ && !without_.empty()) return;
    if (!coarse_.empty())
        return base::warn(coarse_, "holds neither batches nor an exact sum that could be one: the result has none");
    std::vector<size_t> order(parts_.size());
    std::iota(order.begin(), order.end(), size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return parts_[a].from < parts_[b].from; });
    for (const size_t k : order) {
        image::Part part = parts_[k];
        for (size_t seed = 0; seed < lacking_[k].size(); ++seed) {
            if (lacking_[k][seed] == 0 || frame0[seed]->empty()) continue;
            const float share = float(double(lacking_[k][seed]) / double(part.frames));
            const std::vector<float> zero = image::grey_of(*frame0[seed]);
            for (size_t i = 0; i < zero.size(); ++i) part.grey[i] += share * zero[i];
        }
        merged.parts.push_back(std::move(part));
    }
}

}  // namespace film
