// SPDX-License-Identifier: BSD-3-Clause
// The rows of explain_pixel() as text for people and awk: tables with tabs, a header row each, an empty line between.
#pragma once
#include <map>
#include "render/pixel_report.h"

namespace render {

// Contributions of a pixel, summed.
struct PixelSums {
    std::map<std::string, device::Rgb> by_light, by_surface;  // where the light arrived, with its place
    std::map<uint32_t, device::Rgb> by_bounces;
    device::Rgb all{};
    void add(const PixelRow& row);
};

std::string vertex_table(const std::vector<PixelRow>& rows, const PixelSums& sums);
std::string sum_table(const PixelSums& sums);
std::string moment_table(const MomentReport& report);

}  // namespace render
