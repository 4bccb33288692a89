// SPDX-License-Identifier: BSD-3-Clause
// Hyperspectral pictures: FORMAT=Radiance_spectra, NCOMP=N bands of equal width between the outer two wavelengths of
// WAVELENGTH_SPLITS=, N mantissas and one exponent a pixel.
#pragma once
#include <optional>
#include <string>
#include <vector>
#include "base/open_file.h"

namespace image {

struct SpectralPicture {
    int width = 0, height = 0, bands = 0;
    double from = 0, to = 0;  // nm, where the first band begins and the last one ends
    double pixel_aspect = 1;
    std::vector<float> values;  // row 0 = top, the bands of a pixel together; the exposure is not divided out
};

// Nothing if the file is not such a picture.
std::optional<SpectralPicture> read_spectral_file(const std::string& path, const base::Opener& by = {});

}  // namespace image
