// SPDX-License-Identifier: BSD-3-Clause
// Outputs of ptaccum's pictures: the files of -o, or without -o the standard output; "-o -" is the latter, too.
// A stream of sums is float; a picture by itself is RGBE, which every program of the RADIANCE family reads, unless it
// is a partial sum, which is not yet a picture and may be negative.
#pragma once
#include <string>
#include "image/picture.h"
#include "options.h"

class Output {
public:
    Output(const Options& options, std::string command);
    bool to_stdout() const { return options_.to_stdout; }
    // Nothing is written to a standard output that is a pipe: someone may wait for it in vain.
    bool leaves_a_pipe() const { return leaves_a_pipe_; }

    // A stream of several pictures goes to several files: throws Error where a file has no %s for their names.
    void require_names_for(const image::Header& header) const;

    // These sign the picture: every output carries its history.
    void stream_picture(image::Picture& picture) const;  // to the standard output, one of several
    void stdout_picture(image::Picture& picture) const;  // to the standard output, by itself
    // Each whole or not at all.  Passing ones will be written again: OpenEXR without compression, which takes most of
    // the time.
    // filtered: what PNG files show; null: the picture's pixels.
    void files(image::Picture& picture, bool passing, const std::vector<float>* filtered = nullptr) const;
    void final_picture(image::Picture& picture) const;  // to all outputs

private:
    image::Format format_of(const image::Picture& picture) const;
    void sign(image::Picture& picture) const;
    void write_files(const image::Picture& picture, bool passing, const std::vector<float>* filtered) const;
    const Options& options_;
    std::string command_;
    bool leaves_a_pipe_ = false;
};
