// SPDX-License-Identifier: BSD-3-Clause
// picture_error REFERENCE PICTURES: how far are noisy pictures from a converged one?  For each picture of a file, or of
// standard input (-), it prints four numbers, tab separated: the median of the pixels' relative errors; the rms error
// of the 98 % of pixels that are nearest, and of all, over the mean; the rms of the relative errors of 8 x 8 blocks.
// The brightest 0.5 % of the reference's pixels (the sun's disc, lamps) are left out, and so are black ones.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <vector>

#include "base/error.h"
#include "base/run.h"
#include "image/stream.h"

namespace {

constexpr int block = 8;

std::vector<double> luminances(const image::Picture& p) {
    std::vector<double> lum(size_t(p.width) * size_t(p.height));
    for (size_t i = 0; i < lum.size(); i++)
        lum[i] = 0.265074126 * p.rgb[3 * i] + 0.670114631 * p.rgb[3 * i + 1] + 0.064811243 * p.rgb[3 * i + 2];
    return lum;
}

double root_mean(const std::vector<double>& squares, size_t count) {
    return std::sqrt(std::accumulate(squares.begin(), squares.begin() + long(count), 0.0) / double(count));
}

// Relative errors, squared, of the blocks of which all pixels count.
std::vector<double> block_errors(const std::vector<double>& truth, const std::vector<double>& lum,
                                 const std::vector<char>& counts, int nx, int ny) {
    std::vector<double> squares;
    for (int y = 0; y + block <= ny; y += block)
        for (int x = 0; x + block <= nx; x += block) {
            double sum = 0, difference = 0;
            bool whole = true;
            for (int i = 0; i < block * block; i++) {
                const size_t at = size_t(y + i / block) * size_t(nx) + size_t(x + i % block);
                whole = whole && counts[at];
                sum += truth[at];
                difference += lum[at] - truth[at];
            }
            if (whole) squares.push_back(difference / sum * difference / sum);
        }
    return squares;
}

void print_errors(const image::Picture& reference, const image::Picture& picture) {
    const std::vector<double> truth = luminances(reference), lum = luminances(picture);
    std::vector<double> sorted = truth;
    std::sort(sorted.begin(), sorted.end());
    const double brightest = sorted[size_t(0.995 * double(sorted.size() - 1))];

    std::vector<char> counts;
    std::vector<double> relative, squares;
    double sum = 0;
    for (size_t i = 0; i < truth.size(); i++) {
        counts.push_back(truth[i] > 0 && truth[i] <= brightest);
        if (!counts.back()) continue;
        relative.push_back(std::fabs(lum[i] - truth[i]) / truth[i]);
        squares.push_back((lum[i] - truth[i]) * (lum[i] - truth[i]));
        sum += truth[i];
    }
    if (relative.empty()) base::fail("", "the reference is black");

    const double mean = sum / double(relative.size());
    std::sort(relative.begin(), relative.end());
    std::sort(squares.begin(), squares.end());
    const std::vector<double> blocks = block_errors(truth, lum, counts, reference.width, reference.height);
    std::printf("%.4f\t%.4f\t%.4f\t%.4f\n", relative[relative.size() / 2],
                root_mean(squares, size_t(0.98 * double(squares.size()))) / mean,
                root_mean(squares, squares.size()) / mean, blocks.empty() ? 0 : root_mean(blocks, blocks.size()));
}

}  // namespace

int main(int argc, char** argv) {
    return base::run("picture_error", [&] {
        if (argc != 3) base::fail("", "usage: picture_error reference pictures");
        const image::Picture reference = image::read_file(argv[1]);
        image::StreamReader pictures(argv[2]);
        image::Picture picture;
        while (pictures.next(picture)) {
            if (reference.width != picture.width || reference.height != picture.height)
                base::fail(argv[2], "is not of the reference's size");
            print_errors(reference, picture);
        }
        return 0;
    });
}
