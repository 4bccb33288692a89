// SPDX-License-Identifier: BSD-3-Clause
// Mask pictures of regions: PNG, RADIANCE or OpenEXR by the first byte.
#include "region/picture.h"
#include "fuzz_folder.h"
#include "fuzz_try.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    if (size < 1) return 0;
    region::Shape shape{};
    shape.kind = region::Kind::mask;
    shape.text = data[0] == 0x89 ? "m.png" : data[0] == '#' ? "m.hdr" : "m.exr";
    shape.place = "fuzz";
    write_alone(shape.text.c_str(), {reinterpret_cast<const char*>(data), size});
    try_to([&] { region::resample(region::read_mask_picture(shape), 5, 5); });
    return 0;
}
