// SPDX-License-Identifier: BSD-3-Clause
// Whatever scene text can be read: flattened, its trees built, a few pixels traced.
#include "fuzz_folder.h"
#include "fuzz_try.h"
#include "scene/object.h"
#include "unit/trace_ray.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    scene::Limits limits;
    limits.bytes = 16 << 20;
    limits.copies = 50;
    limits.depth = 4;
    write_alone("t", {reinterpret_cast<const char*>(data), size});
    try_to([&] {
        const scene::Scene s = scene::read_scene({"t"}, {}, limits);
        if (s.objects.size() > 500) return;
        render::RenderOptions options;
        options.ab = 2;
        view::View v;
        v.type = 'a';
        v.vh = v.vv = 180;
        v.vp = {.1, -2, .3};
        render::Renderer renderer(s, v, 2, 2, options, "cpu:baseline", {});
        const double origin[3] = {.1, .2, 5}, dir[3] = {0, 0, -1};
        trace_ray(renderer, origin, dir, 8);
    });
    return 0;
}
