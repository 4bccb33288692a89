// SPDX-License-Identifier: BSD-3-Clause
// A picture for bench/vcmetrics.sh: bright_discs size count > picture.hdr
// `count` discs of 7000 cd/m2, 2 degrees wide and 5 or more apart, before a noisy background of about 100; flat RGBE.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

int main(int argc, char** argv) {
    const int size = argc > 1 ? std::atoi(argv[1]) : 1024, count = argc > 2 ? std::atoi(argv[2]) : 300;
    if (size < 16 || size > 32768 || count < 0) return 1;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> u(-1, 1);
    struct Disc {
        double x, y;
    };
    std::vector<Disc> discs;
    for (long tries = 0; int(discs.size()) < count && tries < 1000000; ++tries) {
        const Disc d{u(random), u(random)};
        bool free = std::hypot(d.x, d.y) < 0.95;
        for (const Disc& o : discs) free = free && std::hypot(d.x - o.x, d.y - o.y) > 5 / 90.;
        if (free) discs.push_back(d);
    }
    std::vector<unsigned char> pixels(4 * size_t(size) * size);
    for (size_t i = 0; i < pixels.size(); i += 4) {  // mantissa / 256 * 2^(128 - 128), times 179
        pixels[i] = pixels[i + 1] = pixels[i + 2] = (unsigned char)(128 + 40 * u(random));
        pixels[i + 3] = 128;
    }
    const int r = std::max(1, size / 180);
    for (const Disc& d : discs) {
        const int cx = int((d.x + 1) / 2 * size), cy = int((d.y + 1) / 2 * size);
        for (int y = std::max(0, cy - r); y <= std::min(size - 1, cy + r); ++y)
            for (int x = std::max(0, cx - r); x <= std::min(size - 1, cx + r); ++x)
                if (std::hypot(x - cx, y - cy) <= r) {
                    unsigned char* p = &pixels[4 * (size_t(y) * size + x)];
                    p[0] = p[1] = p[2] = 156;
                    p[3] = 134;
                }
    }
    std::printf(
        "#?RADIANCE\nVIEW= -vta -vp 0 0 0 -vd 0 1 0 -vu 0 0 1 -vh 180 -vv 180\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n",
        size, size);
    return std::fwrite(pixels.data(), 1, pixels.size(), stdout) == pixels.size() ? 0 : 1;
}
