// SPDX-License-Identifier: BSD-3-Clause
// Reading and writing RADIANCE pictures one after another (man/luxpipe-stream.5), on files and pipes.
#pragma once
#include <memory>
#include <string>
#include "base/open_file.h"
#include "image/file_format.h"
#include "image/picture.h"

namespace image {

// Pictures from one file or stdin ("-").  RGBE (flat, old and new RLE), XYZE, float; all eight orientations.
// A file that is OpenEXR (whatever its name) is one picture.
class StreamReader {
public:
    explicit StreamReader(const std::string& path, Pixels pixels = Pixels::radiance, const base::Opener& by = {});
    ~StreamReader();
    // false at a clean end of input; throws Error on anything cut or malformed (place = path, picture number).
    bool next(Picture& picture);
    int64_t pictures() const;  // read so far
private:
    struct State;
    std::unique_ptr<State> state_;
};

// One picture to stdout by base::write_stdout, flushed: header (lines, SOFTWARE=, VIEW=, SEED=, FRAME=/FRAMES=/RANGE=,
// FORMAT=), size, pixels.
void write_picture_stdout(const Picture& picture, Format format);

// The same as bytes.
std::string picture_bytes(const Picture& picture, Format format);
// A file that appears whole or not at all.
void write_bytes(const std::string& path, const std::string& bytes);

// Whole files: written in the format of their ending, read by their content (file_format.h).
std::string ending_of(const std::string& path);  // ".exr", in small letters
// An Error before the work, not after it: another ending than these, a folder that is not there or not writable.
// `more`: further endings that are right.
void require_writable_ending(const std::string& path, const std::vector<std::string>& more = {});
// One picture; throws Error if there are several.
Picture read_file(const std::string& path, Pixels pixels = Pixels::radiance, const base::Opener& by = {});
void write_file(const std::string& path, const Picture& picture, const WriteOptions& options = {});

}  // namespace image
