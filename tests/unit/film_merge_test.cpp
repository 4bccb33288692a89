// SPDX-License-Identifier: BSD-3-Clause
// Merging of sums: ranges in any split give the whole, and keep their parts.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <random>

#include "base/warnings.h"
#include "film/accumulate.h"
#include "image/grey.h"
#include "image/stream.h"
#include "image_pictures.h"
#include "film_sums.h"
#include "temp_folder.h"

using film::Accumulator;
using film::Merger;
using image::Picture;

TEST_CASE("ranges merge to the whole, in any order and any split") {
    const Picture whole = sum_of(0, 63);
    const std::vector<std::vector<Picture>> splits{{sum_of(0, 9), sum_of(10, 40), sum_of(41, 63)},
                                                   {sum_of(41, 63), sum_of(10, 40), sum_of(0, 9)},
                                                   {sum_of(0, 0), sum_of(1, 63)},
                                                   {sum_of(1, 30), sum_of(0, 0), sum_of(31, 63)}};
    for (const auto& parts : splits) {
        const Picture p = merged(parts);
        CHECK(worst(p, whole) < 2e-7);  // float rounding: 2^-23
        CHECK(p.header.frames == 63);
        CHECK(p.header.ranges == image::Ranges{{0, 63}});
        CHECK(p.frame0 == whole.frame0);
    }
    // Partial results may merge first; a hole stays visible.
    const Picture later = merged({sum_of(41, 63), sum_of(10, 39)});
    CHECK(later.header.ranges == image::Ranges{{10, 39}, {41, 63}});
    CHECK(later.header.frames == 53);
    const Picture all = merged({later, sum_of(40, 40), sum_of(0, 9)});
    CHECK(worst(all, whole) < 4e-7);
}

TEST_CASE("moments are copied within a seed, weighted by frames over seeds, and lost where one has none") {
    const auto with = [](Picture p, float first) {
        p.moments = moments_of(p, first);
        return p;
    };
    const Picture zero = with(sum_of(0, 9), 1), later = sum_of(10, 29), other = with(sum_of(0, 9, 2), 11);
    CHECK(*merged({later, zero}).moments == *zero.moments);
    CHECK(!merged({later, sum_of(0, 9)}).moments);
    const Picture both = merged({zero, later, other});  // 29 and 9 frames
    REQUIRE(both.moments);
    CHECK((*both.moments)[0] == doctest::Approx((29 * 1 + 9 * 11) / 38.));
    CHECK((*both.moments)[5] == (*zero.moments)[5]);
    CHECK(!merged({zero, sum_of(0, 9, 2)}).moments);
}

// Bit for bit, as pictures that were written to OpenEXR and read back.
TEST_CASE("parts merge to the bits of one run, in any order and any grouping") {
    TempFolder folder;
    const std::string file = folder.name("p.exr");
    const auto through_file = [&](const Picture& p) {
        image::write_file(file, p);
        return image::read_file(file);
    };
    const auto same = [](const Picture& a, const Picture& b) {
        if (a.sum.size() != b.sum.size()) return false;
        for (size_t k = 0; k < a.sum.size(); ++k)
            if (a.sum[k].digit != b.sum[k].digit || a.sum[k].words != b.sum[k].words) return false;
        return a.rgb == b.rgb && a.frame0 == b.frame0;
    };
    const Picture whole = sum_of(0, 99);
    CHECK(!whole.sum.empty());
    CHECK(same(through_file(whole), whole));

    std::mt19937 dice(5);
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<Picture> parts;
        for (int64_t first = 0; first < 100;) {
            const int64_t last = std::min<int64_t>(99, first + int64_t(dice() % 30));
            parts.push_back(sum_of(first, last));
            first = last + 1;
        }
        while (parts.size() > 1) {  // any few of them at a time
            std::shuffle(parts.begin(), parts.end(), dice);
            const size_t together = 2 + dice() % (parts.size() - 1);
            const std::vector<Picture> some(parts.begin(), parts.begin() + std::ptrdiff_t(together));
            parts.erase(parts.begin(), parts.begin() + std::ptrdiff_t(together));
            const Picture one = merged(some);
            parts.push_back(trial % 20 == 0 ? through_file(one) : one);
        }
        REQUIRE(same(parts[0], whole));
    }

    Accumulator goes_on;
    goes_on.resume(through_file(sum_of(0, 41)), "x");
    for (int64_t k = 42; k < 100; ++k) goes_on.add(frame(k), "x");
    Picture later;
    goes_on.result(later, true);
    CHECK(same(later, whole));
}

