// SPDX-License-Identifier: BSD-3-Clause
// See hours.h.
#include "hours.h"

#include <fmt/core.h>

#include "actions.h"
#include "after.h"
#include "base/progress.h"
#include "base/run.h"
#include "base/shutdown.h"
#include "film/accumulate.h"
#include "frames.h"
#include "image/header.h"
#include "render/hours.h"

std::vector<bool> render_hours(Options opt, size_t i, device::Device& device, const render::ViewPlan& plan,
                               Report& report, const std::vector<render::ActionHours>& actions) {
    std::vector<render::HourSky> hours;
    std::vector<size_t> of;  // of each: its place in opt.skies
    for (size_t sky = 0; sky < opt.skies.size(); sky++)
        if (opt.skies[sky].light && !is_rendered(opt, i, opt.skies[sky]))
            hours.push_back(*opt.skies[sky].light), of.push_back(sky);
    const size_t lit = hours.size();
    std::vector<bool> left(opt.skies.size());
    const std::vector<bool> alone = render::have_images(plan, hours);
    for (size_t k = lit; k-- > 0;)
        if (alone[k]) left[of[k]] = true, hours.erase(hours.begin() + long(k)), of.erase(of.begin() + long(k));
    if (hours.size() < lit)
        base::say(
            fmt::format("ptrace: {} of {} hours are rendered by themselves: a smooth surface shows the eye their "
                        "sun",
                        lit - hours.size(), lit));

    const std::string shared = render::shared_paths(plan);
    size_t next = 0;  // of opt.skies
    const auto dark_ones_before = [&](size_t sky) {
        for (; next < sky; next++) {
            if (!opt.skies[next].is_black() || is_rendered(opt, i, opt.skies[next])) continue;
            image::Picture picture = start_picture(opt, opt.skies[next], i, nullptr);
            picture.header.shared_paths = shared;  // as all of the stream
            write_dark(opt, picture);
            write_dark_actions(opt, picture);
        }
    };
    base::Progress progress("ptrace");
    render::HoursWanted wanted;
    wanted.first = opt.first;
    wanted.last = opt.last;
    wanted.moments = opt.moments;
    wanted.tell = [&](const std::string& doing, double share) {
        if (opt.output.empty() && base::stdout_is_closed()) throw base::ClosedPipe{};  // the first hour may be far
        if (progress.due())
            progress.show(fmt::format("{} hours together: {}, {:.0f} %", hours.size(), doing, 100 * share));
    };
    image::Picture picture;
    film::Accumulator sum;
    const render::GiveAnyFrame give = [&](const render::ActionHours* action, size_t hour, int64_t k,
                                          const std::vector<float>& rgb, const image::Moments& moments) {
        const Sky& sky = opt.skies[of[hour]];
        if (k == opt.first) {
            progress.clear();
            dark_ones_before(of[hour]);
            picture = start_picture(opt, sky, i, &plan);
            picture.header.fingerprint = action ? render::action_fingerprint(action->plans) : plan.fingerprint;
            picture.header.fingerprint += render::hour_part(hours[hour]);
            picture.header.shared_paths = shared;
            if (action) picture.header.action = action->label;
            if (opt.output.empty()) picture.header.last_frame = opt.last;
            report.begin(image::label(picture.header), device.name(), opt.first, opt.last);
        }
        picture.rgb = rgb;
        picture.header.frame = k;
        picture.moments = moments;
        write_frame(opt, picture, sum);
        report.frame(k);
        if (k == opt.last) {
            if (opt.one_picture) write_sum(opt, sum);
            sum = film::Accumulator();
            report.end();
        }
        return !base::shutdown_requested();
    };
    try {
        render::render_hours(device, plan, hours, wanted, actions, give);
    } catch (const device::Cancelled&) {}                      // a signal, before the first hour
    if (opt.one_picture && !sum.empty()) write_sum(opt, sum);  // of an hour cut off
    if (!base::shutdown_requested()) dark_ones_before(opt.skies.size());
    return left;
}
