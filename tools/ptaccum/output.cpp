// SPDX-License-Identifier: BSD-3-Clause
// See output.h.
#include "output.h"

#include "base/error.h"
#include "base/file_status.h"
#include "base/run.h"
#include "display/file.h"
#include "image/header.h"
#include "image/stream.h"

namespace {

bool has_place_for_name(const std::string& pattern) { return pattern.find("%s") != std::string::npos; }

std::string label_without_action(image::Header header) {
    header.action.reset();
    return image::label(header);
}

// The picture of an action has the name of the ordinary one with the action behind it, "desk_mel.exr".
std::string name_of(const std::string& pattern, const image::Header& header) {
    std::string name = pattern;
    const std::string label = label_without_action(header);
    for (size_t at = 0; (at = name.find("%s", at)) != std::string::npos; at += label.size()) {
        if (label.empty()) base::fail("-o", "\"" + pattern + "\": the pictures have no names (ptrace -views)");
        name.replace(at, 2, label);
    }
    if (header.action) name.insert(name.size() - image::ending_of(name).size(), "_" + header.action->name);
    return name;
}

}  // namespace

Output::Output(const Options& options, std::string command) : options_(options), command_(std::move(command)) {
    if (to_stdout() && base::stdout_is_terminal())
        base::fail("stdout", "is a terminal: pictures go to a pipe, a file or -o file");
    if (to_stdout()) return;
    leaves_a_pipe_ = base::status_of(1).kind == base::FileKind::pipe;
    base::leave_stdout();
}

void Output::require_names_for(const image::Header& header) const {
    for (const std::string& pattern : options_.outputs)
        if (!label_without_action(header).empty() && !has_place_for_name(pattern))
            base::fail("-o", "\"" + pattern + "\" needs a %s for the names of several pictures");
        else name_of(pattern, header);
}

void Output::sign(image::Picture& picture) const { image::add_history(picture.header, command_); }

image::Format Output::format_of(const image::Picture& picture) const {
    if (options_.floats) return image::Format::flt;
    if (options_.bytes) return image::Format::rgbe;
    return image::needs_floats(picture.header) ? image::Format::flt : image::Format::rgbe;
}

void Output::stream_picture(image::Picture& picture) const {
    sign(picture);
    image::write_picture_stdout(picture, options_.bytes ? image::Format::rgbe : image::Format::flt);
}

void Output::stdout_picture(image::Picture& picture) const {
    sign(picture);
    picture.header.last_frame.reset();  // no more will come
    image::write_picture_stdout(picture, format_of(picture));
}

void Output::files(image::Picture& picture, bool passing, const std::vector<float>* filtered) const {
    sign(picture);
    image::add_date(picture.header);
    picture.header.last_frame.reset();
    write_files(picture, passing, filtered);
}

void Output::final_picture(image::Picture& picture) const {
    files(picture, false);
    if (to_stdout()) image::write_picture_stdout(picture, format_of(picture));
}

void Output::write_files(const image::Picture& picture, bool passing, const std::vector<float>* filtered) const {
    image::WriteOptions how;
    how.pixels = format_of(picture);
    how.exr.half = options_.half;
    how.exr.coarse_parts = !options_.batches;
    if (passing) how.exr.compression = "none";
    for (const std::string& pattern : options_.outputs) {
        const std::string name = name_of(pattern, picture.header), ending = image::ending_of(name);
        if (!passing && !picture.header.grids.empty() && !options_.floats && (ending == ".hdr" || ending == ".pic"))
            base::warn(name, options_.bytes ? "-fc rounds the values of points, weak channels most"
                                            : "holds points, whose values are written as floats, which RADIANCE does "
                                              "not read (-fc rounds them)");
        display::write_file(name, picture, how, options_.tone, filtered);
    }
}
