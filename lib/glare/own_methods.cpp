// SPDX-License-Identifier: BSD-3-Clause
// luxpipe's own way to look at pictures (measure.h).
#include "glare/measure.h"
#include "glare/threshold.h"

namespace glare {
namespace {

double reference(const Luminance& lum, const Geometry& g, const Settings& settings, double mean_lum) {
    return settings.task ? task_luminance(lum, g, *settings.task) : mean_lum;
}

}  // namespace

Methods own_methods() {
    const auto geometry = [](const view::View& view, const std::string&) {
        return std::make_unique<ViewGeometry>(view);
    };
    const auto nothing_left = [](double rest, double whole) { return rest < 1e-11 * whole; };
    const auto light = [](const Luminance& lum, const Geometry& g, const Settings&) { return photometry(lum, g); };
    const auto sources = [](const Geometry& geometry, const Settings& settings) -> FindSources {
        const auto components =
            std::make_shared<const ConnectedComponents>(geometry, double(float(settings.search_opening)) / 2);
        return [=](const Luminance& lum, const Luminance& classification_image, const Geometry& g, double threshold,
                   const PixelSets& sets) {
            return find_sources(lum, classification_image, g, *components, settings, threshold, sets);
        };
    };
    return {geometry, light, reference, sources, nothing_left};
}

}  // namespace glare
