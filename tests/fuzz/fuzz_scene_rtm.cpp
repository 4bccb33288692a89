// SPDX-License-Identifier: BSD-3-Clause
// Compiled meshes, from the number after the header on.
#include "fuzz_try.h"
#include <cstdlib>
#include <string>
#include "scene/mesh_formats.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    std::string text = "#?RADIANCE\nFORMAT=Radiance_tmesh\n\n";
    text.append(reinterpret_cast<const char*>(data), size);
    scene::Limits limits;
    limits.bytes = 64 << 20;
    try_to([&] {
        scene::Mesh mesh;
        base::TextReader in = base::TextReader::from_text(text, "fuzz.rtm", 1);
        scene::read_rtm(in, limits, mesh);
        for (const auto& t : mesh.triangles)
            for (uint32_t v : t.v)
                if (v >= mesh.positions.size()) abort();
    });
    return 0;
}
