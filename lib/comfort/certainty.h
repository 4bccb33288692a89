// SPDX-License-Identifier: BSD-3-Clause
// How certain the numbers of a growing picture are: an estimate without bias and its standard error for each column.
//
// The frames are cut into batches (batches.h); the metrics are worked out again without each of them.  With n frames,
// m_j in batch j and d_j the change when it is left out, x_j = d_j (n - m_j)/m_j is how far the batch by itself lies
// off, and   variance = 1/n * sum m_j (x_j - mean x)^2 / (batches - 1),
// the delete-one jackknife for batches of unequal size (Busing, Meijer and van der Leeden 1999); Student's t with as
// many degrees of freedom makes it an interval.  A rule that stops as soon as the error is small picks the looks where
// it came out too small: so the larger one of this look and the last is taken, each carried to the same n.
//
// Frames 1 to 16 share the direct samples of frame 0 (docs/decisions/0002-frame-zero.md), so their batches agree too
// well.  Where six later batches are there, which have samples of their own, the spread is taken from them alone, and
// holds for all.  Before, frame 0's error is added: each of its pixels is moved by what a neighbourhood of 2 x 2 pixels
// is off a plane, with signs at random, four times.  Edges count as noise there, so this errs on the safe side.
//
// All this is done at looks only, at 2, 3, 5, 8, 12, 17, 25 ... frames: each costs as much as measuring 16 pictures.
#pragma once
#include <memory>
#include <string>
#include <vector>
#include "comfort/batches.h"
#include "comfort/columns.h"

namespace comfort {

struct Estimate {
    double value = 0;    // without the bias of noise; nan if there is none
    double error = 0;    // standard error at `frames`; nan if there is none
    double degrees = 0;  // of freedom
    bool tails = false;  // a single batch makes most of the error: the samples have heavy tails
    int64_t frames = 0;  // when it was worked out

    bool known() const;  // there is an error that may be believed: no spread at all may not
    // Half the width of the interval that misses the truth with probability `outside`, for n frames.
    double half_width(double outside, int64_t n) const;
};

class Certainty {
public:
    // Without `errors` only the values of columns that need batches.
    Certainty(Meter& meter, const std::vector<Column>& columns, bool errors);

    void restart();                     // another picture begins
    void frame0(const Luminance& lum);  // L(0)
    // L'(n).  Then, when a look is due, m of the same picture: m.unbiased is set.
    void add(const Luminance& lum, int64_t n);
    bool due() const { return batches_.count() >= 2 && batches_.frames() >= next_look_; }
    void look(Measurement& m);

    int looks() const { return looks_; }
    const Estimate& estimate(size_t column) const { return estimates_[column]; }
    const Batches& batches() const { return batches_; }

private:
    struct Values {  // of all columns
        std::vector<double> plain, unbiased;
    };
    Values values(const Measurement& m) const;
    Values leave_out(size_t batch, const Batches::Parts& whole, Batches::Parts& parts);
    Estimate estimate_of(size_t column, const Values& now, const std::vector<Values>& without) const;
    bool whole_batches_suffice() const;
    void add_frame0_error(const Values& now, std::vector<Estimate>& estimates);

    Meter& meter_;
    const std::vector<Column>& columns_;
    bool errors_;
    Batches batches_;
    std::vector<float> frame0_error_;  // by pixel; empty: not known
    GreyPicture scratch_;
    std::vector<Estimate> own_, estimates_;  // with the error of the last look alone; with the larger of two
    int64_t next_look_ = 0;
    int looks_ = 0;
};

}  // namespace comfort
