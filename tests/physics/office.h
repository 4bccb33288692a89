// SPDX-License-Identifier: BSD-3-Clause
// The example's office for tests of frames, and sums of them.
#pragma once
#include "film/accumulate.h"
#include "physics/laws.h"
#include "view/view.h"

namespace laws {

inline const std::string office_folder = LUXPIPE_TESTS "/../examples/scenes/office/";

struct Office {
    base::ReadOptions files;
    scene::Scene scene;
    view::View view = view::read_view_file(office_folder + "view.vf");
    explicit Office(const std::vector<std::string>& parts = {"materials", "layout", "sky_1400"}) {
        files.raypath = {"."};
        std::vector<std::string> names;
        for (const std::string& part : parts) names.push_back(office_folder + part + ".rad");
        scene = scene::read_scene(names, files);
    }
    render::Renderer renderer(const std::string& device, int size, const render::RenderOptions& options = {}) const {
        return {scene, view, size, size, options, device, files};
    }
};

inline double luminance_sum(const std::vector<float>& rgb) {
    double sum = 0;
    for (size_t i = 0; i < rgb.size(); i += 3) sum += .265 * rgb[i] + .670 * rgb[i + 1] + .065 * rgb[i + 2];
    return sum;
}

inline image::Picture picture(const std::vector<float>& rgb, int size, int64_t k) {
    image::Picture p;
    p.width = p.height = size;
    p.rgb = rgb;
    p.header.seed = 1;
    p.header.frame = k;
    return p;
}

inline image::Picture sum_of(render::Renderer& renderer, int size, int64_t first, int64_t last) {
    film::Accumulator sum;
    renderer.frames(first, int(last - first + 1), [&](int64_t k, const std::vector<float>& rgb, const image::Moments&) {
        sum.add(picture(rgb, size, k), "test");
        return true;
    });
    image::Picture out;
    sum.result(out, true);
    return out;
}

}  // namespace laws
