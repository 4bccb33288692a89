// SPDX-License-Identifier: BSD-3-Clause
// Colours of given luminance, and the luminance they have after rounding to float (check_picture.h).
#include "evalglare/check_picture.h"
#include "glare/statistics.h"
#include "glare/threshold.h"
#include "glare/zones.h"

namespace evalglare {

using glare::grey_blue, glare::grey_green, glare::grey_red;

CheckPicture::CheckPicture(const glare::Luminance& lum, bool to_be_seen) : grey_(lum.size()) {
    for (size_t i = 0; i < grey_.size(); ++i) {
        const double f = lum.grey[i];
        grey_[i] = (grey_red * f + grey_blue * f) + grey_green * f;
        if (to_be_seen) rgb_.insert(rgb_.end(), 3, lum.grey[i]);
    }
}

void CheckPicture::paint(size_t pixel, const Paint& paint) {
    const double grey = grey_[pixel];
    const float red = float(paint.red * (1 / grey_red) * grey), green = float(paint.green * (1 / grey_green) * grey),
                blue = float(paint.blue * (1 / grey_blue) * grey);
    grey_[pixel] = (grey_red * red + grey_blue * blue) + grey_green * green;
    if (rgb_.empty()) return;
    rgb_[3 * pixel] = red, rgb_[3 * pixel + 1] = green, rgb_[3 * pixel + 2] = blue;
}

void paint_task(CheckPicture& check, const glare::Geometry& g, const glare::Circle& task) {
    constexpr Paint task_paint{0, 0, 1};
    const base::Vec3 centre = g.direction(task.x, task.y);
    const double limit = glare::inside_cosine(float(task.opening));
    for (size_t i = 0; i < g.omega.size(); ++i)
        if (g.valid(i) && g.inside(dot(centre, g.direction(i)), limit)) check.paint(i, task_paint);
}

void paint_sources(CheckPicture& check, const std::vector<glare::Run>& runs, const Settings& settings) {
    constexpr Paint palette[] = {{0, 1, 0}, {0.15, 0.15, 0.7}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}};
    for (const glare::Run& r : runs)
        for (uint32_t p = r.start; p < r.start + r.length; ++p)
            check.paint(p, settings.source_paint.value_or(palette[r.group % 5]));
}

void paint_band(CheckPicture& check, const std::vector<uint32_t>& pixels) {
    constexpr Paint green{0, 1, 0};
    for (const uint32_t p : pixels) check.paint(p, green);
}

std::vector<float> draw_check_picture(const glare::Reading& reading, const glare::Measurement& m, const Settings& own) {
    const glare::Settings& settings = reading.plan().settings;
    const glare::Geometry& g = reading.geometry();
    glare::Luminance lum = reading.lum;  // as it was measured
    std::vector<float> filled, cut;
    if (settings.fill) filled = fill_rows(lum, g, *settings.fill), lum.grey = filled.data();
    if (settings.field_cut) cut = cut_field(lum, g, settings.field_cut), lum.grey = cut.data();
    CheckPicture check(lum, true);
    if (settings.task && own.task_painted) paint_task(check, g, *settings.task);
    paint_sources(check, settings.zones ? m.runs_before_zones : m.runs, own);
    if (settings.band_rad) paint_band(check, band_pixels(g, *settings.band_rad));
    for (int zone = 1; settings.zones && zone <= 2; ++zone)
        for (const uint32_t p : zone_pixels(g, *settings.zones, zone)) check.paint(p, zone_paint[zone - 1]);
    return check.rgb();
}

}  // namespace evalglare
