// SPDX-License-Identifier: BSD-3-Clause
// A run of ptaccum over frames: the growing sum, written as often as -every says, so that it can be watched and
// measured while it grows, and is not lost when the program is killed.
#pragma once
#include <chrono>
#include <string>
#include "base/progress.h"
#include "film/accumulate.h"
#include "film/block_error.h"
#include "display/denoise.h"
#include "output.h"

class Sums {
public:
    Sums(const Options& options, const Output& output);
    // Goes on from a sum made before.
    Sums(const Options& options, const Output& output, const image::Picture& sum, const std::string& name);
    void add(const image::Picture& frame, const std::string& place);
    bool done() const;  // -until: blocks are certain enough
    void end_stream();  // the last sum to the standard output, if it is not there yet
    void end_files();   // likewise to the files
    // The frames are refused.  A stream of sums that promises no more would seem whole to its reader, which does not
    // know of our status: it gets a header that breaks off.
    void break_off();
    // RADIANCE's habit is "> x.hdr", and some programs take the float pixels of such a file for others.
    void warn_of_stream_in_file() const;

private:
    using Clock = std::chrono::steady_clock;
    void write_due();
    void take_sum(bool with_parts);  // into result_
    void stream_sum(bool by_itself);
    void write_files(bool passing);
    bool can_filter() const;
    const Options& options_;
    const Output& output_;
    film::Accumulator sum_;
    image::Picture result_;
    film::Schedule schedule_;
    film::BlockError blocks_;                   // with -until
    std::optional<image::GrowingParts> parts_;  // for OpenEXR files
    film::Schedule of_parts_ = film::Schedule::parse("x2/16", "");
    bool filters_;              // PNG files are asked for, and all frames come through here
    display::HalfSums halves_;  // where it does
    base::Progress progress_{"ptaccum"};
    bool moments_streamed_ = false;        // moments of this sum: written behind its first picture
    bool streamed_ = true, filed_ = true;  // the last sum is written there for good
    bool seems_whole_ = false;             // the stream of sums, to a reader that finds its end here
    Clock::time_point files_again_;        // without -every: the earliest time for the files' next writing
};
