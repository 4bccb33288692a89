// SPDX-License-Identifier: BSD-3-Clause
// See pixel.h.
#include "pixel.h"

#include "base/run.h"
#include "render/pixel_text.h"

void write_pixel(const Options& opt, device::Device& device, const render::ViewPlan& plan, const scene::Scene& scene) {
    std::vector<render::PixelRow> rows;
    render::PixelSums sums;
    const bool one_frame = opt.first == opt.last;
    render::explain_pixel(device, plan, scene, opt.pixel->x, opt.pixel->y, opt.first, opt.last,
                          [&](const render::PixelRow& row) {
                              sums.add(row);
                              const bool is_dark = row.light.empty() && row.frame != opt.first;
                              if (one_frame && !is_dark) rows.push_back(row);
                          });
    std::string text = one_frame ? vertex_table(rows, sums) + "\n" : "";
    text += sum_table(sums);
    if (opt.first == 0 && opt.moments)
        text += "\n" + moment_table(render::explain_moments(device, plan, scene, opt.pixel->x, opt.pixel->y));
    base::write_stdout(text.data(), text.size());
}
