// SPDX-License-Identifier: BSD-3-Clause
// Region files, rasterized into a small fisheye view.
#include "region/region.h"
#include "fuzz_folder.h"
#include "fuzz_try.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    write_alone("t.regions", {reinterpret_cast<const char*>(data), size});
    view::View v;
    v.type = 'a';
    v.vh = v.vv = 180;
    try_to([&] { region::rasterize(region::read("t.regions"), v, 12, 12, size & 1); });
    return 0;
}
