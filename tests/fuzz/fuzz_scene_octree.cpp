// SPDX-License-Identifier: BSD-3-Clause
// Octrees (a frozen header is put in front, so that most of the search is behind it).
#include "fuzz_folder.h"
#include "fuzz_try.h"
#include "scene/object.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    scene::Limits limits;
    limits.bytes = 64 << 20;
    limits.copies = 200;
    limits.depth = 8;
    std::string text = "#?RADIANCE\nFORMAT=Radiance_octree\n\n";
    text.append(reinterpret_cast<const char*>(data), size);
    write_alone("t", text);
    try_to([&] {
        const scene::Scene s = scene::read_scene({"t"}, {}, limits);
        for (size_t i = 0; i < s.objects.size(); i++) s.material(s.objects[i].modifier);
    });
    return 0;
}
