// SPDX-License-Identifier: BSD-3-Clause
// A calmer picture, in which it is decided which pixels are bright.
//
// Glare sources are pixels above a threshold, joined where they lie near each other (connect.h).  A dark wall of noisy
// pixels has some above the threshold: they make sources of their own and join windows that are apart, so that DGP is
// wrong by much and changes by leaps when the last of them sinks.  Half pictures are noisier, so they all agree on such
// a mistake and tell nothing of it.
//
// What is known is that a pixel so far off its neighbours is not sure itself.  So wherever noise may decide (the
// threshold lies within 2.5 standard errors) a pixel is replaced by the mean of those of the 5 x 5 pixels around it
// that differ from it by no more than their noise explains, weighted by (1 - q)^2 with q = difference^2/(8 (v + v')).
// Pixels wider than 1.3 degrees have less in common with their neighbours: 3 x 3 up to 2.9 degrees, then each by
// itself. The variance v of a pixel is that of its two halves (halves.h), or the mean of these around it if that is
// larger: where few samples are bright, pixels without one seem to be sure.  What error the mean has left sways it in
// each of the 16 pictures, by the same signs as the half, so that decisions that noise allows differ among them.
//
// DGP leaps where a pixel crosses the threshold.  Where many pixels may, the mean square of their leaps is what counts,
// and chance decides whether a pixel is swayed far enough.  Where few may, one leap can be all that matters, and an
// interval holds it or does not: so if no more than eight pixels lie within two standard errors of the threshold, half
// of the pictures show each of them on its other side.  If there are one or two, DGP is taken to be in the middle of
// their leaps (certainty.cpp); of more, all on one side, the middle would be farther off than squares add up to.
//
// With more frames variances fall, no pixel is in doubt, and the picture is the plain one.
#pragma once
#include <vector>
#include "comfort/calmed.h"
#include "comfort/geometry.h"
#include "comfort/halves.h"

namespace comfort {

// The rows around a pixel's.  A variance below 0 marks a pixel that does not count.
struct CalmRows {
    static constexpr int radius = 2, count = 2 * radius + 1;
    const float *grey[count], *variance[count];
};

class Calm {
public:
    void begin(const Geometry& geometry, double threshold_cdm2);
    // One row after the other, as `halves` finds them.
    void take_row(const Halves& halves, const Geometry& geometry, int y);
    // After the last one: pixels that have been replaced, in their order.
    const std::vector<Doubtful>& replaced() const { return replaced_; }
    // So few pixels stand at the threshold that the middle of their steps is as good a guess as either end.
    bool in_the_middle() const;

private:
    float* variance(const Geometry& geometry, int y);  // of one of the last rows
    float* row_means(const Geometry& geometry, int y);
    void find_variance(const Geometry& geometry, int y);
    void calm_row(const std::vector<float>& noisy, const Geometry& geometry, int y);
    void carry_across();
    void average_around(const CalmRows& near, const Geometry& geometry, int x, int y);
    int radius_ = 0;  // of the neighbourhood, in pixels
    float threshold_ = 0;
    uint32_t random_ = 0;
    std::vector<Doubtful> replaced_;
    std::vector<size_t> at_threshold_;         // of these, within two standard errors of it
    std::vector<float> variance_, row_means_;  // of the last rows, and of their squares
    std::vector<float> zeros_, outside_;       // rows beyond the picture: no light, and variances below 0
    std::vector<uint32_t> doubtful_;           // of a row, as bits
};

}  // namespace comfort
