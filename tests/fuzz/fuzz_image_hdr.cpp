// SPDX-License-Identifier: BSD-3-Clause
// A stream of pictures, RGBE or floats, added up as ptaccum does; a hyperspectral picture.
#include "fuzz_file.h"
#include "fuzz_try.h"
#include "film/accumulate.h"
#include "image/spectral.h"
#include "image/stream.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    FuzzFile file(data, size);
    try_to([&] {
        image::StreamReader in(file.path());
        film::Accumulator sum;
        image::Picture picture;
        while (in.next(picture)) try_to([&] { sum.add(std::move(picture), "fuzz"); });
        if (!sum.empty()) sum.result(picture, true);
    });
    try_to([&] { image::read_spectral_file(file.path()); });
    return 0;
}
