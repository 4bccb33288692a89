// SPDX-License-Identifier: BSD-3-Clause
// Wavefront .obj files.
#include "fuzz_try.h"
#include <cstdlib>
#include <string>
#include "scene/mesh_formats.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    try_to([&] {
        scene::Mesh mesh;
        base::TextReader in = base::TextReader::from_text({reinterpret_cast<const char*>(data), size}, "fuzz.obj", 1);
        scene::read_obj(in, mesh);
        for (const auto& t : mesh.triangles)
            for (uint32_t v : t.v)
                if (v >= mesh.positions.size()) abort();
    });
    return 0;
}
