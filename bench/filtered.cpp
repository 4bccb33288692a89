// SPDX-License-Identifier: BSD-3-Clause
// filtered OUT N...: writes the sums of a stream of frames from the standard input after N diffuse frames as they are
// (OUT_N_plain.exr) and as PNG files show them (OUT_N_filtered.exr), and the seconds that the filter took.
#include <chrono>
#include <cstdio>
#include <set>
#include <string>

#include "base/error.h"
#include "base/processors.h"
#include "base/run.h"
#include "base/value.h"
#include "display/denoise.h"
#include "film/accumulate.h"
#include "image/stream.h"

namespace {

using Clock = std::chrono::steady_clock;

void write_both(film::Accumulator& sum, const display::HalfSums& halves, const std::string& name) {
    image::Picture picture;
    sum.result(picture, true);
    image::write_file(name + "_plain.exr", picture);
    const Clock::time_point began = Clock::now();
    picture.rgb = display::denoised(halves, picture.frame0, picture.width, picture.height, base::processors());
    std::printf("%s\t%.2f\n", name.c_str(), std::chrono::duration<double>(Clock::now() - began).count());
    picture.sum.clear();  // which the pixels are not of any more
    image::write_file(name + "_filtered.exr", picture);
}

int run(int argc, char** argv) {
    std::set<int64_t> wanted;
    for (int k = 2; k < argc; ++k) wanted.insert(base::to_int(argv[k], "N"));
    image::StreamReader frames("-");
    film::Accumulator sum;
    display::HalfSums halves;
    for (image::Picture frame; frames.next(frame);) {
        sum.add(frame, "stdin");
        if (frame.header.frame == 0) halves.clear(frame.rgb.size());
        else halves.add(frame.rgb);
        if (wanted.count(sum.frames())) write_both(sum, halves, argv[1] + ("_" + std::to_string(sum.frames())));
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    return base::run("filtered", [&] { return run(argc, argv); });
}
