// SPDX-License-Identifier: BSD-3-Clause
// Summing the frames of one stream: see accumulate.h.
#include "film/accumulate.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/processors.h"
#include "base/threads.h"
#include "base/value.h"
#include "base/wide.h"
#include "film/fingerprint.h"
#include "image/header.h"

namespace film {
namespace {

bool has_pixels_of(const image::Picture& picture, const ExactSum& sum, int64_t n) {
    std::atomic<bool> same{true};
    base::in_shares(sum.size(), numbers_a_share, base::processors(), [&](size_t from, size_t end) {
        for (size_t i = from; i < end; ++i)
            if (float(eq7(picture.frame0, sum, n, i)) != picture.rgb[i]) same = false;
    });
    return same;
}

// Eq. 7 for a row of numbers, as eq7() has it.
WIDE_LOOP void means(const float* frame0, const double* sums, double frames, size_t n, float* out) {
    if (!frame0)
        for (size_t i = 0; i < n; ++i) out[i] = float(sums[i] / frames);
    else
        for (size_t i = 0; i < n; ++i) out[i] = float(double(frame0[i]) + sums[i] / frames);
}

}  // namespace

double eq7(const std::vector<float>& frame0, const ExactSum& sum, int64_t n, size_t i) {
    const double mean = sum.value(i) / (n > 0 ? double(n) : 1);  // of no frames the sums are 0
    return frame0.empty() ? mean : double(frame0[i]) + mean;
}

void add_frames_of(const image::Picture& picture, const std::string& name, ExactSum& sum) {
    const int64_t n = picture.header.frames.value_or(0);
    if (n == 0) return;
    if (!picture.sum.empty()) {
        ExactSum exact;
        exact.clear(picture.rgb.size());
        exact.add(picture.sum, name);
        if (!has_pixels_of(picture, exact, n))
            base::fail(name, "its pixels differ from its exact sums: another program has changed it");
        sum.add(picture.sum, name);
        return;
    }
    std::vector<double> rounded(picture.rgb.begin(), picture.rgb.end());
    for (size_t i = 0; i < rounded.size(); ++i)
        rounded[i] = double(n) * (rounded[i] - (picture.frame0.empty() ? 0 : double(picture.frame0[i])));
    sum.add(rounded);
}

void Accumulator::start(const image::Picture& frame, int64_t k) {
    width_ = frame.width;
    height_ = frame.height;
    first_ = next_ = k;
    header_ = frame.header;
    frame0_.clear();
    moments_ = frame.moments;
    sum_.clear(frame.rgb.size());
}

bool Accumulator::restarts(const image::Header& frame) const {
    if (empty() || !resumed_.empty()) return false;
    return frame.frame == 0 || frame.view_name != header_.view_name || frame.sky_name != header_.sky_name ||
           frame.state != header_.state || frame.action != header_.action;
}

void Accumulator::add(const image::Picture& frame, const std::string& place) {
    const image::Header& h = frame.header;
    if (!h.frame || h.frames)
        base::fail(place, h.frames || !h.ranges.empty() ? "is a sum of frames inside a stream of frames"
                                                        : "has no FRAME= line: not a frame of ptrace");
    const int64_t k = *h.frame;
    if (empty() || restarts(h)) {
        start(frame, k);
    } else {
        if (!resumed_.empty()) require_same_action(h, header_, fmt::format("{}: frame {}", place, k), resumed_);
        require_next(k, place);
        require_same(frame, place);
        if (!resumed_.empty() && !grown_) image::add_input_history(header_, place, h);
        grown_ = true;
    }
    header_.last_frame = h.last_frame;
    ++next_;
    bool trouble = false;
    if (k == 0) {
        frame0_ = frame.rgb;
        for (float& v : frame0_)
            if (!std::isfinite(v)) v = 0, trouble = true;
    } else {
        trouble = !sum_.add(frame.rgb, base::processors());
    }
    if (trouble) base::warn(place, "values that are not finite were taken as 0");
}

void Accumulator::require_next(int64_t k, const std::string& place) const {
    if (k > next_) {
        const int64_t last = k - 1;
        base::fail(place, last == next_
                              ? fmt::format("frame {} is missing (this is frame {})", last, k)
                              : fmt::format("frames {} to {} are missing (this is frame {})", next_, last, k));
    }
    if (k < next_ && !resumed_.empty() && !grown_)
        base::fail(place, fmt::format("frame {} is in {} already, which continues with frame {}", k, resumed_, next_));
    if (k < next_)
        base::fail(place, k == next_ - 1 ? fmt::format("frame {} comes twice", k)
                                         : fmt::format("frame {} after frame {}: out of order", k, next_ - 1));
}

void Accumulator::require_same(const image::Picture& frame, const std::string& place) const {
    const std::string number = fmt::format("frame {}", *frame.header.frame);
    const std::string before = resumed_.empty() ? "the frames before it" : resumed_;
    if (frame.width != width_ || frame.height != height_)
        base::fail(place, fmt::format("{} is {} x {}, {} {} {} x {}", number, frame.width, frame.height, before,
                                      resumed_.empty() ? "are" : "is", width_, height_));
    if (frame.header.view != header_.view) base::fail(place, number + " has another view than " + before);
    if (frame.header.grids != header_.grids) base::fail(place, number + " has other points than " + before);
    if (frame.header.seed != header_.seed) base::fail(place, number + " has another seed than " + before);
    require_same_fingerprint(frame.header, header_, place + ": " + number, before);
}

void Accumulator::resume(const image::Picture& sum, const std::string& name) {
    const image::Header& h = sum.header;
    if (h.ranges.size() != 1 || !h.other_seeds.empty())
        base::fail(name, "has several seeds or holes between its frames: sum further frames by themselves and merge");
    const bool zero = h.ranges[0].first == 0;
    const int64_t n = h.frames.value_or(0);
    if (zero && n > 0 && sum.frame0.empty())
        base::fail(name,
                   "has frame 0 summed in and not kept apart, so that no further frames can be weighted: "
                   "write it as OpenEXR (-o file.exr), which keeps frame 0");
    start(sum, h.ranges[0].first);
    next_ = h.ranges[0].second + 1;
    header_.frames.reset();
    header_.ranges.clear();
    if (zero) frame0_ = n > 0 ? sum.frame0 : sum.rgb;
    add_frames_of(sum, name, sum_);
    resumed_ = name;
}

void Accumulator::result(image::Picture& out, bool with_parts) const {
    out.width = width_;
    out.height = height_;
    out.header = header_;
    out.header.frame.reset();
    out.header.frames = frames();
    out.header.ranges = {{first_, next_ - 1}};
    out.rgb.resize(sum_.size());
    out.frame0 = with_parts ? frame0_ : std::vector<float>();
    out.moments = with_parts ? moments_ : image::Moments();
    out.sum = with_parts ? sum_.layers() : std::vector<image::SumLayer>();
    base::in_shares(sum_.size(), numbers_a_share, base::processors(), [&](size_t from, size_t end) {
        constexpr size_t block = 256;
        double sums[block];
        for (size_t i = from; i < end; i += block) {
            const size_t n = std::min(block, end - i);
            sum_.values(i, n, sums);
            means(frame0_.empty() ? nullptr : &frame0_[i], sums, double(std::max<int64_t>(frames(), 1)), n,
                  &out.rgb[i]);
        }
    });
}

Schedule Schedule::parse(const std::string& text, const std::string& where) {
    Schedule s;
    if (text.empty() || text[0] != 'x') {
        s.every_ = base::to_int(text, where);
        if (s.every_ < 1) base::fail(where, "\"" + text + "\" is not above 0");
        return s;
    }
    const size_t slash = text.find('/');
    s.factor_ = base::to_real(text.substr(1, slash == std::string::npos ? slash : slash - 1), where);
    if (!(s.factor_ > 1)) base::fail(where, "\"" + text + "\": the factor is not above 1");
    if (slash != std::string::npos) s.parts_ = base::to_int(text.substr(slash + 1), where);
    if (s.parts_ < 1) base::fail(where, "\"" + text + "\": the steps are not above 0");
    return s;
}

// The least F^(i/M), rounded, above n.  While neighbours are less than 1 apart, every whole number is one of them;
// elsewhere i is small enough for a double to count it, and the logarithm is off by one or two at most.
int64_t Schedule::after(int64_t n) const {
    const double growth = std::log(factor_) / double(parts_);
    if ((double(n) + 1.5) * std::expm1(growth) < 1) return n + 1;
    const auto value = [&](double i) {
        const double v = std::round(std::pow(factor_, i / double(parts_)));
        return v < 9e18 ? int64_t(v) : std::numeric_limits<int64_t>::max();
    };
    double i = std::max(0., std::floor(std::log(double(n) + .5) / growth));
    while (i > 0 && value(i - 1) > n) --i;
    while (value(i) <= n) ++i;
    return value(i);
}

bool Schedule::due(int64_t n) {
    if (n == 0) return true;
    if (factor_ == 0) return n % every_ == 0;
    if (n < next_) return false;
    next_ = after(n);
    return true;
}

}  // namespace film
