// SPDX-License-Identifier: BSD-3-Clause
// ptaccum's options, each declared once (base/options.h), and what they may not say together.
#include "options.h"

#include <algorithm>

#include "base/error.h"
#include "base/options.h"
#include "display/file.h"
#include "image/stream.h"

namespace {

using base::Arguments;
using base::OptionTable;

void declare_output(OptionTable& t, Options& opt) {
    t.group("Output");
    t.add("-every N",
          "Write the sums of n = 0, N, 2N ... frames; x2 as N: n = 0, 1, 2, 4, 8 ..., x2/16: 16 steps a doubling",
          [&](Arguments& a) { opt.schedule = film::Schedule::parse(a.text(), a.name()); })
        .default_text("1");
    t.add("-last", "Write the last sum only", opt.last_only);
    t.add("-until percent", "With -last: end as soon as blocks of 8 x 8 pixels have this standard error, rms",
          [&](Arguments& a) { opt.until_percent = a.real(base::above(0)); });
    t.add("-o file",
          "Write to this file (" + display::endings() + "), or with - to the standard output; may be repeated",
          opt.outputs)
        .also_joined();
    t.add("-ff", "Float pixels in all RADIANCE pictures", opt.floats);
    t.add("-fc", "RGBE pixels in all RADIANCE pictures", opt.bytes);
    t.add("-batches N", "Keep N parts of the frames in OpenEXR files, for vcmetrics -ci; 0: none", [&](Arguments& a) {
         opt.batches = int(a.integer(base::within(0, double(image::most_parts))));
         if (opt.batches == 1) base::fail("-batches", "one part tells nothing of its error: 2 to 16, or 0");
     }).default_text("16 of frames, in a merge as many as the inputs have");
    t.add("-half", "16-bit floats in OpenEXR files", opt.half);
}

void declare_tone(OptionTable& t, Options& opt) {
    using Kind = display::ToneOptions::Kind;
    using Style = display::ToneOptions::Style;
    t.group("PNG files");
    t.add("-tone curve", "How PNG files show the picture: photo, linear, grey or falsecolor",
          base::one_of(opt.tone.kind, {{"photo", Kind::photo},
                                       {"linear", Kind::linear},
                                       {"grey", Kind::grey},
                                       {"falsecolor", Kind::falsecolor}}));
    t.add("-stops number", "Brighter or, below 0, darker than the automatic exposure, in factors of 2", opt.tone.stops)
        .within(-40, 40);
    t.add("-max luminance", "Falsecolor: luminance of the top colour", opt.tone.max_cdm2)
        .unit("cd/m2")
        .default_text("chosen from the picture")
        .above(0);
    t.add("-decades number", "Falsecolor: decades of luminance from the bottom colour to the top one; 0 is linear",
          opt.tone.decades)
        .within(0, 12);
    t.add("-style name", "Falsecolor: smooth, bands, or contours over the grey picture",
          base::one_of(opt.tone.style,
                       {{"smooth", Style::smooth}, {"bands", Style::bands}, {"contours", Style::contours}}));
    t.add("-divisions N", "Falsecolor: divisions of the scale, for bands and contours", opt.tone.divisions)
        .within(2, 64);
    t.add("-mask luminance", "Falsecolor: black below this luminance", opt.tone.mask_cdm2).unit("cd/m2").at_least(0);
    t.add("-filter name", "Filter that removes noise from PNG files of frames: nlm (non-local means) or none",
          base::one_of(opt.filter, {{"nlm", true}, {"none", false}}));
    t.add("-nolegend", "Falsecolor: leave out the legend", base::set(opt.tone.legend, false));
}

}  // namespace

std::optional<Options> parse_options(int argc, char** argv) {
    Options opt;
    OptionTable table("ptaccum", LUXPIPE_VERSION, "[options] [file ...] (none or \"-\": stdin)");
    declare_output(table, opt);
    declare_tone(table, opt);
    const auto operands = table.parse(argc, argv);
    if (!operands) return std::nullopt;

    opt.command = table.command();
    opt.every_given = table.given("-every");
    if (opt.last_only && opt.every_given) base::fail("-last", "cannot be used with -every");
    if (opt.until_percent && !opt.last_only) base::fail("-until", "needs -last");
    if (opt.floats && opt.bytes) base::fail("-ff", "cannot be used with -fc");
    const auto files_end = std::remove(opt.outputs.begin(), opt.outputs.end(), "-");
    const bool exr = std::any_of(opt.outputs.begin(), files_end,
                                 [](const std::string& name) { return image::ending_of(name) == ".exr"; });
    if (opt.batches > 0 && !exr) base::fail("-batches", "are kept in OpenEXR files: -o file.exr");
    opt.keeps_parts = exr && !opt.half && opt.batches != 0;
    if (opt.batches > 0 && opt.half) base::fail("-batches", "cannot be used with -half, whose pixels are too coarse");
    opt.to_stdout = opt.outputs.empty() || files_end != opt.outputs.end();
    opt.outputs.erase(files_end, opt.outputs.end());
    for (const std::string& name : opt.outputs) display::require_writable_ending(name);
    opt.inputs = operands->empty() ? std::vector<std::string>{"-"} : *operands;
    return opt;
}
