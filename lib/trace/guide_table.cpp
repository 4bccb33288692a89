// SPDX-License-Identifier: BSD-3-Clause
// A bin's chance is the root of the second moment of the light in it, which makes a sample's variance least (Rath et
// al. 2020, "Variance-Aware Path Guiding").  What few walks have told is noisy, and a bin that is thought to be darker
// than it is makes bright pixels: so cells learn from their neighbours, bins from theirs, and some directions go by the
// cosine.
#include "trace/guide_table.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace kernels {
#include "kernels/instance.h"
#include "kernels/surface.h"
#include "kernels/highlights.h"
#include "kernels/guide.h"
}  // namespace kernels

namespace trace {
namespace {

using namespace kernels;

constexpr double NEIGHBOUR = 0.5;  // weight of what a cell beside this one knows
constexpr double BLUR = 0.25;      // share of a bin that is spread over the square of nine about it
constexpr double EVEN = 0.1;       // share of directions that go by the cosine

using Numbers = std::unordered_map<uint32_t, size_t>;  // of cells, by key

uint32_t key_beside(uint32_t key, int x, int y, int z) {
    return key + uint32_t(x) * (1u << GUIDE_X) + uint32_t(y) * (1u << GUIDE_Y) + uint32_t(z) * (1u << GUIDE_Z);
}

// The second moments of a cell, with those of the cells around it that face the same side.
std::vector<double> smoothed(const std::vector<GuideCell>& cells, const Numbers& number, const GuideCell& cell) {
    std::vector<double> square = cell.square;
    double weight = 1;
    for (int x = -1; x <= 1; x++)
        for (int y = -1; y <= 1; y++)
            for (int z = -1; z <= 1; z++) {
                if (x == 0 && y == 0 && z == 0) continue;
                const auto at = number.find(key_beside(cell.key, x, y, z));
                if (at == number.end() || cells[at->second].side != cell.side) continue;
                weight += NEIGHBOUR;
                const GuideCell& other = cells[at->second];
                for (size_t bin = 0; bin < square.size(); bin++) square[bin] += NEIGHBOUR * other.square[bin];
            }
    for (double& v : square) v /= weight;
    return square;
}

// The mean over the square of nine about bin (x, y), of less at the rim.
double around(const std::vector<double>& of, size_t side, size_t x, size_t y) {
    double sum = 0, count = 0;
    for (size_t j = y ? y - 1 : 0; j <= std::min(y + 1, side - 1); j++)
        for (size_t i = x ? x - 1 : 0; i <= std::min(x + 1, side - 1); i++) {
            sum += of[j * side + i];
            count++;
        }
    return sum / count;
}

std::vector<double> chances(const std::vector<double>& square, size_t side) {
    std::vector<double> root, chance;
    for (const double v : square) root.push_back(std::sqrt(v));
    double sum = 0;
    for (size_t bin = 0; bin < root.size(); bin++) {
        chance.push_back((1 - BLUR) * root[bin] + BLUR * around(root, side, bin % side, bin / side));
        sum += chance.back();
    }
    const double even = 1 / double(root.size());
    for (double& v : chance) v = sum > 0 ? EVEN * even + (1 - EVEN) * v / sum : even;
    return chance;
}

// Where n parts of 0 .. 65536 in proportion to their weights begin, none of them empty; two a word.
void put_beginnings(const double* weight, uint32_t n, uint32_t* words) {
    double sum = 0, before = 0;
    for (uint32_t k = 0; k < n; k++) sum += weight[k];
    uint32_t least = 0;
    for (uint32_t k = 0; k < n; k++) {
        const uint32_t wish = uint32_t(std::lround(before / sum * GUIDE_ONE));
        const uint32_t begin = std::clamp(wish, least, uint32_t(GUIDE_ONE) - (n - k));
        words[k / 2] |= begin << (k % 2 * 16);
        least = begin + 1;
        before += weight[k];
    }
}

void put_record(const GuideCell& cell, const std::vector<double>& chance, std::vector<uint32_t>& words) {
    const size_t at = words.size();
    words.resize(at + GUIDE_CHANCES + GUIDE_WORDS(cell.side));
    words[at + GUIDE_SIDE] = cell.side;
    words[at + GUIDE_LIGHT] = as_uint_(float(cell.light));

    std::vector<double> rows(cell.side, 0.0);
    for (size_t bin = 0; bin < chance.size(); bin++) rows[bin / cell.side] += chance[bin];
    uint32_t* out = &words[at + GUIDE_CHANCES];
    put_beginnings(rows.data(), cell.side, out);
    for (uint32_t row = 0; row < cell.side; row++)
        put_beginnings(&chance[size_t(row) * cell.side], cell.side, out + (cell.side + cell.side * row) / 2);
}

}  // namespace

Guide guide_table(const std::vector<GuideCell>& cells, float4 grid) {
    Guide guide;
    if (cells.empty()) return guide;
    uint32_t entries = 16;
    while (entries < 2 * cells.size()) entries *= 2;
    guide.mask = entries - 1;
    guide.grid = grid;
    guide.words.assign(size_t(entries) * GUIDE_ENTRY, NONE);

    Numbers number;
    for (const GuideCell& cell : cells) number.emplace(cell.key, number.size());
    for (const GuideCell& cell : cells) {
        uint32_t i = hash32(cell.key) & guide.mask;
        while (guide.words[i * GUIDE_ENTRY] != NONE) i = (i + 1) & guide.mask;
        guide.words[i * GUIDE_ENTRY] = cell.key;
        guide.words[i * GUIDE_ENTRY + 1] = uint32_t(guide.words.size());
        put_record(cell, chances(smoothed(cells, number, cell), cell.side), guide.words);
    }
    return guide;
}

}  // namespace trace
