// SPDX-License-Identifier: BSD-3-Clause
// Samples of the pixels of a picture, drawn by a device: one each and, in the focus, the mean of several.
#pragma once
#include "trace/device.h"
#include "trace/focus.h"

namespace trace {

// n samples of each of some pixels.
struct Pass {
    uint32_t mode;
    int64_t first_sample;
    uint32_t n, first_pixel, pixels;
};

class Samples {
public:
    void set_focus(Device& device, const Focus& focus);
    // May the paths of whole pictures share their far ends (kernels/share.h)?
    void set_sharing(bool may) { may_share_ = may; }
    // How many slots a sample of the whole picture takes.
    uint32_t slots(const Params& base) const;
    // rgb: the samples of a pixel lie side by side, as do their rays.
    void run(Device& device, const Params& base, const Pass& pass, std::vector<float>& rgb);
    // Whatever is added to a picture passes here, so that every sum of a million of them is a finite float.
    void scrub(std::vector<float>& rgb);

private:
    bool shares(const Params& par) const;
    void refine(Device& device, const Params& base, const Pass& pass, size_t part, std::vector<float>& rgb);

    Focus focus_;
    std::vector<uint32_t> focus_at_;  // of each part among all pixels of the focus
    bool may_share_ = false;
    std::vector<float> copies_;
    int64_t bad_ = 0;  // samples that were set to 0
};

}  // namespace trace
