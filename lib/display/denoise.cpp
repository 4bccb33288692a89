// SPDX-License-Identifier: BSD-3-Clause
// See denoise.h.  For each offset in the search window the distance of all pixels to those at that offset is one
// picture, whose box filter is the distance of patches: the work does not grow with the size of the patches.
#include "display/denoise.h"

#include <algorithm>
#include <cmath>

#include "base/threads.h"

namespace display {
namespace {

constexpr int reach = 7;         // the search window has 15 x 15 pixels
constexpr int patch = 3;         // a patch 7 x 7
constexpr float damping = .45f;  // k of the paper: smaller keeps more detail and more noise
constexpr float tiny = 1e-12f;
constexpr float none = 30;  // a distance from which on a pixel counts for nothing: exp(-30)
// One pixel of a patch can bring that about and no more: where there is no noise distances have no bound, and those
// that a box filter takes out of its sum again would leave their rounding in it.
constexpr float farthest = 2 * none * (2 * patch + 1) * (2 * patch + 1);

// One half: its picture and the variance of that, 3 floats a pixel.
struct Half {
    std::vector<float> mean, variance;
};

// Means of (2 radius + 1) x (2 radius + 1) values, fewer at the border; `columns` values in each of `rows` rows.
void box_filter(std::vector<float>& v, std::vector<float>& between, int columns, int rows, int radius) {
    const auto pass = [&](const std::vector<float>& from, std::vector<float>& to, int length, int lines, size_t step,
                          size_t line_step) {
        for (int line = 0; line < lines; ++line) {
            const float* in = &from[size_t(line) * line_step];
            float* out = &to[size_t(line) * line_step];
            float sum = 0;
            int first = 0, end = 0;
            for (int i = 0; i < length; ++i) {
                for (; end < std::min(length, i + radius + 1); ++end) sum += in[size_t(end) * step];
                for (; first < i - radius; ++first) sum -= in[size_t(first) * step];
                out[size_t(i) * step] = sum / float(end - first);
            }
        }
    };
    pass(v, between, columns, rows, 1, size_t(columns));
    pass(between, v, rows, columns, size_t(columns), 1);
}

// The variance is itself an estimate, and less noisy with its neighbours'.
void smooth_channels(std::vector<float>& rgb, int width, int height) {
    std::vector<float> plane(rgb.size() / 3), between(plane.size());
    for (size_t c = 0; c < 3; ++c) {
        for (size_t i = 0; i < plane.size(); ++i) plane[i] = rgb[3 * i + c];
        box_filter(plane, between, width, height, 1);
        for (size_t i = 0; i < plane.size(); ++i) rgb[3 * i + c] = plane[i];
    }
}

class Filter {
public:
    Filter(const Half (&half)[2], int width, int height, std::vector<float>& out)
        : half_(half), width_(width), height_(height), out_(out) {}

