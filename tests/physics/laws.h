// SPDX-License-Identifier: BSD-3-Clause
// What the tests of laws share: a scene typed in the test, the devices there are, and "agrees within k standard
// errors".
#pragma once
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "base/tempfile.h"
#include "base/warnings.h"
#include "scene/object.h"
#include "device/device.h"
#include "unit/trace_ray.h"

namespace laws {

constexpr double pi = 3.14159265358979323846;

inline std::vector<std::string> devices() {
    std::vector<std::string> names = {"cpu"};
    if (!device::opencl_devices().empty()) names.push_back("opencl");
    return names;
}

inline scene::Scene scene_of(const std::string& text) {
    base::TempFile file((std::filesystem::temp_directory_path() / "luxpipe_law.rad").string());
    std::ofstream(file.path()) << text;
    return scene::read_scene({file.path()}, {});
}

// One ray into a scene, `samples` samples: every channel must lie within 4 standard errors (and single precision) of
// the closed form.  The standard error itself must be small, or the test could not fail.
struct Ray {
    double origin[3], dir[3];
};

inline void expect(const std::string& text, const render::RenderOptions& options, const Ray& ray,
                   const std::vector<double>& exact, long samples = 16384, double largest_error = .01) {
    const scene::Scene scene = scene_of(text);
    for (const std::string& device : devices()) {
        CAPTURE(device);
        render::Renderer renderer(scene, view::View(), 1, 1, options, device, {});
        const auto value = trace_ray(renderer, ray.origin, ray.dir, samples);
        for (size_t c = 0; c < 3; ++c) {
            CAPTURE(c);
            const double want = exact[exact.size() == 3 ? c : 0];
            CAPTURE(want);
            CAPTURE(value.mean[c]);
            CAPTURE(value.error[c]);
            CHECK(std::abs(value.mean[c] - want) <= 4 * value.error[c] + 2e-5 * want);
            CHECK(value.error[c] <= largest_error * want);
        }
    }
}

// Without bounces, without ambient value: what -ab 0 shows.
inline render::RenderOptions direct_only() {
    render::RenderOptions options;
    options.ab = 0;
    return options;
}

}  // namespace laws
