// SPDX-License-Identifier: BSD-3-Clause
// vcregion - masks of named regions for a view and size, from a text file (man/vcregion.5) and, if it asks for
// surfaces, a scene.  The regions live in lib/region; this file only connects.  See man/vcregion.1.
#include <fmt/core.h>
#include "base/error.h"
#include "base/run.h"
#include "region/region.h"
#include "region/preview.h"
#include "image/stream.h"
#include "options.h"
#include "visibility/visibility.h"

namespace {

// In or out by the pixel's centre, as evalglare decides: 1 or 0, no grey.
image::Picture single_mask(const region::Regions& regions, const Options& opt, const region::SceneView* scene) {
    std::vector<std::string> names;
    region::Regions one = regions;
    one.regions.clear();
    for (const region::Region& r : regions.regions) {
        names.push_back(r.name);
        if (r.name == opt.single) one.regions.push_back(r);
    }
    if (one.regions.empty())
        base::fail("-single",
                   fmt::format("no region is called \"{}\"{}", opt.single, region::near_matches(opt.single, names)));
    image::MaskSet set = region::rasterize(one, opt.view, opt.nx, opt.ny, true, scene);
    bool any = false;
    image::Picture p;
    p.width = set.width;
    p.height = set.height;
    for (float c : set.masks[0].coverage) {
        any = any || c > 0;
        p.rgb.insert(p.rgb.end(), 3, c);
    }
    if (!any)
        base::fail(one.regions[0].place, fmt::format("region \"{}\" is empty: it holds no pixel's centre", opt.single));
    return p;
}

void print_list(const std::vector<region::Extent>& extents) {
    std::string text = "region\tpixels\tsr\tshare\tx\ty\tz\n";
    for (const region::Extent& e : extents)
        text += fmt::format("{}\t{:.2f}\t{:.6g}\t{:.6f}\t{:.5f}\t{:.5f}\t{:.5f}\n", e.name, e.pixels, e.omega_sr,
                            e.share, e.centre.x, e.centre.y, e.centre.z);
    base::write_stdout(text.data(), text.size());
    base::flush_stdout();
}

int work(int argc, char** argv) {
    Options opt;
    if (auto status = parse_options(argc, argv, opt)) return *status;
    const region::Regions regions = region::read(opt.regions);
    image::Picture under;
    if (!opt.over.empty()) {
        under = image::read_file(opt.over);
        opt.nx = under.width;
        opt.ny = under.height;
        if (!opt.view_given && !under.header.view) base::fail(opt.over, "has no view; give one, for instance -vf");
        if (!opt.view_given) opt.view = *under.header.view;
    }
    view::validate(opt.view);
    if (opt.over.empty()) view::fit_size(opt.view, opt.pixel_aspect, opt.nx, opt.ny);
    const std::unique_ptr<region::SceneView> scene = visibility::open_scene(opt.scene, opt.files);

    image::MaskSet set;
    std::vector<region::Extent> extents;
    image::Header header;
    header.lines = {opt.command};
    header.view = opt.view;
    auto all_regions = [&] {  // only where asked for: -single alone needs one of them
        if (!set.masks.empty()) return;
        set = region::rasterize(regions, opt.view, opt.nx, opt.ny, opt.centre, scene.get());
        set.header = header;
        extents = opt.list ? region::measure(set, opt.view) : region::count_pixels(set, opt.view);
        region::check_sizes(regions, extents);
    };
    auto one_region = [&] {
        image::Picture mask = single_mask(regions, opt, scene.get());
        mask.header = header;
        return mask;
    };
    for (const std::string& name : opt.outputs) {
        const std::string ending = image::ending_of(name);
        if (ending == ".png") {
            all_regions();
            region::write_preview(name, under, set);
        } else if (!opt.single.empty()) {
            image::write_file(name, one_region());
        } else {
            all_regions();
            image::write_masks(name, set);
        }
    }
    if (opt.list) {
        all_regions();
        print_list(extents);
    } else if (opt.outputs.empty()) {
        image::write_picture_stdout(one_region(), image::Format::rgbe);
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    return base::run("vcregion", [&] { return work(argc, argv); });
}
