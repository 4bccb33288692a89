// SPDX-License-Identifier: BSD-3-Clause
// Input files of rad(1), with one of their views.
#include <cstdint>
#include "fuzz_folder.h"
#include "fuzz_try.h"
#include "scene/rad_input.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    write_alone("t.rif", {reinterpret_cast<const char*>(data), size});
    try_to([] {
        const scene::RadInput input = scene::read_rad_input("t.rif");
        for (const char* name : {"", "1", "a", "XYza"}) try_to([&] { scene::view_words(input, name); });
    });
    return 0;
}
