// SPDX-License-Identifier: BSD-3-Clause
// See probes.h.
#include "render/probes.h"

#include <algorithm>
#include <cmath>

#include "image/grey.h"
#include "image/picture.h"

namespace render {
using namespace kernels;
using image::grey;

namespace {
constexpr double least_deviation = 20 / image::lumens_per_watt;  // in grey: 20 cd/m2, darker than any glare source
constexpr double least_share = .05;                              // of the mean: below it f is above .9975
constexpr int around = 2;                                        // pixels
}  // namespace

Probes draw_probes(device::Device& device, const ViewPlan& plan) {
    const uint32_t pixels = plan.sampling.params.nx * plan.sampling.params.ny, n = plan.probes,
                   most = std::max(1u, device.preferred_batch_size() / n);
    Probes out;
    out.count = n;
    out.mean.resize(3 * size_t(pixels)), out.half_off.resize(pixels), out.variance.resize(pixels);
    for (uint32_t first = 0; first < pixels; first += most) {
        const uint32_t batch = std::min(most, pixels - first);
        const std::vector<float> rgb = run_pass(device, plan.sampling, {MODE_DIRECT, 0, n, first, batch});
        const float* from = rgb.data();
        for (size_t pixel = first; pixel < first + batch; pixel++) {
            double sum[3] = {0, 0, 0}, sum_grey = 0, squares = 0, off = 0;
            for (uint32_t k = 0; k < n; k++, from += 3) {
                const double y = grey(from);
                for (size_t c = 0; c < 3; c++) sum[c] += double(from[c]);
                sum_grey += y, squares += y * y, off += k < n / 2 ? y : -y;
            }
            for (size_t c = 0; c < 3; c++) out.mean[3 * pixel + c] = float(sum[c] / n);
            out.half_off[pixel] = n % 2 ? 0 : float(off / n);
            out.variance[pixel] = n < 2 ? 0 : float(std::max(0.0, (squares - sum_grey * sum_grey / n) / (n - 1)));
        }
    }
    return out;
}

std::vector<bool> uneven_pixels(const Probes& probes, int nx, int ny) {
    std::vector<bool> uneven(probes.variance.size());
    for (int y = 0; y < ny; y++)
        for (int x = 0; x < nx; x++) {
            const size_t i = size_t(y) * size_t(nx) + size_t(x);
            const double deviation = std::sqrt(double(probes.variance[i]));
            if (deviation < std::max(least_deviation, least_share * grey(&probes.mean[3 * i]))) continue;
            for (int v = std::max(0, y - around); v <= std::min(ny - 1, y + around); v++)
                for (int u = std::max(0, x - around); u <= std::min(nx - 1, x + around); u++)
                    uneven[size_t(v) * size_t(nx) + size_t(u)] = true;
        }
    return uneven;
}

}  // namespace render
