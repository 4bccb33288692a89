// SPDX-License-Identifier: BSD-3-Clause
// ptaccum - sums the frames of a stream, L'(n) = L(0) + (1/n) sum L(i) (paper Eq. 7), or merges such sums.
// The first picture decides: FRAME= begins a stream of frames, FRAMES= a merge; frames that follow the sums of
// a merge are added to it.  The arithmetic is lib/film/accumulate.h; this file only connects it.  See man/ptaccum.1.
#include <fmt/format.h>

#include "base/error.h"
#include "base/failed_before.h"
#include "base/files_read.h"
#include "base/run.h"
#include "base/shutdown.h"
#include "image/stream.h"
#include "options.h"
#include "output.h"
#include "sums.h"

namespace {

// All pictures of all inputs, one after another.
class Pictures {
public:
    explicit Pictures(const std::vector<std::string>& names) : names_(names) {}
    bool next(image::Picture& picture) {
        for (; at_ < names_.size(); ++at_) {
            if (!reader_) reader_ = std::make_unique<image::StreamReader>(names_[at_]);
            if (reader_->next(picture)) return true;
            reader_.reset();
        }
        return false;
    }
    std::string place() const {  // of the picture just read
        const std::string name = names_[at_] == "-" ? "stdin" : names_[at_];
        return reader_->pictures() > 1 ? fmt::format("{}: picture {}", name, reader_->pictures()) : name;
    }
    std::string name() const { return names_[at_] == "-" ? "stdin" : names_[at_]; }
    size_t input() const { return at_; }  // which of the inputs; the same name may come twice

private:
    const std::vector<std::string>& names_;
    size_t at_ = 0;
    std::unique_ptr<image::StreamReader> reader_;
};

// A sum may be replaced by the sum that it becomes a part of; frames and other pictures would be lost.
void refuse_to_overwrite(const Options& opt) {
    for (const std::string& input : opt.inputs) {
        try {
            base::refuse_to_overwrite(opt.outputs, {input});
        } catch (const base::Error&) {
            image::Picture first;
            if (input == "-" || !image::StreamReader(input).next(first) || !first.header.frames) throw;
        }
    }
}

bool is_frame(const image::Picture& p) { return p.header.frame && !p.header.frames; }

// Adds frames to one sum after another.  Complete frames are kept in the files, also if the rest is wrong.
void sum_frames(Pictures& pictures, image::Picture& frame, Sums&& sums) {
    base::finish_on_signal();
    try {
        do sums.add(frame, pictures.place());
        while (!sums.done() && !base::shutdown_requested() && pictures.next(frame));
        sums.end_stream();
    } catch (const base::ClosedPipe&) {
        // The reader has seen enough; the files still get the last sum.
    } catch (...) {
        sums.break_off();
        sums.end_files();
        throw;
    }
    sums.end_files();
    sums.warn_of_stream_in_file();
}

void merge(const Options& opt, Pictures& pictures, image::Picture& first, const Output& output) {
    image::Picture result, further, last = std::move(first);
    std::string name = pictures.name();
    size_t input = pictures.input();
    int count = 1;
    film::Merger merger(opt.batches);
    const bool plain = !last.header.frames;  // no sum of ours: one such picture is only converted
    // An input may be a stream of growing sums: its last one counts.
    while (pictures.next(further) && !is_frame(further)) {
        ++count;
        if (pictures.input() != input) {
            merger.add(std::move(last), name);
            name = pictures.name();
            input = pictures.input();
        }
        last = std::move(further);
        further = image::Picture();
    }
    const bool frames_follow = is_frame(further);
    if (plain && count == 1 && !frames_follow) {
        result = std::move(last);
    } else {
        merger.add(std::move(last), name);
        result = merger.result();
    }
    if (frames_follow) sum_frames(pictures, further, Sums(opt, output, result, name));
    else output.final_picture(result);
}

}  // namespace

int main(int argc, char** argv) {
    base::mark_failure();
    return base::run("ptaccum", [&] {
        const auto opt = parse_options(argc, argv);
        if (!opt) return 0;
        refuse_to_overwrite(*opt);
        const Output output(*opt, opt->command);
        if (opt->to_stdout) base::ends_with_reader(1);
        Pictures pictures(opt->inputs);
        image::Picture first;
        if (!pictures.next(first)) base::fail("", "no picture to read");
        if (is_frame(first)) sum_frames(pictures, first, Sums(*opt, output));
        else merge(*opt, pictures, first, output);
        return 0;
    });
}
