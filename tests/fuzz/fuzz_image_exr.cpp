// SPDX-License-Identifier: BSD-3-Clause
// OpenEXR: as a picture and as a set of masks.
#include "fuzz_folder.h"
#include "fuzz_try.h"
#include "image/exr.h"
#include "image/masks.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    write_alone("p.exr", {reinterpret_cast<const char*>(data), size});
    try_to([&] { image::read_exr("p.exr"); });
    try_to([&] { image::read_masks("p.exr"); });
    return 0;
}