    // Rows first to end.
    void rows(int first, int end) const {
        const size_t pixels = size_t(end - first) * width_;
        std::vector<float> sum[2], weights[2], distance, between;
        for (int h = 0; h < 2; ++h) sum[h].assign(3 * pixels, 0), weights[h].assign(pixels, 0);
        const int above = std::max(0, first - patch), below = std::min(height_, end + patch);
        for (int dy = -reach; dy <= reach; ++dy)
            for (int dx = -reach; dx <= reach; ++dx) {
                // pixels whose partner is in the picture, too
                const Box box{std::max(0, -dx), std::min(width_, width_ - dx), std::max(above, -dy),
                              std::min(below, height_ - dy)};
                if (box.left >= box.right || box.top >= box.bottom) continue;
                const ptrdiff_t offset = ptrdiff_t(dy) * width_ + dx;
                for (int h = 0; h < 2; ++h) {
                    distances(half_[h], box, offset, distance);
                    between.resize(distance.size());
                    box_filter(distance, between, box.right - box.left, box.bottom - box.top, patch);
                    average(half_[1 - h], box, offset, distance, first, end, sum[1 - h], weights[1 - h]);
                }
            }
        float* to = &out_[3 * size_t(first) * width_];
        for (size_t i = 0; i < 3 * pixels; ++i)
            to[i] = .5f * (sum[0][i] / weights[0][i / 3] + sum[1][i] / weights[1][i / 3]);
    }

private:
    struct Box {
        int left, right, top, bottom;
    };
    // Squared, less what noise alone would give (Eq. 5 of the paper).
    void distances(const Half& half, const Box& box, ptrdiff_t offset, std::vector<float>& distance) const {
        distance.clear();
        for (int y = box.top; y < box.bottom; ++y)
            for (int x = box.left; x < box.right; ++x) {
                const size_t p = 3 * (size_t(y) * width_ + size_t(x)), q = size_t(ptrdiff_t(p) + 3 * offset);
                float all = 0;
                for (size_t c = 0; c < 3; ++c) {
                    const float vp = half.variance[p + c], vq = half.variance[q + c];
                    const float d = half.mean[p + c] - half.mean[q + c];
                    all += (d * d - (vp + std::min(vp, vq))) / (tiny + damping * damping * (vp + vq));
                }
                distance.push_back(all / 3 < farthest ? all / 3 : farthest);  // so is what is no number
            }
    }
    void average(const Half& half, const Box& box, ptrdiff_t offset, const std::vector<float>& distance, int first,
                 int end, std::vector<float>& sum, std::vector<float>& weights) const {
        for (int y = std::max(first, box.top); y < std::min(end, box.bottom); ++y)
            for (int x = box.left; x < box.right; ++x) {
                const float d = distance[size_t(y - box.top) * size_t(box.right - box.left) + size_t(x - box.left)];
                if (d > none) continue;
                const float w = d > 0 ? std::exp(-d) : 1;
                const size_t to = size_t(y - first) * width_ + size_t(x);
                const float* from = &half.mean[size_t(3 * (ptrdiff_t(y) * width_ + x + offset))];
                for (size_t c = 0; c < 3; ++c) sum[3 * to + c] += w * from[c];
                weights[to] += w;
            }
    }

    const Half (&half_)[2];
    int width_, height_;
    std::vector<float>& out_;
};

}  // namespace

void HalfSums::clear(size_t values) {
    frames_ = 0;
    for (auto& h : half_) h.assign(values, 0);
    squares_.assign(values, 0);
}

void HalfSums::add(const std::vector<float>& frame) {
    std::vector<float>& half = half_[++frames_ % 2];
    for (size_t i = 0; i < half.size(); ++i) {
        if (!std::isfinite(frame[i])) continue;
        half[i] += frame[i];
        squares_[i] += frame[i] * frame[i];
    }
}

std::vector<float> denoised(const HalfSums& sums, const std::vector<float>& frame0, int width, int height,
                            unsigned threads) {
    Half half[2];
    const auto n = float(sums.frames_);
    const float of_half[2] = {float(sums.frames_ / 2), float((sums.frames_ + 1) / 2)};
    for (int h = 0; h < 2; ++h) {
        half[h].mean = frame0;
        half[h].variance.resize(frame0.size());
        for (size_t i = 0; i < frame0.size(); ++i) {
            const float mean = (sums.half_[0][i] + sums.half_[1][i]) / n;
            const float variance = std::max(0.f, sums.squares_[i] / n - mean * mean) * n / (n - 1);
            half[h].mean[i] += sums.half_[h][i] / of_half[h];
            half[h].variance[i] = std::min(1e30f, variance / of_half[h]);  // squares may have overflowed
        }
        smooth_channels(half[h].variance, width, height);
    }
    std::vector<float> out(frame0.size());
    const Filter filter(half, width, height, out);
    constexpr int strip = 32;  // fixed, so that the threads do not show
    base::in_shares(size_t(height), strip, threads, [&](size_t y, size_t end) { filter.rows(int(y), int(end)); });
    return out;
}

}  // namespace display
