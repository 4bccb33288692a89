// SPDX-License-Identifier: BSD-3-Clause
// What decides which pixels of swayed pictures are bright: their mean, but for pixels in doubt (calm.h), which show a
// mean of their own and are swayed by the error that it has left.
#pragma once
#include <vector>
#include "comfort/swayed.h"

namespace comfort {

struct Doubtful {
    uint32_t pixel;
    float mean, sway;
};

class Calmed {
public:
    struct Pixel {
        float mean, sway;
    };
    // in_doubt: in the order of pixels; borrowed.
    Calmed(const Swayed& pictures, const std::vector<Doubtful>& in_doubt) : lum_(pictures), in_doubt_(in_doubt) {}

    const Swayed& lum() const { return lum_; }
    const std::vector<Doubtful>& in_doubt() const { return in_doubt_; }
    Pixel at(size_t pixel) const;
    float most_in_doubt() const;  // that a pixel in doubt may show, or 0
    // Whether a picture may show one of n pixels in doubt above the limit.
    bool doubtful_exceeds(size_t first, int n, float limit) const;
    bool mean_exceeds(size_t first, int n, float limit) const;  // of n pixels as the mean has them
    void picture(int number, GreyPicture& out) const;
    GreyPicture mean() const;

private:
    const Doubtful* from(size_t pixel) const;  // the first that is not before it
    const Doubtful* end() const { return in_doubt_.data() + in_doubt_.size(); }
    const Swayed& lum_;
    const std::vector<Doubtful>& in_doubt_;
};

}  // namespace comfort
