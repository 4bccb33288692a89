// SPDX-License-Identifier: BSD-3-Clause
// How the pixels of a picture are sampled, and samples of them, drawn by a device: one each, or the mean of several for
// pixels of a focus and noisy pixels.
#pragma once
#include <optional>

#include "device/device.h"
#include "render/focus.h"

namespace render {

// Pixels with several samples in each frame, in one pass of the device.
struct Several {
    std::vector<kernels::FocusEntry> entries;  // pixels in ascending order
    uint32_t spp = 0;                          // samples of an entry
    double reuse_equivalent_spp = 0;           // weight, in samples, of the whole picture's sample with path reuse
    std::optional<uint32_t> direct_above;      // own direct samples in frames above this one; none: as all pixels
    uint32_t at = 0;                           // first in ViewTables::focus
};

// The sampling of a picture.
struct PixelSampling {
    device::Params params{};  // of a pass over all pixels
    std::vector<Several> several;
    uint32_t samples_per_frame = 1;  // of each pixel; a frame k >= 1 holds their mean
    bool path_reuse = false;         // in passes over whole pictures (kernels/integrator/path_reuse.h)
};

// The same with more of such pixels.
PixelSampling with_several(PixelSampling sampling, Several several);
PixelSampling with_focus(PixelSampling sampling, const Focus& focus);

// n samples of each of some pixels.
struct Pass {
    uint32_t mode;
    int64_t first_sample;
    uint32_t n, first_pixel, pixels;
};

// Parameters of such a pass; pixels with several samples are not among them.
device::Params params_of_pass(const PixelSampling& sampling, const Pass& pass);
// Number of paths of one sample of the whole picture.
uint32_t path_count(const PixelSampling& sampling);
// The samples of a pixel are consecutive, as are their rays; 3 floats each.
std::vector<float> run_pass(device::Device& device, const PixelSampling& sampling, const Pass& pass);
// One of the paths whose weighted sum is a sample of a pixel.
struct PixelPath {
    device::Params params;  // of a pass with it, or with the square of path reuse that holds it
    uint32_t path;          // its number there
    double weight;
};
// The paths of one sample of run_pass().
std::vector<PixelPath> paths_of_pixel(const PixelSampling& sampling, uint32_t mode, int64_t sample, uint32_t pixel);
// Parameters of the passes of run_places().
device::Params params_of_places(const PixelSampling& sampling, const std::vector<uint32_t>& pixels, uint32_t n,
                                uint32_t redraw);
// n direct samples of each of some pixels, which no frame contains, consecutive.  redraw: 0, or other random numbers
// except for the places of the samples.
std::vector<float> run_places(device::Device& device, const PixelSampling& sampling,
                              const std::vector<uint32_t>& pixels, uint32_t n, uint32_t redraw);
constexpr float brightest_sample = 1e32f;
// Sets samples that are not finite or too large to 0, so that every sum of a million samples is a finite float.  Throws
// Error (system) if half of a pass is affected.
void scrub(std::vector<float>& rgb);

}  // namespace render
