// SPDX-License-Identifier: BSD-3-Clause
// Command line of ptaccum.
#include "options.h"

#include <algorithm>

#include "base/cli.h"
#include "base/error.h"
#include "image/stream.h"

std::optional<Options> parse_options(int argc, char** argv) {
    Options opt;
    std::string every = "1", tone = "photo";
    bool no_legend = false;
    CLI::App app("Sum the frames of ptrace (L' = L(0) + mean of the diffuse frames), or merge such sums.", "ptaccum");
    app.add_option("inputs", opt.inputs, "streams of frames, or sums of frames to merge; none or -: stdin");
    app.add_option("--every", every, "write every N-th sum, or N = x2: 1 2 4 8 ..., x2/16: 16 steps a doubling");
    app.add_flag("--last", opt.last_only, "write only the last sum");
    app.add_option("-o", opt.outputs, "write to a file (.hdr .pic .exr .png), or with - to stdout; may repeat")
        ->allow_extra_args(false);
    app.add_flag("--ff", opt.floats, "float pixels, also in single pictures");
    app.add_flag("--fc", opt.bytes, "RGBE pixels, also in streams");
    app.add_flag("--half", opt.half, "16-bit floats in .exr files");
    app.add_option("--tone", tone, "of .png files: photo or falsecolor");
    app.add_option("--stops", opt.tone.stops, "photo: brighter or darker by factors of 2");
    app.add_option("--max", opt.tone.max_cdm2, "falsecolor: luminance of the top colour, cd/m2");
    app.add_option("--decades", opt.tone.decades, "falsecolor: decades of the scale, 0: linear");
    app.add_flag("--nolegend", no_legend, "falsecolor: without legend");
    if (base::parse_cli(app, argc, argv, LUXPIPE_VERSION)) return std::nullopt;

    opt.schedule = image::Schedule::parse(every, "-every");
    if (opt.last_only && app.count("--every")) base::fail("-last", "does not go with -every");
    opt.every_given = app.count("--every") > 0;
    if (opt.floats && opt.bytes) base::fail("-ff", "does not go with -fc");
    if (tone == "falsecolor") opt.tone.kind = image::ToneOptions::Kind::falsecolor;
    else if (tone != "photo") base::fail("-tone", '"' + tone + "\" is neither photo nor falsecolor");
    if (app.count("--max") && !(opt.tone.max_cdm2 > 0)) base::fail("-max", "is not above 0");
    if (!(opt.tone.decades >= 0 && opt.tone.decades <= 12)) base::fail("-decades", "is not within 0..12");
    if (!(opt.tone.stops >= -40 && opt.tone.stops <= 40)) base::fail("-stops", "is not within -40..40");
    opt.tone.legend = !no_legend;
    const auto files_end = std::remove(opt.outputs.begin(), opt.outputs.end(), "-");
    opt.to_stdout = opt.outputs.empty() || files_end != opt.outputs.end();
    opt.outputs.erase(files_end, opt.outputs.end());
    for (const std::string& name : opt.outputs) image::require_writable_ending(name);
    if (opt.inputs.empty()) opt.inputs.push_back("-");
    return opt;
}
