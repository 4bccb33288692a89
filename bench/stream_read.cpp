// SPDX-License-Identifier: BSD-3-Clause
// How many 512 x 512 float pictures a second image::StreamReader takes from a pipe, and what one sum (paper Eq. 7)
// costs.  A child process writes the same ready-made bytes, so that reading is what is measured.
// Usage: bench_stream_read [pictures, default 300]
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "film/accumulate.h"
#include "image/stream.h"

static double seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

int main(int argc, char** argv) {
    const int pictures = argc > 1 ? std::atoi(argv[1]) : 300;
    image::Picture p;
    p.width = p.height = 512;
    p.rgb.assign(3 * 512 * 512, 1.5f);
    p.header.view = view::View();
    p.header.frame = 0;
    const std::string bytes = image::picture_bytes(p, image::Format::flt);

    int ends[2];
    if (pipe(ends) != 0) return 2;
    const pid_t writer = fork();
    if (writer == 0) {
        close(ends[0]);
        for (int k = 0; k < pictures; ++k)
            for (size_t at = 0; at < bytes.size();) {
                const ssize_t n = write(ends[1], bytes.data() + at, bytes.size() - at);
                if (n <= 0) _exit(1);
                at += size_t(n);
            }
        _exit(0);
    }
    close(ends[1]);
    dup2(ends[0], 0);
    image::StreamReader in("-");
    double start = seconds();
    int read = 0;
    for (image::Picture q; in.next(q);) ++read;
    std::printf("reading   %7.0f pictures/s (%d of %zu bytes)\n", read / (seconds() - start), read, bytes.size());
    waitpid(writer, nullptr, 0);

    film::Accumulator sum;
    image::Picture out;
    start = seconds();
    for (int k = 0; k < pictures; ++k) {
        p.header.frame = k;
        sum.add(p, "frame");
        sum.result(out, false);
    }
    std::printf("summing   %7.0f frames/s (each with its result)\n", pictures / (seconds() - start));
    return 0;
}
