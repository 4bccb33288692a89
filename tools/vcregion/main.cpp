// SPDX-License-Identifier: BSD-3-Clause
// vcregion - masks of named regions for a view and size, from a text file (man/vcregion.5) and, if it asks for
// surfaces, a scene.  The regions live in lib/region; this file only connects.  See man/vcregion.1.
#include <fmt/core.h>
#include "base/error.h"
#include "base/run.h"
#include "region/region.h"
#include "region/preview.h"
#include "region/sensors.h"
#include "image/stream.h"
#include "options.h"
#include "visibility/visibility.h"

namespace {

size_t index_of(const region::Regions& regions, const std::string& name) {
    std::vector<std::string> names;
    for (const region::Region& r : regions.regions) {
        if (r.name == name) return names.size();
        names.push_back(r.name);
    }
    base::fail("-single", fmt::format("no region is called \"{}\"{}", name, region::near_matches(name, names)));
}

// In or out by the pixel's centre, as evalglare decides: 1 or 0, no grey.
image::Picture single_mask(const region::Regions& regions, const Options& opt, const region::SceneView* scene) {
    region::Regions one = regions;
    one.regions = {regions.regions[index_of(regions, opt.single)]};
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

// What the regions and the scene name besides the files of the command line (options.cpp) is not overwritten either.
void refuse_to_overwrite(const std::vector<std::string>& outputs, const region::Regions& regions, const Options& opt) {
    base::refuse_to_overwrite(outputs, region::mask_files(regions));
    base::refuse_to_overwrite(outputs, base::paths_of(*opt.files.read));
}

std::string points_text(const region::Regions& regions, size_t k, const Options& opt, const region::SceneView* scene) {
    std::string text = fmt::format("# {}\n", regions.regions[k].name);
    for (const image::Point& point : region::sensors_of(regions, k, opt.spacing, opt.height, scene))
        text += fmt::format("{:.6g} {:.6g} {:.6g} {:.6g} {:.6g} {:.6g}\n", point.p.x, point.p.y, point.p.z, point.dir.x,
                            point.dir.y, point.dir.z);
    return text;
}

// To the standard output, to a file, or each region to NAME.pts of a folder.
void write_points(const region::Regions& regions, const Options& opt, const region::SceneView* scene) {
    std::vector<size_t> chosen;
    if (!opt.single.empty()) chosen = {index_of(regions, opt.single)};
    else
        for (size_t k = 0; k < regions.regions.size(); ++k) chosen.push_back(k);
    std::string all;
    std::vector<std::pair<std::string, std::string>> files;
    for (const size_t k : chosen) {
        const std::string text = points_text(regions, k, opt, scene);
        all += text;
        for (const std::string& name : opt.outputs)
            if (name.back() == '/') files.push_back({name + regions.regions[k].name + ".pts", text});
    }
    for (const std::string& name : opt.outputs)
        if (name.back() != '/') files.push_back({name, all});
    for (const auto& [name, text] : files) refuse_to_overwrite({name}, regions, opt), image::write_bytes(name, text);
    if (opt.outputs.empty()) base::write_stdout(all.data(), all.size()), base::flush_stdout();
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
    if (opt.spacing > 0) return write_points(regions, opt, visibility::open_scene(opt.scene, opt.files).get()), 0;
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
    refuse_to_overwrite(opt.outputs, regions, opt);

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
