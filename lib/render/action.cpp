// SPDX-License-Identifier: BSD-3-Clause
// See action.h.
#include "render/action.h"

#include <algorithm>

#include "base/hash.h"
#include "render/progressive.h"
#include "render/sky_light.h"

namespace render {
namespace {

constexpr spectrum::Colour white{1, 1, 1};

std::string hash_of_colours(const flatten::BandColours& c) {
    base::Hash hash;
    for (size_t k = 0; k < 3; k++) hash.add_all(c.bands.light[k]), hash.add_all(c.bands.surface[k]);
    hash.add_all(c.lights.daylight);
    if (c.lights.by_sky) hash.add_all(std::string("by sky"));
    for (const auto& [name, spectrum] : c.lights.lamps) hash.add_all(name), hash.add_all(spectrum);
    return hash.text();
}

// Frames of all pixels that are kept until the last part has them, in floats.
constexpr size_t most_kept = size_t(1) << 28;

// Hours whose light has colours in the bands of a part by daylight.
std::vector<HourSky> in_bands(std::vector<HourSky> hours, const ActionPart& part) {
    const auto tint = [&](const spectrum::Spectrum& s) {
        const spectrum::Colour c = colour_of_light(part.colours->bands, white, s);
        return std::array<float, 3>{float(c[0]), float(c[1]), float(c[2])};
    };
    for (HourSky& hour : hours) {
        const spectrum::SkySpectra s = spectrum::spectra_of(sky_light(hour));
        hour.tint = {tint(s.sun), tint(s.sky), tint(s.ground)};
        hour.tinted = true;
    }
    return hours;
}

// The grey frames of hours, hour by hour.
std::vector<std::vector<float>> action_hours(device::Device& device, const ActionHours& action,
                                             const std::vector<HourSky>& hours, HoursWanted wanted) {
    wanted.moments = false;
    const size_t frames = size_t(wanted.last - wanted.first + 1);
    std::vector<std::vector<float>> sums(hours.size() * frames);
    for (size_t p = 0; p < action.plans.size(); p++) {
        const ActionPart& part = action.parts[p];
        const std::vector<HourSky> light = part.colours->lights.by_sky ? in_bands(hours, part) : hours;
        render_hours(device, action.plans[p], light, wanted, [&](size_t hour, int64_t k, const auto& rgb, const auto&) {
            add_part(part, rgb, sums[hour * frames + size_t(k - wanted.first)]);
            return true;
        });
    }
    return sums;
}

}  // namespace

std::vector<ActionPart> parts_of(const spectrum::Action& action, int bands, const flatten::LightSpectra& lights) {
    const double* w = image::luminance_weights;
    std::vector<ActionPart> parts;
    for (const spectrum::Bands& b : spectrum::bands_of(action, bands)) {
        auto colours = std::make_shared<flatten::BandColours>(flatten::BandColours{b, lights, ""});
        colours->name = hash_of_colours(*colours);
        parts.push_back({std::move(colours), {w[0], w[1], w[2]}});
    }
    return parts;
}

std::vector<ActionPart> parts_by_daylight(std::vector<ActionPart> parts) {
    for (ActionPart& part : parts) {
        auto colours = std::make_shared<flatten::BandColours>(*part.colours);
        const spectrum::Colour daylight = colour_of_light(colours->bands, white, colours->lights.daylight);
        for (size_t k = 0; k < 3; k++) {
            if (daylight[k] <= 0) continue;
            for (double& v : colours->bands.light[k]) v /= daylight[k];
            part.weights[k] *= daylight[k];
        }
        colours->name = hash_of_colours(*colours);
        part.colours = std::move(colours);
    }
    return parts;
}

Setup in_bands(Setup setup, const ActionPart& part) {
    RenderOptions& o = setup.options;
    o.bands = part.colours;
    const spectrum::Bands& bands = part.colours->bands;
    const auto replace = [](double* rgb, const spectrum::Colour& c) { std::copy(c.begin(), c.end(), rgb); };
    const auto rgb_of = [](const double* v) { return spectrum::Colour{v[0], v[1], v[2]}; };
    replace(o.av, colour_of_light(bands, rgb_of(o.av), part.colours->lights.daylight));
    replace(o.me, colour_of_surface(bands, rgb_of(o.me)));
    replace(o.ma, colour_of_surface(bands, rgb_of(o.ma)));
    return setup;
}

void add_part(const ActionPart& part, const std::vector<float>& rgb, std::vector<float>& grey) {
    grey.resize(rgb.size() / 3);
    const auto& w = part.weights;
    for (size_t i = 0; i < grey.size(); i++)
        grey[i] += float(w[0] * rgb[3 * i] + w[1] * rgb[3 * i + 1] + w[2] * rgb[3 * i + 2]);
}

std::vector<float> as_rgb(const std::vector<float>& grey) {
    std::vector<float> rgb(3 * grey.size());
    for (size_t i = 0; i < rgb.size(); i++) rgb[i] = grey[i / 3];
    return rgb;
}

void render_action(device::Device& device, const std::vector<ActionPart>& parts, const std::vector<ViewPlan>& plans,
                   int64_t first, int64_t count, const GiveSum& give) {
    const size_t pixels = size_t(plans[0].nx) * size_t(plans[0].ny);
    const int64_t at_once = std::max<int64_t>(1, int64_t(most_kept / std::max<size_t>(pixels, 1)));
    for (int64_t done = 0, n; done < count; done += n) {
        n = std::min(at_once, count - done);
        std::vector<std::vector<float>> sums(static_cast<size_t>(n));
        bool goes_on = true;
        for (size_t p = 0; p < plans.size(); p++) {
            const bool is_last = p + 1 == plans.size();
            render_frames(device, plans[p], first + done, n, false, [&](int64_t k, const auto& rgb, const auto&) {
                std::vector<float>& sum = sums[size_t(k - first - done)];
                add_part(parts[p], rgb, sum);
                if (is_last) goes_on = give(k, as_rgb(sum));
                if (is_last) std::vector<float>().swap(sum);
                return goes_on;
            });
        }
        if (!goes_on) return;
    }
}

void render_hours(device::Device& device, const ViewPlan& plan, const std::vector<HourSky>& hours,
                  const HoursWanted& wanted, const std::vector<ActionHours>& actions, const GiveAnyFrame& give) {
    const size_t frames = size_t(wanted.last - wanted.first + 1), pixels = size_t(plan.nx) * size_t(plan.ny);
    const size_t at_once = std::max<size_t>(1, most_kept / std::max<size_t>(1, pixels * frames * actions.size()));
    bool goes_on = true;
    for (size_t done = 0; done < hours.size() && goes_on; done += at_once) {
        const std::vector<HourSky> some(hours.begin() + long(done),
                                        hours.begin() + long(std::min(done + at_once, hours.size())));
        std::vector<std::vector<std::vector<float>>> kept;
        for (const ActionHours& action : actions) kept.push_back(action_hours(device, action, some, wanted));
        render_hours(device, plan, some, wanted, [&](size_t hour, int64_t k, const auto& rgb, const auto& moments) {
            goes_on = give(nullptr, done + hour, k, rgb, moments);
            for (size_t a = 0; k == wanted.last && a < actions.size(); a++)
                for (size_t f = 0; f < frames && goes_on; f++)
                    goes_on = give(&actions[a], done + hour, wanted.first + int64_t(f),
                                   as_rgb(kept[a][hour * frames + f]), {});
            return goes_on;
        });
    }
}

std::string action_fingerprint(const std::vector<ViewPlan>& plans) {
    base::Hash hash;
    for (const ViewPlan& plan : plans) hash.add_all(plan.fingerprint);
    const std::string& first = plans[0].fingerprint;
    return "scene:" + hash.text() + first.substr(std::min(first.find(' '), first.size()));
}

}  // namespace render
