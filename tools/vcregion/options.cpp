// SPDX-License-Identifier: BSD-3-Clause
// vcregion's options, each declared once (base/options.h), and what they may not say together.
#include "options.h"

#include <algorithm>

#include "base/error.h"
#include "base/files_read.h"
#include "base/model_folder.h"
#include "base/options.h"
#include "base/run.h"
#include "base/warnings.h"
#include "image/stream.h"

namespace {
using base::OptionTable;

void declare(OptionTable& t, Options& o) {
    view::declare_options(t, o.view);
    view::declare_file_option(t, [&](const view::View& v) { o.view = v; });

    t.group("Picture");
    t.add("-x n", "Horizontal resolution", o.nx).within(1, 32768);
    t.add("-y n", "Vertical resolution", o.ny).within(1, 32768);
    t.add("-pa f", "Pixel aspect, height over width; 0 keeps both resolutions", o.pixel_aspect);

    t.group("Output");
    t.add("-o file",
          "Write masks (.exr), one mask (.hdr or .pic, with -single), a preview (.png, with -over) or points (.pts)",
          o.outputs);
    t.add("-centre", "A pixel is in or out by its centre: coverage is 1 or 0", o.centre);
    t.add("-single name", "Write only this region, by the pixels' centres, as a mask for evalglare -A; or its points",
          o.single);
    t.add("-list", "Print a line for each region: pixels, solid angle, share of the view and mean direction", o.list);
    t.add("-over picture", "The picture under the preview", o.over);
    t.add("-spacing f", "Points x y z dx dy dz on the regions' surfaces, so far apart, in place of masks", o.spacing)
        .above(0)
        .default_text("masks");
    t.add("-height f", "With -spacing: the points' height above the surfaces", o.height);
    t.add("-exec", "Let the scene run its !commands", o.files.exec);

    t.group("Messages");
    t.add("-w[+-]", "Warnings", o.warnings);
    t.options_come_before("the region file");
    t.footer("The file of regions is described in vcregion(5).  ");
}

bool says_view(const OptionTable& t) {
    const auto& said = t.parsed();
    return std::any_of(said.begin(), said.end(), [](const auto& s) { return s.option->group() == "View"; });
}

void check_points(const Options& o) {
    if (o.list || o.centre || !o.over.empty())
        base::fail("-spacing", "makes points, for which -list, -centre and -over have no meaning");
    for (const std::string& name : o.outputs)
        if (name.back() != '/' && image::ending_of(name) != ".pts")
            base::fail(name, "points are written to .pts, or to a folder, name/, a file for each region");
}

void check(const Options& o) {
    if (o.regions.empty()) base::fail("", "no region file; vcregion -help lists the options");
    std::vector<std::string> inputs = o.scene;
    inputs.insert(inputs.end(), {o.regions, o.over});
    base::refuse_to_overwrite(o.outputs, inputs);
    if (o.spacing > 0) return check_points(o);
    for (const std::string& name : o.outputs) {
        const std::string ending = image::ending_of(name);
        if (ending == ".exr") {
        } else if (ending == ".hdr" || ending == ".pic") {
            if (o.single.empty())
                base::fail(name, "a RADIANCE picture holds one mask; name it with -single, or write .exr");
        } else if (ending == ".png") {
            if (o.over.empty()) base::fail(name, "a preview needs -over picture");
        } else {
            base::fail(name, "masks are written to .exr, one mask to .hdr or .pic, a preview to .png");
        }
    }
    if (!o.over.empty()) {
        bool png = false;
        for (const std::string& name : o.outputs) png = png || image::ending_of(name) == ".png";
        if (!png) base::fail("-over", "name the preview: -o file.png");
    }
    if (o.outputs.empty() && !o.list) {
        if (o.single.empty()) base::fail("", "nothing to write: give -o masks.exr, -list or -single name");
        if (base::stdout_is_terminal()) base::fail("stdout", "a mask is binary; pipe it or name a file with -o");
    }
}

}  // namespace

std::optional<int> parse_options(int argc, char** argv, Options& o) {
    o.files.raypath = base::raypath_from_environment();
    o.files.work = base::work_budget_from_environment();
    OptionTable table("vcregion", LUXPIPE_VERSION, "[options] regions.txt [scene.rad ...]");
    declare(table, o);
    const auto operands = table.parse(argc, argv);
    if (!operands) return 0;

    base::note_files(*o.files.read, table.files_read());
    o.command = table.command();
    o.view_given = says_view(table);
    if (!operands->empty()) {
        o.regions = operands->front();
        o.scene = base::open_folders({operands->begin() + 1, operands->end()}, o.files);
    }
    if (!o.warnings) base::set_warning_sink({});
    check(o);
    return std::nullopt;
}
