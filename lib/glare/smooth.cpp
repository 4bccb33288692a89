// SPDX-License-Identifier: BSD-3-Clause
// Smoothing by runs and prefix sums along rows: the solid angle of each group in a disc.
#include "glare/smooth.h"
#include <algorithm>
#include <cmath>
#include <tuple>

namespace glare {
namespace {

struct Share {
    uint32_t group;
    double omega;
};

class Smoother {
public:
    Smoother(const std::vector<Run>& runs, const Geometry& g, float radius) : g_(g), runs_(runs), radius_(radius) {
        for (int d = 0; d <= int(radius); ++d) half_.push_back(int(std::sqrt(double(radius) * radius - double(d) * d)));
        for (size_t d = 0; d < half_.size(); ++d) {  // corrects the rounding of the root
            while (distance(half_[d] + 1, int(d)) <= radius) ++half_[d];
            while (distance(half_[d], int(d)) > radius) --half_[d];
        }
        sum_row_sizes();
    }

    std::vector<Joining> run() {
        std::vector<Joining> out;
        for (int row = 0; row < g_.height; ++row) smooth_row(row, out);
        std::sort(out.begin(), out.end(), [&](const Joining& a, const Joining& b) {
            return std::make_tuple(g_.x_of(a.pixel), g_.y_of(a.pixel), a.group) <
                   std::make_tuple(g_.x_of(b.pixel), g_.y_of(b.pixel), b.group);
        });
        return out;
    }

private:
    static double distance(int dx, int dy) { return std::sqrt(double(dx) * dx + double(dy) * dy); }

    // Prefix sums of solid angle in a row, and the runs of each row.
    void sum_row_sizes() {
        from_left_.assign(size_t(g_.width + 1) * g_.height, 0);
        first_run_.assign(g_.height + 1, runs_.size());
        for (int row = 0; row < g_.height; ++row) {
            double* sum = &from_left_[size_t(g_.width + 1) * row];
            for (int x = 0; x < g_.width; ++x) sum[x + 1] = sum[x] + std::fabs(g_.omega[size_t(row) * g_.width + x]);
        }
        for (size_t k = runs_.size(); k-- > 0;) first_run_[runs_[k].start / g_.width] = k;
        for (int row = g_.height; row-- > 0;) first_run_[row] = std::min(first_run_[row], first_run_[row + 1]);
    }

    // Rows above the disc's centre are those with smaller numbers; y counts from the bottom.
    void smooth_row(int row, std::vector<Joining>& out) {
        const int reach = int(radius_), y = g_.height - 1 - row;
        const int lowest = std::max(0, y - reach);
        const int highest = y + reach > g_.height - 1 ? g_.height - 2 : y + reach;  // evalglare's error at this edge
        rows_.clear();
        bool any = false;
        for (int at = lowest; at <= highest; ++at) {
            const int other = g_.height - 1 - at;
            rows_.push_back({other, half_[std::abs(at - y)], first_run_[other]});
            any = any || first_run_[other] != first_run_[other + 1];
        }
        if (!any) return;
        size_t own = first_run_[row];
        for (int x = 0; x < g_.width; ++x) {
            const uint32_t pixel = uint32_t(row) * uint32_t(g_.width) + uint32_t(x);
            while (own < runs_.size() && runs_[own].start + runs_[own].length <= pixel) ++own;
            if (own < runs_.size() && runs_[own].start <= pixel) continue;  // not dark
            if (!g_.valid(pixel)) continue;
            smooth_pixel(x, pixel, out);
            if (shares_.empty()) x = std::max(x, next_column_ - 1);
        }
    }

    // Returns with next_column_ set to the first column within reach of a run if shares_ is empty.
    void smooth_pixel(int x, uint32_t pixel, std::vector<Joining>& out) {
        const int last_column = x + int(radius_) > g_.width - 1 ? g_.width - 2 : g_.width - 1;
        shares_.clear();
        next_column_ = g_.width;
        for (DiscRow& r : rows_) {
            const int from = std::max(0, x - r.half), to = std::min(x + r.half, last_column);
            const uint32_t start = uint32_t(r.row) * uint32_t(g_.width), end = uint32_t(first_run_[r.row + 1]);
            while (r.run < end && runs_[r.run].start + runs_[r.run].length <= start + uint32_t(from)) ++r.run;
            if (r.run < end) next_column_ = std::min(next_column_, int(runs_[r.run].start - start) - r.half);
            for (size_t k = r.run; k < end && int(runs_[k].start - start) <= to; ++k) {
                const int run_from = int(runs_[k].start - start), run_to = run_from + int(runs_[k].length) - 1;
                add(runs_[k].group, size(r.row, std::max(from, run_from), std::min(to, run_to)));
            }
        }
        if (shares_.empty()) return;
        double all = 0;
        for (const DiscRow& r : rows_) all += size(r.row, std::max(0, x - r.half), std::min(x + r.half, last_column));
        for (const Share& s : shares_)
            if (s.omega / all > 0.2) out.push_back({pixel, s.group});
    }

    double size(int row, int from, int to) const {
        const double* sum = &from_left_[size_t(g_.width + 1) * row];
        return to < from ? 0 : sum[to + 1] - sum[from];
    }
    void add(uint32_t group, double omega) {
        for (Share& s : shares_)
            if (s.group == group) {
                s.omega += omega;
                return;
            }
        shares_.push_back({group, omega});
    }

    struct DiscRow {
        int row, half;
        size_t run;
    };  // run: the first that ends inside or right of the disc

    const Geometry& g_;
    const std::vector<Run>& runs_;
    float radius_;
    std::vector<int> half_;  // of the disc's rows, by their distance from its centre
    std::vector<double> from_left_;
    std::vector<size_t> first_run_;  // by row
    std::vector<DiscRow> rows_;
    std::vector<Share> shares_;
    int next_column_ = 0;
};

}  // namespace

std::vector<Joining> smooth(const std::vector<Run>& runs, const Geometry& geometry, float radius) {
    return Smoother(runs, geometry, radius).run();
}

}  // namespace glare
