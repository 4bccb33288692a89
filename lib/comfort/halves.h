// SPDX-License-Identifier: BSD-3-Clause
// Pictures of half the frames: each pixel of each shows it after the first half of the frames or after the second.
// Samples of different pixels are independent, or nearly so where they share, so which half a pixel shows may differ
// from pixel to pixel, and two halves make as many pictures as one likes.  They are noisier than the whole picture, by
// a variance twice as large, and lie around it as far as the whole lies around the truth: what a metric is of them
// tells its error and its bias.
//
// Bias: DGP and its relatives square the luminance of bright pixels, RAMMG sums absolute differences, so that noise
// makes them too large.  (Which pixels are bright is another matter: calm.h.)  If halves are r times as far off, x(n) =
// x + bias and x(n/2) = x + r bias, then x = (r x(n) - x(n/2)) / (r - 1).  What is squared goes with the variance, r =
// 2; absolute differences of noise with its deviation, r = sqrt 2.  Pixels that differ by about as much as their noise
// have a larger r, up to 2, and neighbours that share what their paths find are such.  Office, blinds and classroom
// needed 1.71, 1.73 and 1.55 for RAMMG (500 seeds each), so r is 1.65 and a tenth of what is taken off counts as its
// error, more in early frames (docs/decisions/0019-certainty.md).  All this is right to first order; a hot pixel, twice
// as bright in half of the halves and gone in the others, drops out.
//
// With x the mean of the a frames in one half, y of the b in the other and d = sqrt(a b)/(a + b) (x - y), a pixel shows
// L' + d or L' - d (the halves themselves where a = b).  The signs over the 16 pictures are a row of a Hadamard matrix,
// turned round or not by a random number for each pixel: they sum to 0, so that the mean picture is L' itself, and what
// is linear in the pixels falls into 15 sums of the same variance that know nothing of each other.
//
// They tell the sum of the pixels' d^2, which is their variance only on average: where few pixels make most of it, it
// is as uncertain as these.  With z = d times the pixel's weight in the light at the eye, 3 (sum z^2)^2 / sum z^4 is
// about (sum of variances)^2 / sum of their squares, as the fourth moment of normal errors is three times the square of
// their variance: the degrees of freedom of a sum of squares (Satterthwaite 1946).  Both uncertainties add up.  One
// pixel counts as 3, though its two halves have 1: the widest of the last looks makes up for part of that, and Welch's
// correction (less 2) for too much.
#pragma once
#include <array>
#include <cstdint>
#include <utility>
#include <vector>
#include "comfort/batches.h"
#include "comfort/swayed_row.h"

namespace comfort {

class Halves {
public:
    Halves();
    static constexpr int count = Signs::most, sums = count - 1;
    static constexpr double of_differences = 1.65;  // r of RAMMG

    // False: there are no halves yet.
    bool take(const Batches& batches);
    // The same row by row, for who goes through the picture once: begin(), then each row before it is looked at.
    // `room` may hold memory of a picture, which is given back below.
    bool begin(const Batches& batches, std::vector<float>&& room = {});
    std::vector<float>&& give_back() { return std::move(off_); }
    void find_row(int row) {
        apart_.find(size_t(row) * size_t(width_), size_t(width_), &off_[size_t(row) * size_t(width_)]);
    }

    const std::vector<float>& whole() const { return *whole_; }  // L'
    const std::vector<float>& off() const { return off_; }       // d
    bool know_frame0() const { return apart_.know_frame0; }      // and its error
    Swayed pictures() const;

    // What a metric's values, one of each picture, say of its value of the whole one.
    struct Variance {
        double sum = 0, largest = 0;  // of 15 terms
    };
    static Variance variance(const double* values);
    static double degrees(const OffAtEye& off);  // of freedom of this variance, as far as it goes with that light
    static double without_bias(double whole, const double* values, double r);

private:
    int width_ = 0, height_ = 0;
    const std::vector<float>* whole_ = nullptr;
    std::vector<float> off_;  // d
    Batches::Distance apart_{0, nullptr, nullptr, false};
    std::vector<uint8_t> pattern_;  // by pixel; word w is row w of the matrix, and row 0 is none's
    Signs signs_;
};

}  // namespace comfort
