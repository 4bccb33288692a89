// SPDX-License-Identifier: BSD-3-Clause
// Studies of intervals: streams of sums with a known truth, whose estimates are asked at some looks.
#pragma once
#include <cmath>
#include <functional>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "report/sum.h"
#include "glare_pictures.h"

namespace report {
using namespace glare;

// Square pictures of some truth, of which the pixels of one rectangle have noise, the same in each.
class Even {
public:
    struct Noise {
        int left, right, top, bottom;
        double cdm2;  // standard deviation of a frame
    };
    Even(std::vector<double> truth, Noise noise, uint32_t seed)
        : truth_(std::move(truth)),
          side_(int(std::sqrt(double(truth_.size())))),
          noise_(noise),
          random_(seed),
          sum_(truth_.size()) {}
    std::vector<double> next() {
        ++n_;
        std::vector<double> mean(sum_.size());
        for (int i = 0; i < side_ * side_; ++i) {
            const int x = i % side_, row = i / side_;
            const bool noisy = x >= noise_.left && x < noise_.right && row >= noise_.top && row < noise_.bottom;
            sum_[size_t(i)] += truth_[size_t(i)] + (noisy ? noise_.cdm2 * gaussian_(random_) : 0);
            mean[size_t(i)] = sum_[size_t(i)] / double(n_);
        }
        return mean;
    }

private:
    std::vector<double> truth_;
    int side_;
    Noise noise_;
    std::mt19937 random_;
    std::normal_distribution<double> gaussian_;
    std::vector<double> sum_;
    int64_t n_ = 0;
};

// What the intervals of a metric do, at some looks and over many seeds, for pictures of 60 degrees.
struct Study {
    Study(std::string name, std::vector<int64_t> at, int how_many)
        : metric(std::move(name)), looks(std::move(at)), seeds(how_many) {}
    std::string metric;
    std::vector<int64_t> looks;  // frames
    int seeds;
    double truth = 0;
    std::vector<int> covered, known, tails;
    std::vector<double> plain, unbiased, half_width, deviation;  // means, and the spread of `unbiased`

    template <class Stream>
    void run(const std::vector<double>& exact_cdm2, const std::function<Stream(uint32_t)>& stream_of) {
        Settings settings;
        Requirements requirements;
        ColumnChoice choice;
        choice.names = {metric};
        const std::vector<Column> columns = choose_columns(choice, settings, requirements);
        const SharedPlan plan = make_plan({settings, requirements});
        side = int(std::sqrt(double(exact_cdm2.size())));
        image::Picture exact = fisheye_of(exact_cdm2, side, 60);
        truth = columns[0].value(measure(read(plan, exact, "truth")));
        covered.assign(looks.size(), 0), known.assign(looks.size(), 0), tails.assign(looks.size(), 0);
        for (auto* sums : {&plain, &unbiased, &half_width, &deviation}) sums->assign(looks.size(), 0);
        for (int seed = 1; seed <= seeds; ++seed) one(stream_of(uint32_t(seed)), plan, columns);
        for (size_t k = 0; k < looks.size(); ++k)
            deviation[k] = std::sqrt(std::max(0., deviation[k] - unbiased[k] * unbiased[k]));
    }
    // An interval that never ends holds everything.
    bool too_wide(size_t k, double times) const { return !(half_width[k] < times * 1.96 * deviation[k]); }
    std::string told(size_t k) const {
        std::ostringstream out;
        out << looks[k] << " frames: " << covered[k] << " of " << known[k] << " intervals hold " << truth << "; plain "
            << plain[k] << ", without bias " << unbiased[k] << " +- " << half_width[k] << ", deviation " << deviation[k]
            << ", tails " << tails[k];
        return out.str();
    }

private:
    template <class Stream>
    void one(Stream stream, const SharedPlan& plan, const std::vector<Column>& columns) {
        Reading reading;
        Sum sum;
        size_t next = 0;
        for (int64_t n = 1; n <= looks.back(); ++n) {
            image::Picture p = fisheye_of(stream.next(), side, 60);
            as_sum(p, n);
            reading = read(plan, p, "sum", {}, std::move(reading));
            sum = add(std::move(sum), p, reading, "sum", true);
            const Measurement m = measure(reading);
            sum = look(std::move(sum), reading, m, columns, 0);
            if (!sum.looked || n != looks[next]) continue;
            const uncertainty::Estimate& e = sum.look.estimate(0);
            const uncertainty::Interval off = e.around(0.05, n);
            covered[next] += e.known() && e.value + off.low <= truth && truth <= e.value + off.high;
            known[next] += e.known();
            tails[next] += e.unreliable;
            plain[next] += columns[0].value(m) / seeds, unbiased[next] += e.value / seeds;
            half_width[next] += off.half_width() / seeds, deviation[next] += e.value * e.value / seeds;
            ++next;
        }
    }
    int side = 0;
};

}  // namespace report
