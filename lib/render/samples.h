// SPDX-License-Identifier: BSD-3-Clause
// Samples of the pixels of a picture, drawn by a device: one each, or the mean of several for pixels of a focus and
// noisy pixels.
#pragma once
#include "device/device.h"
#include "render/focus.h"

namespace render {

// n samples of each of some pixels.
struct Pass {
    uint32_t mode;
    int64_t first_sample;
    uint32_t n, first_pixel, pixels;
};

// The radiance of a suffix vertex must not depend on the path that found it: on the media and antimatter crossed, or on
// the ray weight that -lw limits.
bool allows_path_reuse(const kernels::Params& par);

class Samples {
public:
    // Replaces the pixels with several samples by those of a focus.
    void set_focus(device::Device& device, const Focus& focus);
    // Adds noisy pixels (noisy.h): samples of each pixel, 0: one.  Pixels of a focus keep their number.  Returns the
    // others, whose samples hold the direct class in each frame.
    std::vector<uint32_t> add_noisy(device::Device& device, std::vector<uint32_t> spp);
    // Allows path reuse in passes over whole pictures (kernels/integrator/path_reuse.h).
    void set_path_reuse(bool may) { path_reuse_ = may; }
    // Number of paths of one sample of the whole picture.
    uint32_t path_count(const kernels::Params& base) const;
    // rgb: the samples of a pixel are consecutive, as are their rays.
    void run(device::Device& device, const kernels::Params& base, const Pass& pass, std::vector<float>& rgb);
    // n direct samples of each of some pixels, which no frame contains, consecutive.  redraw: 0, or other random
    // numbers except for the places of the samples.
    void run_places(device::Device& device, const kernels::Params& base, const std::vector<uint32_t>& pixels,
                    uint32_t n, uint32_t redraw, std::vector<float>& rgb);
    // Sets samples that are not finite or too large to 0, so that every sum of a million samples is a finite float.
    // Throws Error (system) if half of a pass is affected.
    void scrub(std::vector<float>& rgb);

private:
    // Pixels with several samples in each frame, in one pass of the device.
    struct Several {
        std::vector<uint32_t> entries;    // FOCUS_WORDS each, pixels in ascending order
        uint32_t at = 0;                  // first one, among all entries of the device
        uint32_t spp = 0;                 // samples of an entry
        double reuse_equivalent_spp = 0;  // weight, in samples, of the whole picture's sample with path reuse
        bool direct_in_each_frame = false;
        size_t count() const { return entries.size() / FOCUS_WORDS; }
        uint32_t word(size_t entry, uint32_t which) const { return entries[entry * FOCUS_WORDS + which]; }
        uint32_t first_of(uint64_t pixel) const;
    };
    bool reuses(const kernels::Params& par) const;
    void add(Several several);
    void send(device::Device& device) const;
    void refine(device::Device& device, const kernels::Params& base, const Pass& pass, const Several& several,
                std::vector<float>& rgb);

    std::vector<Several> several_;
    bool path_reuse_ = false;
    std::vector<float> samples_;
    bool found_bad_ = false;
};

}  // namespace render
