// SPDX-License-Identifier: BSD-3-Clause
// A renderer without cost: frames 0 to last of a stream made of few, `frame_stream file last`.  The file's frames above
// 0 come again and again, each time with the number that is due.  The reader of the pipe is what is measured.
#include <cstdlib>
#include <vector>

#include "base/error.h"
#include "base/run.h"
#include "image/stream.h"

int main(int argc, char** argv) {
    return base::run("frame_stream", [&] {
        if (argc != 3) base::fail("", "usage: frame_stream file last");
        std::vector<image::Picture> frames(1);
        for (image::StreamReader in(argv[1]); in.next(frames.back());) frames.emplace_back();
        frames.pop_back();
        if (frames.size() < 2) base::fail(argv[1], "has no frame above 0");

        const int64_t last = std::atol(argv[2]);
        for (int64_t k = 0; k <= last; ++k) {
            image::Picture& p = frames[k == 0 ? 0 : 1 + size_t(k - 1) % (frames.size() - 1)];
            p.header.frame = k;
            p.header.last_frame = last;
            image::write_picture_stdout(p, image::Format::flt);
        }
        return 0;
    });
}
