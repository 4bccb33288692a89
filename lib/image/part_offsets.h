// SPDX-License-Identifier: BSD-3-Clause
// Parts of a sum (parts.h) as files keep them where nobody asks for them: what each is off their mean, in few digits,
// since noise does not compress and intervals do not ask for more: three binary digits behind the first one are right
// to 2.5 % of the noise of a pixel (rms), which changes a standard error by .6 % of itself.
#pragma once
#include <vector>

#include "image/parts.h"

namespace image {

struct PartOffsets {
    std::vector<std::vector<float>> of;  // each part: (grey - mean) 2^-scale, a half float without a tail of digits
    int scale = 0;
};
PartOffsets part_offsets(const std::vector<Part>& parts, const std::vector<float>& mean);

// Puts mean + offset in the place of grey, which holds offsets.  Rounding is spread, so that the mean of the parts is
// `mean` again.
void add_offsets(std::vector<Part>& parts, int scale, const std::vector<float>& mean);

}  // namespace image
