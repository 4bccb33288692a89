// SPDX-License-Identifier: BSD-3-Clause
// See spectral.h.  The scanlines are flat; a value is (byte + 0.5) 2^(exponent - 136), 0 if the exponent byte is 0.
#include "image/spectral.h"
#include <cmath>
#include "base/error.h"
#include "image/stream_parts.h"

namespace image {

namespace {
constexpr int most_bands = 24;
}

std::optional<SpectralPicture> read_spectral_file(const std::string& path, const base::Opener& by) {
    Input in(path, by);
    char start[2];
    if (!in.look(start, 2) || start[0] != '#' || start[1] != '?') return {};
    const Head head = read_head(in, path);
    if (!head.encoding.spectra) return {};
    SpectralPicture p;
    p.width = head.layout.width;
    p.height = head.layout.height;
    p.bands = head.encoding.channels;
    p.pixel_aspect = head.header.pixel_aspect;
    if (p.bands < 4 || p.bands > most_bands)
        base::fail(path, "NCOMP=" + std::to_string(p.bands) + ": hyperspectral pictures have 4 to 24 bands");
    if (!head.encoding.splits) base::fail(path, "a hyperspectral picture needs WAVELENGTH_SPLITS=");
    p.from = head.encoding.splits->front();
    p.to = head.encoding.splits->back();
    if (!(p.from > 0 && p.to > 0) || p.from == p.to) base::fail(path, "WAVELENGTH_SPLITS= spans no wavelengths");

    const bool columns = head.layout.x_major;
    const size_t bytes = size_t(p.bands) + 1, fast = size_t(columns ? p.height : p.width),
                 slow = size_t(columns ? p.width : p.height);
    if (const auto left = in.remaining())
        if (*left < bytes * fast * slow) base::fail(path, "input ends inside the picture");
    std::vector<uint8_t> row(bytes * fast);
    for (size_t s = 0; s < slow; s++) {
        if (in.read(row.data(), row.size()) != row.size()) base::fail(path, "input ends inside the picture");
        for (const uint8_t* pixel = row.data(); pixel < row.data() + row.size(); pixel += bytes) {
            const double scale = pixel[p.bands] ? std::ldexp(1., pixel[p.bands] - 136) : 0;
            for (int k = 0; k < p.bands; k++) p.values.push_back(float((pixel[k] + .5) * scale));
        }
    }
    reorient(p.values, head.layout, size_t(p.bands));
    return p;
}

}  // namespace image