TEST_CASE("exact sums that do not belong to the pixels are refused") {
    Picture changed = sum_of(0, 9);
    changed.rgb[7] *= 2;
    CHECK(merge_error({changed, sum_of(10, 19)}) ==
          "p0: its pixels differ from its exact sums: another program has changed it");
    Picture gap = sum_of(0, 9);
    gap.sum.back().digit++;
    CHECK(merge_error({gap}).find("p0: its layers of exact sums have a gap") == 0);
}

TEST_CASE("complete sums of several seeds average by their frames") {
    const Picture a = sum_of(0, 10, 1), b = sum_of(0, 30, 2);
    const Picture p = merged({a, b});
    for (size_t i = 0; i < 90; ++i)
        CHECK(p.rgb[i] == doctest::Approx((10. * a.rgb[i] + 30. * b.rgb[i]) / 40).epsilon(1e-6));
    CHECK(p.header.frames == 40);
    CHECK(p.header.seed == 1);
    CHECK(p.header.other_seeds.size() == 1);
    const Picture q = merged({p, sum_of(0, 20, 3)});
    CHECK(worst(q, merged({a, b, sum_of(0, 20, 3)})) < 4e-7);
    CHECK(q.header.frames == 60);
}

namespace {
// As ptaccum -batches: a range after every `step` frames.
Picture with_parts(int64_t first, int64_t last, int64_t step, uint64_t seed = 1, size_t most = image::most_parts) {
    Picture p = sum_of(first, last, seed);
    image::GrowingParts parts(most);
    for (int64_t k = first; k <= last; ++k) {
        const Picture sum = sum_of(first, k, seed);
        if (*sum.header.frames % step && k < last) continue;
        const std::vector<float> grey = image::grey_of(sum.rgb);
        parts.add(grey.data(), grey.size(), *sum.header.frames, seed, std::max<int64_t>(first, 1));
    }
    p.parts = parts.parts();
    return p;
}

// The mean of L(0) of a seed and of each frame that a part says it has, against its pixels.
double worst(const image::Part& part) {
    std::vector<double> sum(part.grey.size(), 0);
    double n = 0;
    for (const auto& [seed, ranges] : part.from)
        for (const auto& r : ranges)
            for (int64_t k = r.first; k <= r.second; ++k, n += 1)
                for (const std::vector<float>& grey :
                     {image::grey_of(frame(0, *seed).rgb), image::grey_of(frame(k, *seed).rgb)})
                    for (size_t i = 0; i < sum.size(); ++i) sum[i] += grey[i];
    double w = n == double(part.frames) ? 0 : INFINITY;
    for (size_t i = 0; i < sum.size(); ++i)
        w = std::max(w, std::fabs(part.grey[i] - sum[i] / n) / std::max(1., std::fabs(sum[i] / n)));
    return w;
}
}  // namespace

TEST_CASE("a range goes whole to the part of the fewest frames") {
    const Picture p = with_parts(0, 37, 1);
    REQUIRE(p.parts.size() == 16);
    CHECK(image::frames_of(p.parts) == 37);
    for (const image::Part& part : p.parts) {
        CHECK(part.frames >= 2);
        CHECK(part.frames <= 3);
        CHECK(worst(part) < 1e-5);  // of 37 means that are rounded to float
    }
    std::vector<int64_t> frames;
    for (const image::Part& part : with_parts(0, 13, 4, 1, 2).parts) frames.push_back(part.frames);
    CHECK(frames == std::vector<int64_t>{4 + 4, 4 + 1});
}

// Frames k and k + 16 have points with the same four leading digits: a part should not have them alone.
TEST_CASE("four rounds of frames give each part one of each four") {
    for (const image::Part& part : with_parts(0, 64, 1).parts) {
        REQUIRE(part.frames == 4);
        int residues = 0;
        for (const auto& r : part.from[0].second) residues |= 1 << (r.first - 1) % 4;
        CHECK(residues == 15);
    }
}

