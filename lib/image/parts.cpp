// SPDX-License-Identifier: BSD-3-Clause
// See parts.h.
#include "image/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "base/wide.h"
#include "image/header.h"

namespace image {
namespace {

WIDE_LOOP void average(const float* b, float weight, size_t n, float* a) {
    for (size_t i = 0; i < n; ++i) a[i] += weight * (b[i] - a[i]);
}

// Mean of frames a+1 .. b: L'(b) + a/(b - a) (L'(b) - L'(a)), where the difference of close floats is exact.
WIDE_LOOP void range_mean(const float* before, const float* after, float factor, size_t n, float* out) {
    for (size_t i = 0; i < n; ++i) out[i] = after[i] + factor * (after[i] - before[i]);
}

void add_ranges(SeedRanges& to, const SeedRanges& more) {
    for (const auto& [seed, ranges] : more) {
        auto same = std::find_if(to.begin(), to.end(), [s = seed](const auto& have) { return have.first == s; });
        if (same == to.end()) same = to.insert(to.end(), {seed, {}});
        same->second.insert(same->second.end(), ranges.begin(), ranges.end());
    }
}

}  // namespace

int64_t frames_of(const std::vector<Part>& parts) {
    int64_t n = 0;
    for (const Part& p : parts) n += p.frames;
    return n;
}

size_t add_part(std::vector<Part>& parts, Part&& range, size_t most) {
    if (parts.size() < most) {
        parts.push_back(std::move(range));
        return parts.size() - 1;
    }
    int64_t fewest = parts[0].frames;
    for (const Part& p : parts) fewest = std::min(fewest, p.frames);
    const auto place = [&](size_t k) { return k ^ (size_t(fewest) % most_parts); };
    size_t at = parts.size();
    for (size_t k = 0; k < parts.size(); ++k)
        if (parts[k].frames == fewest && (at == parts.size() || place(k) < place(at))) at = k;
    Part& to = parts[at];
    to.frames += range.frames;
    average(range.grey.data(), float(double(range.frames) / double(to.frames)), to.grey.size(), to.grey.data());
    if (to.from.empty() || range.from.empty()) to.from.clear();
    else add_ranges(to.from, range.from);
    return at;
}

void GrowingParts::restart() {
    parts_.clear(), mean_.clear();
    frames_ = 0;
}

void GrowingParts::resume(std::vector<Part> parts, std::vector<float> mean, int64_t n) {
    parts_ = std::move(parts), mean_ = std::move(mean);
    frames_ = n;
}

void GrowingParts::add(const float* mean, size_t pixels, int64_t n, std::optional<uint64_t> seed, int64_t first) {
    if (n <= frames_) return;
    Part range{n - frames_, std::vector<float>(mean, mean + pixels), {{seed, {{first + frames_, first + n - 1}}}}};
    if (frames_ > 0) {
        const float factor = float(double(frames_) / double(range.frames));
        range_mean(mean_.data(), mean, factor, pixels, range.grey.data());
    }
    add_part(parts_, std::move(range), most_);
    mean_.assign(mean, mean + pixels);
    frames_ = n;
}

std::string to_text(const SeedRanges& from) {
    std::string out;
    for (const auto& [seed, ranges] : from) {
        if (seed) out += fmt::format("SEED={}\n", *seed);
        for (const auto& r : ranges) out += fmt::format("RANGE={}:{}\n", r.first, r.second);
    }
    return out;
}

SeedRanges seed_ranges(const std::string& text, const std::string& where) {
    Header h;
    Encoding unused;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) parse_header_line(line, h, unused, where);
    SeedRanges out;
    if (!h.ranges.empty()) out.push_back({h.seed, h.ranges});
    for (const auto& [seed, ranges] : h.other_seeds) out.push_back({seed, ranges});
    return out;
}

}  // namespace image
