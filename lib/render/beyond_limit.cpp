// SPDX-License-Identifier: BSD-3-Clause
// See beyond_limit.h.
#include "render/beyond_limit.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>

#include "base/error.h"
#include "base/warnings.h"
#include "image/picture.h"
#include "render/options.h"

namespace render {
namespace {

constexpr int paths_across = 48;                    // paths across the picture, and up
constexpr uint32_t sample_number = (3u << 30) + 2;  // which no frame uses
constexpr double least_told = .001;                 // share of the illuminance

// Share of the illuminance at the eye that each unit of radiance of a pixel adds; row 0 = top.
std::vector<double> eye_weights(const view::View& view, int nx, int ny) {
    const view::Projector projector(view);
    std::vector<double> weights;
    for (int row = 0; row < ny; row++)
        for (int i = 0; i < nx; i++) {
            const int j = ny - 1 - row;
            const auto dir = projector.direction((i + .5) / nx, (j + .5) / ny);
            weights.push_back(dir ? view::pixel_solid_angle(projector, i, j, nx, ny) *
                                        std::max(0., dot(*dir, projector.forward()))
                                  : 0);
        }
    return weights;
}

std::vector<float> pilot_light(device::Device& device, const device::Params& par) {
    std::vector<float> rgb;
    device.run(par, rgb);
    for (float& value : rgb)
        if (!(std::fabs(value) < 1e18f)) value = 0;
    return rgb;
}

// Share of the illuminance without a limit, and its standard error.
struct LeftOut {
    double share = 0, error = 0;
};

LeftOut light_beyond_limit(device::Device& device, const device::Params& base, const view::View& view,
                           const std::vector<float>& exact) {
    double all = 0, left_out = 0, squares = 0;
    std::vector<double> weights = eye_weights(view, int(base.nx), int(base.ny));
    for (size_t i = 0; i < exact.size(); i += 3) all += weights[i / 3] * image::luminance(&exact[i]);

    device::Params par = base;
    par.mode = MODE_FRAMES;
    par.frame = sample_number;
    par.skip_direct_below = 0;  // direct light, too
    par.nx = par.ny = paths_across;
    par.first = 0;
    par.path_count = paths_across * paths_across;
    const std::vector<float> limited = pilot_light(device, par);
    par.ab = no_limit;
    const std::vector<float> unlimited = pilot_light(device, par);
    weights = eye_weights(view, paths_across, paths_across);
    for (size_t i = 0; i < weights.size(); i++) {
        const double light = weights[i] * image::luminance(&unlimited[3 * i]),
                     beyond = light - weights[i] * image::luminance(&limited[3 * i]);
        all += light;
        left_out += beyond;
        squares += beyond * beyond;
    }
    return all > 0 ? LeftOut{left_out / all, std::sqrt(squares) / all} : LeftOut{};
}

}  // namespace

void warn_of_limit(device::Device& device, const device::Params& base, const view::View& view,
                   const std::vector<float>& exact) {
    if (base.ab == no_limit || base.ab == 0 || !base::warnings_are_shown()) return;
    const LeftOut beyond = light_beyond_limit(device, base, view, exact);
    if (beyond.share < least_told) return;
    base::warn(fmt::format("-ab {}", base.ab),
               fmt::format("leaves out {:.2g} +- {:.1g} % of the illuminance at the eye", 100 * beyond.share,
                           100 * beyond.error));
}

}  // namespace render