TEST_CASE("sums keep their parts when they are merged, in any order") {
    for (const bool turned : {false, true}) {
        std::vector<Picture> sums{with_parts(0, 16, 4), with_parts(17, 24, 4), sum_of(25, 30)};
        if (turned) std::reverse(sums.begin(), sums.end());
        Merger all(8);
        for (const Picture& p : sums) all.add(p, "part");
        const Picture p = all.result();
        std::vector<int64_t> frames;
        for (const image::Part& part : p.parts) {
            frames.push_back(part.frames);
            CHECK(worst(part) < 1e-6);
        }
        CHECK(frames == std::vector<int64_t>{4, 4, 4, 4, 4, 4, 6});
    }
    CHECK(merged({with_parts(0, 16, 4), sum_of(17, 30)}).parts.empty());  // not asked for, and one has none
    CHECK(merged({with_parts(0, 16, 4), with_parts(17, 32, 4)}).parts.size() == 8);
}

TEST_CASE("parts of several seeds, each with its own frame 0") {
    const Picture p =
        merged({with_parts(0, 20, 1, 3), with_parts(0, 24, 6, 4), with_parts(21, 30, 10, 3), with_parts(0, 5, 5, 5)});
    REQUIRE(p.parts.size() == 16);
    CHECK(image::frames_of(p.parts) == 20 + 24 + 10 + 5);
    for (const image::Part& part : p.parts) CHECK(worst(part) < 1e-5);
}

TEST_CASE("a sum that is rounded to bytes is no part") {
    Picture coarse = sum_of(17, 30);
    coarse.sum.clear();
    Merger all(16);
    all.add(with_parts(0, 16, 4), "fine.exr");
    all.add(coarse, "coarse.hdr");
    base::take_warnings();
    CHECK(all.result().parts.empty());
    const auto told = base::take_warnings();
    REQUIRE(told.size() == 1);
    CHECK(told[0].first.find("holds neither batches") != std::string::npos);
}

TEST_CASE("what cannot be weighted rightly is refused") {
    CHECK(merge_error({sum_of(0, 9), sum_of(0, 9)}) == "p1: frame 0 of seed 1 is in p0 already");
    CHECK(merge_error({sum_of(0, 9), sum_of(5, 20)}) == "p1: frame 5 of seed 1 is in p0 already");
    CHECK(merge_error({sum_of(0, 9), sum_of(5, 20, 2)}).find("p1: seed 2: frames 5:20 come without frame 0") == 0);
    CHECK(merge_error({sum_of(0, 9), sum_of(0, 0, 2)}).find("frame 0 by itself cannot be averaged") !=
          std::string::npos);
    Picture no_layer = sum_of(0, 9);
    no_layer.frame0.clear();
    CHECK(merge_error({no_layer}).empty());
    CHECK(merge_error({no_layer, sum_of(10, 20)}).find("has frame 0 summed in") != std::string::npos);
    CHECK(merge_error({sum_of(10, 20), no_layer}).find("has frame 0 summed in") != std::string::npos);
    CHECK(merge_error({no_layer, sum_of(0, 9, 2)}).empty());
    CHECK(merge_error({merged({sum_of(0, 9), sum_of(0, 9, 2)}), sum_of(10, 20, 2)}).find("mixes with other seeds") !=
          std::string::npos);
    CHECK(merge_error({merged({sum_of(0, 9), sum_of(0, 9, 2)}), sum_of(0, 5, 2)})
              .find("frame 0 of seed 2 is in p0 already") != std::string::npos);
    Picture lies = sum_of(0, 9);
    lies.header.frames = 100;
    CHECK(merge_error({lies}) == "p0: FRAMES=100 does not fit RANGE=0:9, which holds 9 diffuse frames");
    Picture turned = sum_of(10, 20);
    turned.header.view = view::View();
    CHECK(merge_error({sum_of(0, 9), turned}) == "p1: has another view than p0");
    Picture action = sum_of(10, 20), bands = action;
    action.header.action = {"mel", 9, "lx"}, bands.header.action = {"mel", 12, "lx"};
    CHECK(merge_error({sum_of(0, 9), action}) ==
          "p1: has action mel of 9 bands in lx, p0 has no action (ACTION=): they "
          "cannot be combined into one picture");
    CHECK(merge_error({action, bands}).find("p1: has action mel of 12 bands in lx, p0 has") == 0);
    CHECK(merged({action}).header.action == action.header.action);
    CHECK(merge_error({frame(3)}) == "p0: is a single frame: merging needs sums of frames");
}
