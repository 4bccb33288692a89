// SPDX-License-Identifier: BSD-3-Clause
// See pixel_text.h.
#include "render/pixel_text.h"

#include <algorithm>
#include <fmt/core.h>

#include "image/grey.h"

namespace render {
namespace {

// In percent of the pixel's luminance.
std::string share(const device::Rgb& rgb, const PixelSums& sums) {
    const double all = image::grey(sums.all);
    return all != 0 ? fmt::format("{:.4g}", 100 * image::grey(rgb) / all) : "0";
}

std::string triple(const device::Rgb& v, const char* between) {
    return fmt::format("{:.8g}{}{:.8g}{}{:.8g}", v[0], between, v[1], between, v[2]);
}

std::string sum_row(const char* of, const std::string& name, const device::Rgb& rgb, const PixelSums& sums) {
    return fmt::format("{}\t{}\t{}\t{}\n", of, name, triple(rgb, "\t"), share(rgb, sums));
}

constexpr size_t most_surfaces = 10;

using Named = std::vector<std::pair<std::string, device::Rgb>>;
Named brightest_first(const std::map<std::string, device::Rgb>& sums) {
    Named all(sums.begin(), sums.end());
    std::stable_sort(all.begin(), all.end(),
                     [](const auto& a, const auto& b) { return image::grey(a.second) > image::grey(b.second); });
    return all;
}

}  // namespace

void PixelSums::add(const PixelRow& row) {
    if (row.light.empty()) return;
    const std::string surface = row.place.empty() ? "(none)" : row.surface + " (" + row.place + ")";
    for (device::Rgb* sum : {&by_light[row.light], &by_surface[surface], &by_bounces[row.bounces], &all})
        for (size_t c = 0; c < 3; c++) (*sum)[c] += row.rgb[c];
}

std::string vertex_table(const std::vector<PixelRow>& rows, const PixelSums& sums) {
    std::string out =
        "frame\tpath\tvertex\tsurface\tmaterial\tplace\tpoint\tlobe\tweight\tbounces\tlight\tred\tgreen\t"
        "blue\tshare\n";
    for (const PixelRow& r : rows)
        out += fmt::format("{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\n", r.frame, r.path, r.vertex, r.surface,
                           r.material, r.place, r.has_point ? triple(r.point, " ") : "", r.lobe, triple(r.weight, " "),
                           r.bounces, r.light, triple(r.rgb, "\t"), share(r.rgb, sums));
    return out;
}

std::string sum_table(const PixelSums& sums) {
    std::string out = "by\tname\tred\tgreen\tblue\tshare\n";
    for (const auto& [name, rgb] : brightest_first(sums.by_light)) out += sum_row("light", name, rgb, sums);
    auto surfaces = brightest_first(sums.by_surface);
    surfaces.resize(std::min(surfaces.size(), most_surfaces));
    for (const auto& [name, rgb] : surfaces) out += sum_row("surface", name, rgb, sums);
    for (const auto& [bounces, rgb] : sums.by_bounces) out += sum_row("bounces", std::to_string(bounces), rgb, sums);
    return out + sum_row("pixel", "", sums.all, sums);
}

std::string moment_table(const MomentReport& report) {
    std::string out = "moment\tlight\tvalue\n";
    for (const auto& [light, variance] : report.variance_by_light)
        out += fmt::format("variance\t{}\t{:.8g}\n", light, variance);
    constexpr const char* names[] = {"variance", "difference", "right", "up"};
    for (size_t i = 0; i < report.moments.size(); i++)
        out += fmt::format("{}\t\t{:.8g}\n", names[i], report.moments[i]);
    return out;
}

}  // namespace render
