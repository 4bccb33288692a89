// SPDX-License-Identifier: BSD-3-Clause
// compare REFERENCE.hdr REFERENCE.blocks.tsv WHOLE PART1 PART2 ...: how far is a picture from the reference?  "-" for
// the first: the table alone is the reference, of a scene without a sun in view. Mean luminances over 16 x 16 pixels
// are compared in units of the combined standard error: the reference's from its table, ours from the scatter of the
// parts (batches of frames; the first holds frame 0 and takes no part in the scatter). Pixels at the sun's disc (above
// 1e6 cd/m2 in either picture, and two around) are left out: in a block test they would be the only thing seen.  Prints
// one line: blocks, share within 3 errors, rms of the deviation in errors, signed difference of the picture's mean in
// per cent, its standard error in per cent.
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/run.h"
#include "image/stream.h"

namespace {

constexpr int block = 16;
using Place = std::pair<int, int>;  // column, row from the top

std::vector<double> luminances(const image::Picture& p) {
    std::vector<double> lum(size_t(p.width) * p.height);
    for (size_t i = 0; i < lum.size(); ++i)
        lum[i] = 179 * (0.265074126 * p.rgb[3 * i] + 0.670114631 * p.rgb[3 * i + 1] + 0.064811243 * p.rgb[3 * i + 2]);
    return lum;
}

// 1 where a pixel counts.
std::vector<char> away_from_sun(const std::vector<double>& a, const std::vector<double>& b, int nx, int ny) {
    std::vector<char> counts(a.size(), 1);
    for (int y = 0; y < ny; ++y)
        for (int x = 0; x < nx; ++x) {
            const size_t i = size_t(y) * nx + x;
            if (a[i] < 1e6 && b[i] < 1e6) continue;
            for (int v = std::max(0, y - 2); v <= std::min(ny - 1, y + 2); ++v)
                for (int u = std::max(0, x - 2); u <= std::min(nx - 1, x + 2); ++u) counts[size_t(v) * nx + u] = 0;
        }
    return counts;
}

double mean_of(const std::vector<double>& lum, const std::vector<char>& counts, int nx, int x0, int x1, int y0,
               int y1) {
    double sum = 0, n = 0;
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x)
            if (counts[size_t(y) * nx + x]) sum += lum[size_t(y) * nx + x], n += 1;
    return n ? sum / n : 0;
}

// Standard error of the mean of all parts, from their scatter.
double error_of(const std::vector<double>& parts) {
    double mean = 0, squares = 0;
    for (double v : parts) mean += v / double(parts.size());
    for (double v : parts) squares += (v - mean) * (v - mean);
    return std::sqrt(squares / double(parts.size() - 1) /
                     double(parts.size() + 1));  // + 1: the part that holds frame 0
}

struct Known {
    double mean, error;
};
std::map<Place, Known> read_blocks(const std::string& path) {
    std::ifstream in(path);
    std::string line;
    if (!std::getline(in, line)) base::fail(path, "cannot be read");
    std::map<Place, Known> blocks;
    for (int c, r; std::getline(in, line);) {
        Known k;
        if (!(std::istringstream(line) >> c >> r >> k.mean >> k.error))
            base::fail(path, "\"" + line + "\" is not a block");
        blocks[{c, r}] = k;
    }
    return blocks;
}

// A picture of the blocks' means.
std::vector<double> spread(const std::map<Place, Known>& blocks, int nx, int ny) {
    std::vector<double> lum(size_t(nx) * ny);
    for (int y = 0; y < ny; ++y)
        for (int x = 0; x < nx; ++x)
            if (const auto b = blocks.find({x / block, y / block}); b != blocks.end())
                lum[size_t(y) * nx + x] = b->second.mean;
    return lum;
}

int compare(const std::vector<std::string>& words) {
    if (words.size() < 6)
        base::fail("", "usage: compare reference.hdr reference.blocks.tsv whole part1 part2 part3 ...");
    const image::Picture whole = image::read_file(words[2]);
    const int nx = whole.width, ny = whole.height;
    const std::map<Place, Known> blocks = read_blocks(words[1]);
    const std::vector<double> theirs =
        words[0] == "-" ? spread(blocks, nx, ny) : luminances(image::read_file(words[0]));
    const std::vector<double> ours = luminances(whole);
    if (theirs.size() != ours.size()) base::fail(words[2], "is not of the reference's size");
    const std::vector<char> counts = away_from_sun(theirs, ours, nx, ny);
    std::vector<std::vector<double>> parts;
    for (size_t i = 4; i < words.size(); ++i) parts.push_back(luminances(image::read_file(words[i])));

    int n = 0, within = 0;
    double squares = 0;
    for (const auto& [place, known] : blocks) {
        const int x = place.first * block, y = place.second * block;
        std::vector<double> means;
        for (const auto& part : parts) means.push_back(mean_of(part, counts, nx, x, x + block, y, y + block));
        const double a = mean_of(theirs, counts, nx, x, x + block, y, y + block);
        const double b = mean_of(ours, counts, nx, x, x + block, y, y + block);
        const double error = std::hypot(known.error, error_of(means));
        const double deviation = error > 0 ? (b - a) / error : 0;
        ++n;
        within += std::fabs(deviation) <= 3;
        squares += deviation * deviation;
        if (std::fabs(deviation) > 3)
            std::fprintf(stderr, "block %d %d: %.4g, reference %.4g, %+.1f errors\n", place.first, place.second, b, a,
                         deviation);
    }
    std::vector<double> means;
    for (const auto& part : parts) means.push_back(mean_of(part, counts, nx, 0, nx, 0, ny));
    const double a = mean_of(theirs, counts, nx, 0, nx, 0, ny), b = mean_of(ours, counts, nx, 0, nx, 0, ny);
    std::printf("%d\t%.4f\t%.2f\t%+.3f\t%.3f\n", n, double(within) / n, std::sqrt(squares / n), 100 * (b / a - 1),
                100 * error_of(means) / a);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    return base::run("compare", [&] { return compare({argv + 1, argv + argc}); });
}
