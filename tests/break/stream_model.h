// SPDX-License-Identifier: BSD-3-Clause
// A second reading of our streams (man/luxpipe-stream.5), which shares no line with lib/image: what a mutated stream
// says is decided here, and a tool that ends with status 0 must say the same.  It knows float pictures only, the form
// between our programs; of others it has no opinion.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace breaking {

struct ModelPicture {
    int width = 0, height = 0;
    std::vector<std::string> lines;  // the header without what describes the pixels' storage
    std::optional<int64_t> frame, frames;
    std::optional<uint64_t> seed;
    std::optional<int64_t> last, announced;  // RANGE=a:last; LASTFRAME=
    std::string fingerprint;
    std::vector<double> rgb;  // exposure divided out
};

struct ModelStream {
    std::vector<ModelPicture> pictures;
    enum class End { clean, cut, foreign } end = End::clean;  // cut: inside a picture, or followed by no picture
    bool ends_early() const;                                  // more frames were announced
};

ModelStream read_stream(const std::string& bytes);
std::string write_picture(const ModelPicture& picture);  // as a file of its own

// L'(n) after every frame, paper Eq. 7; nothing where the frames make no sum (order, sizes, seeds, scenes).
struct ModelSum {
    int64_t n = 0, first = 0, last = 0;
    std::vector<double> rgb, scale;  // scale: the size of what was added, for comparing
};
std::optional<std::vector<ModelSum>> sums_of(const std::vector<ModelPicture>& frames);

}  // namespace breaking
