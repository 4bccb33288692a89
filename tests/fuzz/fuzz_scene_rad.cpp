// SPDX-License-Identifier: BSD-3-Clause
// Scene text: primitives, commands, generators, xform.
#include "fuzz_folder.h"
#include "fuzz_try.h"
#include "scene/object.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    scene::Limits limits;
    limits.bytes = 64 << 20;
    limits.copies = 200;
    limits.depth = 8;
    write_alone("t", {reinterpret_cast<const char*>(data), size});
    try_to([&] {
        const scene::Scene s = scene::read_scene({"t"}, {}, limits);
        for (size_t i = 0; i < s.objects.size(); i++) s.material(s.objects[i].modifier);
    });
    return 0;
}
