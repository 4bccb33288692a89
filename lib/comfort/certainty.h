// SPDX-License-Identifier: BSD-3-Clause
// How certain the numbers of a growing picture are: an estimate without bias, and an interval, for each column.
//
// Columns of the whole picture are measured again in 16 pictures of half the frames (halves.h): how these differ gives
// the standard error with up to 15 degrees of freedom, and their mean the bias.  Which of their pixels are bright is
// decided in a calmer picture, which differs among them as far as noise allows other decisions (calm.h).
//
// Columns of regions have few pixels, sometimes one: their errors come from up to 16 batches of frames (batches.h),
// left out one at a time.  With n frames, m_j in batch j and d_j the change without it, x_j = d_j (n - m_j)/m_j is how
// far the batch by itself lies off, and   variance = 1/n * sum m_j (x_j - mean x)^2 / (batches - 1),
// the delete-one jackknife for batches of unequal size (Busing, Meijer and van der Leeden 1999).  Where few bright
// samples make most of a mean, it comes out too low as long as they have not come, and so does its error: what makes
// up for that is the batches' skewness (interval.h).
//
// A rule that stops as soon as an interval is narrow picks the looks where it came out too narrow: so it is the widest
// of the looks since half as many frames, each carried to the same n.
//
// Frames 1 to 8 share the direct samples of frame 0, half of them each (docs/decisions/0002-frame-zero.md).  Half
// pictures know their error as long as every frame is a batch, and again when half of all frames are behind them;
// batches do when there are six behind.  Until then frame 0's error is added: each of its pixels is moved by what a
// neighbourhood of 2 x 2 pixels is off a plane, with signs at random, four times.  Edges count as noise there, so this
// errs on the safe side.
//
// All this is done at looks only, at 2, 3, 5, 8, 12, 17, 25 ... frames, for the 16 pictures at once (swayed_measure.h).
#pragma once
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>
#include "comfort/batches.h"
#include "comfort/calm.h"
#include "comfort/columns.h"
#include "comfort/halves.h"
#include "comfort/interval.h"

namespace comfort {

class Certainty {
public:
    // Without `errors` only the values of columns that need batches.
    Certainty(Meter& meter, const std::vector<Column>& columns, bool errors);

    void restart();                     // another picture begins
    void frame0(const Luminance& lum);  // L(0)
    // L'(n), which may stand in room(), of a picture that will have `last` frames.  Then, when a look is due, m of the
    // same picture.
    std::vector<float>& room() { return batches_.room_for_next(); }
    void add(const Luminance& lum, int64_t n, std::optional<int64_t> last = {});
    bool due() const { return batches_.count() >= 2 && batches_.frames() >= next_look_; }
    void look(const Luminance& lum, const Measurement& m);
    void pass_look();  // without looking

    int looks() const { return looks_; }
    const Estimate& estimate(size_t column) const { return estimates_[column]; }
    const Batches& batches() const { return batches_; }

private:
    using Values = std::vector<double>;  // of all columns; nan for those not asked for
    enum class Kind { picture, region };
    Values values(const Measurement& m, Kind kind) const;
    Measurement look_at_halves(const Luminance& lum, const Measurement& m, std::vector<Estimate>& estimates);
    void look_at_batches(const Measurement& m, std::vector<Estimate>& estimates);
    void find_frame0_error();
    std::vector<Measurement> moved(const Luminance& lum, const Measurement& m);
    void add_frame0_error(const Luminance& lum, const Measurement& m, const Measurement& unmoved,
                          std::vector<Estimate>& estimates);
    bool has(Kind kind) const;
    bool whole_batches_suffice() const;

    Meter& meter_;
    const std::vector<Column>& columns_;
    bool errors_;
    Batches batches_;
    Halves halves_;
    Calm calm_;
    std::vector<float> frame0_, frame0_error_;  // by pixel; empty: not known, not needed so far
    Signs moved_signs_;
    std::vector<uint8_t> moved_pattern_;  // by pixel
    GreyPicture scratch_;
    std::deque<std::vector<Estimate>> own_;  // of each look since half as many frames, by itself
    std::vector<Estimate> estimates_;        // with the widest of them
    int64_t next_look_ = 0;
    int looks_ = 0;
};

}  // namespace comfort
