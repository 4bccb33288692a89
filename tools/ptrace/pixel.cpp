// SPDX-License-Identifier: BSD-3-Clause
// See pixel.h.
#include "pixel.h"

#include <fmt/core.h>

#include "actions.h"
#include "base/run.h"
#include "render/pixel_text.h"

namespace {

void explain(Session& s, const render::GiveRow& give) {
    const Options& opt = s.run.opt;
    const auto explain_plan = [&](const render::ViewPlan& plan, const render::GiveRow& row) {
        render::explain_pixel(*s.device, plan, s.text.scene, opt.pixel->x, opt.pixel->y, opt.first, opt.last, row);
    };
    if (opt.actions.empty()) return explain_plan(s.plan, give);
    const std::vector<render::ActionPart> parts = plan_action(s, 0, 0);
    for (size_t p = 0; p < parts.size(); p++)
        explain_plan(s.action_plans[0][p], [&](render::PixelRow row) {
            row.path = fmt::format("{}:{}", p + 1, row.path);
            const auto& w = parts[p].weights;
            row.rgb.fill(float(w[0] * row.rgb[0] + w[1] * row.rgb[1] + w[2] * row.rgb[2]));
            give(row);
        });
}

}  // namespace

void write_pixel(Session& s) {
    const Options& opt = s.run.opt;
    std::vector<render::PixelRow> rows;
    render::PixelSums sums;
    const bool one_frame = opt.first == opt.last;
    explain(s, [&](const render::PixelRow& row) {
        sums.add(row);
        const bool is_dark = row.light.empty() && row.frame != opt.first;
        if (one_frame && !is_dark) rows.push_back(row);
    });
    std::string text = one_frame ? vertex_table(rows, sums) + "\n" : "";
    text += sum_table(sums);
    if (opt.first == 0 && opt.moments && opt.actions.empty())
        text +=
            "\n" + moment_table(render::explain_moments(*s.device, s.plan, s.text.scene, opt.pixel->x, opt.pixel->y));
    base::write_stdout(text.data(), text.size());
}
