// SPDX-License-Identifier: BSD-3-Clause
// picture_means BLOCK PICTURE ... -- PICTURE ...: do two ways to render have the same expectation?  Each way gives
// pictures of independent seeds.  Prints, tab separated: the difference of the two mean pictures' means over the first
// and its standard error, both in percent; the rms and the largest of the differences of BLOCK x BLOCK pixels, each
// over its own standard error; how many blocks there are.  Standard errors are those that the seeds show, so the
// differences of n seeds have Student's distribution of 2 n - 2 degrees: of 64 blocks one above 3 is no rare thing.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "base/error.h"
#include "base/run.h"
#include "image/stream.h"

namespace {

struct Estimate {
    double mean, error;
};

// Sums of luminance over the blocks of a picture, the sum of all last.
std::vector<double> block_sums(const image::Picture& p, int block) {
    const int across = p.width / block, down = p.height / block;
    std::vector<double> sums(size_t(across * down) + 1);
    for (int y = 0; y < p.height; y++)
        for (int x = 0; x < p.width; x++) {
            const float* rgb = &p.rgb[3 * (size_t(y) * size_t(p.width) + size_t(x))];
            const double lum = 0.265074126 * rgb[0] + 0.670114631 * rgb[1] + 0.064811243 * rgb[2];
            sums.back() += lum;
            if (x / block < across && y / block < down) sums[size_t(y / block * across + x / block)] += lum;
        }
    return sums;
}

Estimate estimate(const std::vector<std::vector<double>>& pictures, size_t at) {
    const double n = double(pictures.size());
    double mean = 0, squares = 0;
    for (const auto& sums : pictures) mean += sums.at(at) / n;
    for (const auto& sums : pictures) squares += (sums[at] - mean) * (sums[at] - mean);
    return {mean, std::sqrt(squares / (n - 1) / n)};
}

void compare(const std::vector<std::vector<double>>& one, const std::vector<std::vector<double>>& other) {
    const size_t all = one[0].size() - 1;
    double squares = 0, largest = 0;
    int count = 0;
    for (size_t at = 0; at <= all; at++) {
        const Estimate a = estimate(one, at), b = estimate(other, at);
        const double error = std::hypot(a.error, b.error);
        if (at == all) std::printf("%+.3f\t%.3f", 100 * (b.mean / a.mean - 1), 100 * error / a.mean);
        else if (error > 0) {  // outside a fisheye's circle all is black
            const double z = (b.mean - a.mean) / error;
            squares += z * z;
            largest = std::max(largest, std::fabs(z));
            count++;
        }
    }
    std::printf("\t%.2f\t%.2f\t%d\n", count ? std::sqrt(squares / count) : 0, largest, count);
}

}  // namespace

int main(int argc, char** argv) {
    return base::run("picture_means", [&] {
        std::vector<std::vector<double>> ways[2];
        int way = 0;
        const int block = argc > 1 ? std::atoi(argv[1]) : 0;
        for (int i = 2; i < argc; i++) {
            if (std::strcmp(argv[i], "--") == 0) way = 1;
            else ways[way].push_back(block_sums(image::read_file(argv[i]), block));
            if (!ways[way].empty() && ways[way].back().size() != ways[0][0].size())
                base::fail(argv[i], "is of another size");
        }
        if (block < 1 || ways[0].size() < 2 || ways[1].size() < 2)
            base::fail("", "usage: picture_means block picture picture ... -- picture picture ...");
        compare(ways[0], ways[1]);
        return 0;
    });
}
