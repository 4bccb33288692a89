// SPDX-License-Identifier: BSD-3-Clause
// Marching squares (Lorensen & Cline 1987 in two dimensions), see outline.h.  A cell is the square between four centres
// of pixels.  Each of its sides that the outline crosses is the end of one piece of line and the beginning of another,
// the area being on the same side of both; so pieces are chained by the sides they begin at.
#include "display/outline.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>

namespace display {
namespace {

constexpr float level = .5f;

class Squares {
public:
    Squares(const std::vector<float>& coverage, int width, int height)
        : coverage_(coverage),
          width_(width),
          height_(height),
          next_(2 * size_t(width + 1) * size_t(height + 1), nowhere) {}

    std::vector<Ring> rings() {
        for (int y = -1; y < height_; ++y)
            for (int x = -1; x < width_; ++x) add_cell(x, y);
        std::vector<Ring> all;
        for (size_t side = 0; side < next_.size(); ++side)
            if (next_[side] != nowhere) all.push_back(ring_from(side));
        return all;
    }

private:
    static constexpr size_t nowhere = size_t(-1);

    float value(int x, int y) const {
        const bool outside = x < 0 || y < 0 || x >= width_ || y >= height_;
        return outside ? 0 : coverage_[size_t(y) * size_t(width_) + size_t(x)];
    }
    // The side from the centre of pixel (x, y) to its neighbour on the right (0) or below (1).
    size_t side(int x, int y, int below) const {
        return 2 * (size_t(y + 1) * size_t(width_ + 1) + size_t(x + 1)) + size_t(below);
    }

    // The corners clockwise from the upper left one.  A piece begins on a side whose first corner is in and whose
    // second is out, and ends on the next side the other way round.
    void add_cell(int x, int y) {
        const float v[4] = {value(x, y), value(x + 1, y), value(x + 1, y + 1), value(x, y + 1)};
        const size_t sides[4] = {side(x, y, 0), side(x + 1, y, 1), side(x, y + 1, 0), side(x, y, 1)};
        const bool in[4] = {v[0] >= level, v[1] >= level, v[2] >= level, v[3] >= level};
        const bool joined = v[0] + v[1] + v[2] + v[3] >= 4 * level;  // two opposite corners by the middle
        for (int k = 0; k < 4; ++k) {
            if (!in[k] || in[(k + 1) % 4]) continue;
            const bool two = in[(k + 2) % 4] && !in[(k + 3) % 4];
            int end = two ? (joined ? k + 1 : k + 3) : k + 1;
            while (!two && !(!in[end % 4] && in[(end + 1) % 4])) ++end;
            next_[sides[k]] = sides[end % 4];
        }
    }

    std::array<float, 2> crossing(size_t s) const {
        const int x = int(s / 2 % size_t(width_ + 1)) - 1, y = int(s / 2 / size_t(width_ + 1)) - 1;
        const int below = int(s % 2);
        const float a = value(x, y), b = value(x + !below, y + below), t = (level - a) / (b - a);
        return {float(x) + .5f + (below ? 0 : t), float(y) + .5f + (below ? t : 0)};
    }

    Ring ring_from(size_t first) {
        Ring ring;
        for (size_t s = first; next_[s] != nowhere;) {
            const auto p = crossing(s);
            if (ring.size() >= 2 && straight(ring[ring.size() - 2], ring.back(), p)) ring.back() = p;
            else ring.push_back(p);
            const size_t after = next_[s];
            next_[s] = nowhere;
            s = after;
        }
        return ring;
    }
    static bool straight(const std::array<float, 2>& a, const std::array<float, 2>& b, const std::array<float, 2>& c) {
        return std::fabs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) < 1e-4f;
    }

    const std::vector<float>& coverage_;
    int width_, height_;
    std::vector<size_t> next_;  // by side: the side where the piece that begins there ends
};

}  // namespace

std::vector<Ring> outlines(const std::vector<float>& coverage, int width, int height) {
    return Squares(coverage, width, height).rings();
}

std::string rings_text(const std::vector<Ring>& rings) {
    std::string out = "[";
    for (const Ring& ring : rings) {
        out += out.size() > 1 ? ",[" : "[";
        for (size_t k = 0; k < ring.size(); ++k)
            out += fmt::format("{}{},{}", k ? "," : "", std::round(double(ring[k][0]) * 100) / 100,
                               std::round(double(ring[k][1]) * 100) / 100);
        out += "]";
    }
    return out + "]";
}

}  // namespace display
