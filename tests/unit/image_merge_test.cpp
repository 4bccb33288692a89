// SPDX-License-Identifier: BSD-3-Clause
// Merging of sums: ranges in any split give the whole, and keep their batches.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <random>

#include "base/warnings.h"
#include "image/accumulate.h"
#include "image/stream.h"
#include "image_sums.h"
#include "temp_folder.h"

using image::Accumulator;
using image::Merger;
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
          "p0: its pixels are not those of its exact sums: another program has changed it");
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
// As ptaccum -batches: a mean after every `step` frames.
Picture with_batches(int64_t first, int64_t last, int64_t step, uint64_t seed = 1) {
    Picture p = sum_of(first, last, seed);
    for (int64_t k = first; k <= last; ++k) {
        const Picture part = sum_of(first, k, seed);
        if (*part.header.frames % step == 0) image::add_mean(p.means, *part.header.frames, part.rgb, image::most_means);
    }
    return p;
}
double worst(const image::GreyMean& mean, const Picture& sum) {
    std::vector<image::GreyMean> exact;
    image::add_mean(exact, *sum.header.frames, sum.rgb, 1);
    double w = 0;
    for (size_t i = 0; i < mean.grey.size(); ++i)
        w = std::max(w, double(std::fabs(mean.grey[i] - exact[0].grey[i])) / std::max(1.f, exact[0].grey[i]));
    return w;
}
}  // namespace

TEST_CASE("beyond the most, means are forgotten between the batches that hold the fewest frames") {
    std::vector<image::GreyMean> means;
    for (int64_t n : {1, 2, 3, 5, 8, 13}) image::add_mean(means, n, sum_of(0, n).rgb, 4);
    std::vector<int64_t> frames;
    for (const image::GreyMean& m : means) frames.push_back(m.frames);
    CHECK(frames == std::vector<int64_t>{3, 5, 8, 13});
    for (const image::GreyMean& m : means) CHECK(worst(m, sum_of(0, m.frames)) == 0);
}

TEST_CASE("parts keep their batches when they are merged, in any order") {
    for (const bool turned : {false, true}) {
        std::vector<Picture> parts{with_batches(0, 16, 4), with_batches(17, 24, 4), sum_of(25, 30)};
        if (turned) std::reverse(parts.begin(), parts.end());
        Merger all(8);
        for (const Picture& p : parts) all.add(p, "part");
        const Picture p = all.result();
        std::vector<int64_t> frames;
        for (const image::GreyMean& m : p.means) {
            frames.push_back(m.frames);
            CHECK(worst(m, sum_of(0, m.frames)) < 3e-7);  // three roundings to float
        }
        CHECK(frames == std::vector<int64_t>{4, 8, 12, 16, 20, 24, 30});
    }
    CHECK(merged({with_batches(0, 16, 4), sum_of(17, 30)}).means.empty());  // not asked for, and one has none
    CHECK(merged({with_batches(0, 16, 4), with_batches(17, 32, 4)}).means.size() == 8);
}

TEST_CASE("batches of several seeds, each with its own frame 0") {
    const Picture p = merged({with_batches(0, 20, 5, 3), with_batches(0, 24, 6, 4)});
    std::vector<int64_t> frames;
    for (const image::GreyMean& m : p.means) frames.push_back(m.frames);
    // frames 1 to 8 of the second seed share its frame 0: no batch ends among them
    CHECK(frames == std::vector<int64_t>{5, 10, 15, 20, 32, 38, 44});
    CHECK(worst(p.means[2], sum_of(0, 15, 3)) < 3e-7);
    CHECK(worst(p.means[4], merged({sum_of(0, 20, 3), sum_of(0, 12, 4)})) < 3e-7);
    CHECK(worst(p.means.back(), p) < 3e-7);
}

TEST_CASE("a sum that is rounded to bytes is no batch") {
    Picture coarse = sum_of(17, 30);
    coarse.sum.clear();
    Merger all(16);
    all.add(with_batches(0, 16, 4), "fine.exr");
    all.add(coarse, "coarse.hdr");
    base::take_warnings();
    CHECK(all.result().means.empty());
    const auto told = base::take_warnings();
    REQUIRE(told.size() == 1);
    CHECK(told[0].first.find("no batches are kept") != std::string::npos);
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
    CHECK(merge_error({frame(3)}) == "p0: is a single frame: merging needs sums of frames");
}
