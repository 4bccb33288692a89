// SPDX-License-Identifier: BSD-3-Clause
// See moments.h.
#include "image/moments.h"

#include <cmath>

#include "image/picture.h"

namespace image {

void clean_moments(std::vector<float>& moments) {
    constexpr float largest_variance = 1e36f, largest_place = 1;  // pixels
    for (size_t i = 0; i < moments.size(); ++i) {
        float& v = moments[i];
        const size_t k = i % moment_numbers;
        if (!(std::fabs(v) <= (k < moment_right ? largest_variance : largest_place))) v = 0;
        if (k == moment_variance && v < 0) v = 0;
    }
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
               h.sky_name == first.sky_name && h.state == first.state && h.action == first.action &&
               p.width == first_->width && p.height == first_->height) {
        p.moments = first_->moments;
    } else if (h.frames) {
        *first_ = {};
    }
}

}  // namespace image
