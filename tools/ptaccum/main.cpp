// SPDX-License-Identifier: BSD-3-Clause
// ptaccum - sums the frames of a stream, L'(n) = L(0) + (1/n) sum L(i) (paper Eq. 7), or merges such sums.
// What the first picture is decides: FRAME= begins a stream of frames, FRAMES= a merge.  The arithmetic is
// lib/image/accumulate.h; this file only connects it.  See man/ptaccum.1.
#include <fmt/format.h>

#include "base/error.h"
#include "base/progress.h"
#include "base/run.h"
#include "image/exr.h"
#include "image/header.h"
#include "image/stream.h"
#include "options.h"

namespace {

// All pictures of all inputs, one after another.
class Source {
public:
    explicit Source(const std::vector<std::string>& names) : names_(names) {}
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

class Output {
public:
    Output(const Options& opt, std::string command)
        : opt_(opt), command_(std::move(command)), to_terminal_(base::stdout_is_terminal()) {
        if (to_terminal_ && opt.outputs.empty())
            base::fail("stdout", "is a terminal: pictures go to a pipe, a file or -o file");
    }
    // Every output carries its history: call it once, before the two below.
    void sign(image::Picture& picture) const { image::add_history(picture.header, command_); }
    void to_stream(const image::Picture& picture) const {
        if (!to_terminal_) image::write_picture_stdout(picture, opt_.stream_format);
    }
    void to_files(const image::Picture& picture) const {
        for (const std::string& name : opt_.outputs) {
            const std::string ending = image::ending_of(name);
            if (ending == ".exr") image::write_exr(name, picture, exr_options());
            else if (ending == ".png") image::write_png(name, picture, opt_.tone);
            else image::write_file(name, picture, opt_.hdr_format);
        }
    }
    bool only_files() const { return to_terminal_; }

private:
    image::ExrOptions exr_options() const {
        image::ExrOptions e;
        e.half = opt_.half;
        return e;
    }
    const Options& opt_;
    std::string command_;
    bool to_terminal_;
};

void sum_frames(const Options& opt, Source& source, image::Picture& frame, const Output& output) {
    image::Accumulator sum;
    image::Picture result;
    image::Schedule schedule = opt.schedule;
    base::Progress progress("ptaccum");
    bool pending = false;  // the last sum is not written yet
    const auto write = [&] {
        sum.result(result, false);
        output.sign(result);
        output.to_stream(result);
        pending = false;
    };
    try {
        do {
            if (frame.header.frame == 0) {
                if (pending) write();  // the last picture of the scene before
                schedule.restart();
            }
            sum.add(frame, source.place());
            pending = true;
            if (base::stdout_is_closed()) throw base::ClosedPipe{};  // not only at the next write, which may be far
            if (!opt.last_only && !output.only_files() && schedule.due(sum.frames())) write();
            if (progress.due()) progress.show(fmt::format("{} frames", sum.frames()));
        } while (source.next(frame));
        if (pending) write();
    } catch (const base::ClosedPipe&) {
        // The reader has what it wants; the files still get the last sum.
    }
    progress.clear();
    if (opt.outputs.empty()) return;
    sum.result(result, true);
    output.sign(result);
    output.to_files(result);
}

void merge(const Options& opt, Source& source, image::Picture& picture, const Output& output) {
    image::Picture result;
    std::string name = source.name();
    size_t input = source.input();
    int pictures = 1;
    image::Merger merger;
    image::Picture last = std::move(picture);
    const bool plain = !last.header.frames;  // no sum of ours: one such picture is only converted
    // An input may be a stream of growing sums: its last one counts.
    for (image::Picture further; source.next(further); ++pictures) {
        if (source.input() != input) {
            merger.add(std::move(last), name);
            name = source.name();
            input = source.input();
        }
        last = std::move(further);
        further = image::Picture();
    }
    if (plain && pictures == 1) {
        result = std::move(last);
    } else {
        merger.add(std::move(last), name);
        result = merger.result();
    }
    output.sign(result);
    if (opt.outputs.empty()) output.to_stream(result);
    output.to_files(result);
}

}  // namespace

int main(int argc, char** argv) {
    return base::run("ptaccum", [&] {
        const auto opt = parse_options(argc, argv);
        if (!opt) return 0;
        const Output output(*opt, base::command_line(argc, argv));
        Source source(opt->inputs);
        image::Picture first;
        if (!source.next(first)) base::fail("", "no picture to read");
        if (first.header.frame && !first.header.frames) sum_frames(*opt, source, first, output);
        else merge(*opt, source, first, output);
        return 0;
    });
}
