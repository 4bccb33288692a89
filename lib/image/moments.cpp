// SPDX-License-Identifier: BSD-3-Clause
// See moments.h.
#include "image/moments.h"

#include <cmath>

#include "image/picture.h"

namespace image {

void clean_moments(std::vector<float>& moments) {
    constexpr float largest = 1e36f, largest_place = 1;  // pixels
    for (size_t i = 0; i < moments.size(); ++i) {
        float& v = moments[i];
        const size_t k = i % moment_numbers;
        if (!(std::fabs(v) <= (k == moment_right || k == moment_up ? largest_place : largest))) v = 0;
        if (k == moment_variance && v < 0) v = 0;
    }
}

Moments complete_moments(const std::vector<float>& read, size_t numbers) {
    std::vector<float> out(read.size() / numbers * moment_numbers, 0.0f);
    for (size_t i = 0; i < read.size(); ++i) out[i / numbers * moment_numbers + i % numbers] = read[i];
    clean_moments(out);
    return std::make_shared<const std::vector<float>>(std::move(out));
}

CarriedMoments::CarriedMoments() : first_(std::make_unique<Picture>()) {}
CarriedMoments::~CarriedMoments() = default;

void CarriedMoments::pass(Picture& p) {
    const Header &h = p.header, &first = first_->header;
    if (p.moments) {
        first_->header = h;
        first_->moments = p.moments;
        first_->width = p.width, first_->height = p.height;
    } else if (h.frames > 0 && !lacks_frame0(h) && h.seed == first.seed && h.view_name == first.view_name &&
               h.sky_name == first.sky_name && p.width == first_->width && p.height == first_->height) {
        p.moments = first_->moments;
    } else if (h.frames) {
        *first_ = {};
    }
}

}  // namespace image
