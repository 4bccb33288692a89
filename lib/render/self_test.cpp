// SPDX-License-Identifier: BSD-3-Clause
// See self_test.h.
#include "render/self_test.h"

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>

#include "base/error.h"
#include "base/hash.h"
#include "base/tempfile.h"
#include "scene/object.h"
#include "render/loaded_scene.h"
#include "render/scene_params.h"
#include "render/view_params.h"

namespace kernels {
#include "kernels/cal/cal_noise.h"
#include "kernels/self_test.h"
}  // namespace kernels

namespace render {
namespace {

using namespace kernels;

// The materials, patterns and lights of most rooms.
const char* const room =
    "void brightfunc grain 2 .6+.3*noise3(3*Px,3*Py,3*Pz) .\n0 0\ngrain plastic wood 0 0 5 .5 .4 .3 .02 .1\n"
    "void plastic white 0 0 5 .8 .8 .8 0 0\nvoid metal steel 0 0 5 .6 .6 .7 .9 .05\nvoid glass pane 0 0 3 .9 .9 .9\n"
    "void light bulb 0 0 3 40 40 30\nbulb sphere lamp 0 0 4 1 3 2.2 .1\n"
    "void light sunlight 0 0 3 2e6 2e6 2e6\nsunlight source sun 0 0 4 .7 -.3 .6 .53\n"
    "void glow sky_glow 0 0 4 9 10 12 0\nsky_glow source sky 0 0 4 0 0 1 180\n"
    "wood polygon floor 0 0 12 0 0 0 4 0 0 4 4 0 0 4 0\nwhite polygon ceiling 0 0 12 0 0 3 0 4 3 4 4 3 4 0 3\n"
    "white polygon left 0 0 12 0 0 0 0 4 0 0 4 3 0 0 3\nwhite polygon back 0 0 12 0 4 0 4 4 0 4 4 3 0 4 3\n"
    "pane polygon window 0 0 12 4 0 0 4 0 3 4 4 3 4 4 0\nsteel sphere ball 0 0 4 2.5 2.5 .6 .6\n";

constexpr uint32_t side = 16, frames = 4;

std::vector<float> render_room(device::Device& device, const scene::Scene& scene) {
    RenderOptions options;
    options.compact_tree = device.compact_tree();
    const LoadedScene loaded = load_scene(scene, options, {});
    const flatten::FlatScene& flat = *loaded.tables;
    device::Params par{params_of(flat, options), nullptr};
    view::View view;
    view.vp = {.4, .3, 1.4};
    view.vd = {.7, .8, -.15};
    view.vh = view.vv = 80;
    par.nx = par.ny = side;
    set_view(par, view, flat.centre);
    device.upload(loaded.tables);
    std::vector<float> rgb, direct;
    par.samples_per_pass = frames;
    par.path_count = side * side * frames;
    par.mode = MODE_DIRECT;
    device.run(par, direct);
    par.mode = MODE_FRAMES;
    par.frame = 1;
    par.reuse_path_count = reuse_paths(side, side);
    device.run(par, rgb);
    rgb.insert(rgb.end(), direct.begin(), direct.end());
    return rgb;
}

bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * 4) == 0;
}

// A single differing bit can change a path, so that a few pixels may differ, but not the sum of all.
bool is_garbage(const std::vector<float>& here, const std::vector<float>& there) {
    constexpr double few = .1, near = 1e-3;
    size_t far = 0;
    double sum = 0, sum_there = 0;
    for (size_t i = 0; i < here.size(); i++) {
        if (!(std::fabs(there[i] - here[i]) <= near * std::fabs(here[i]))) far++;
        sum += double(here[i]), sum_there += double(there[i]);
    }
    return !(double(far) <= few * double(here.size()) && std::fabs(sum_there - sum) <= few * sum);
}

// Operations with other bits; `wrong`: those whose result differs by more than a few roundings.
std::string differing(const std::vector<float>& numbers, std::string& wrong) {
    const char* const operations[SELF_TEST_VALUES] = {"a*b+c", "division",        "square root", "numbers below 1e-38",
                                                      "exp",   "sine and cosine", "pow",         "noise"};
    constexpr float some = 1e-4f;
    std::string others;
    for (uint32_t value = 0; value < SELF_TEST_VALUES; value++) {
        bool other = false, far = false;
        for (uint32_t i = 0; i < SELF_TEST_INPUTS; i++) {
            const float here = self_test_value(i, value), there = numbers[i * SELF_TEST_VALUES + value];
            other = other || std::memcmp(&here, &there, 4) != 0;
            far = far || !(std::fabs(here - there) <= some * (std::fabs(here) + 1) || here == there);
        }
        const auto add = [&](std::string& text) {
            text += (text.empty() ? "" : ", ") + std::string(operations[value]);
        };
        if (other) add(others);
        if (far) add(wrong);
    }
    return others;
}

// Describes the differences; "" if there are none.
std::string compare(const std::string& name, device::Device& device, const scene::Scene& scene) {
    const std::vector<float> here = render_room(*device::make_cpu_device("cpu"), scene),
                             there = render_room(device, scene);
    std::string wrong, others = differing(device.self_test_numbers(SELF_TEST_INPUTS * SELF_TEST_VALUES), wrong);
    errno = 0;
    if (!wrong.empty()) base::fail_system(name, "computes wrongly (" + wrong + "): it is of no use");
    if (is_garbage(here, there)) base::fail_system(name, "renders a test room wrongly: it is of no use");
    return others.empty() && !same_bits(here, there) ? "a test room" : others;
}

}  // namespace

std::string self_test(device::Device& device, const std::string& folder) {
    const std::string name = device.name(), identity = device.identity();
    if (identity.empty()) return "";
    const std::string hash = base::hash_of(identity), remembered = folder + "/luxpipe_" + hash;
    std::string others;
    if (folder.empty() || !std::getline(std::ifstream(remembered), others)) {
        others = compare(name, device, scene::read_scene_text(room, "self-test"));
        if (!folder.empty()) {
            base::TempFile file(remembered);
            file.write((others + "\n").data(), others.size() + 1);
            file.keep();
        }
    }
    if (others.empty()) return "";
    base::warn(name,
               "gives other bits than the processor in " + others + ": ptaccum combines its frames with no others");
    return hash;
}

}  // namespace render
