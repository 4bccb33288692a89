// SPDX-License-Identifier: BSD-3-Clause
// See report_file.h.
#include "report_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <sstream>

#include "base/angle.h"
#include "base/error.h"
#include "base/files_read.h"
#include "base/sha256.h"
#include "base/split.h"
#include "base/text_file.h"
#include "display/file.h"
#include "display/outline.h"
#include "drawing.h"
#include "glare/formulas.h"
#include "image/header.h"
#include "image/stream.h"
#include "report/number_table.h"
#include "report/page.h"
#include "report_commands.h"
#include "visibility/seen.h"
#include "visibility/visibility.h"

using report::Page;

namespace {

constexpr int most_pixels = 512, fewest_pixels = 128;  // of a side of a drawing
constexpr size_t most_bytes = 1350000;                 // of the drawings
constexpr size_t longest_map = size_t(1) << 24;        // bytes, of -plan
constexpr int most_steps = 128;                        // of a side, for outlines of sources
constexpr size_t most_rays = 200;                      // of a source
constexpr double sun_rad = 5 * base::degree;           // distant sources that are narrower are found by their direction

struct Grid {
    int width, height;
    std::vector<float> values;
};
// Means over squares of f x f pixels, of several numbers a pixel.
Grid reduced(const std::vector<float>& values, int width, int height, int numbers, int f) {
    Grid out{(width + f - 1) / f, (height + f - 1) / f, {}};
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x)
            for (int c = 0; c < numbers; ++c) {
                double sum = 0;
                const int x1 = std::min(f * (x + 1), width), y1 = std::min(f * (y + 1), height);
                for (int j = f * y; j < y1; ++j)
                    for (int i = f * x; i < x1; ++i)
                        sum += double(values[size_t(numbers) * (size_t(j) * size_t(width) + size_t(i)) + size_t(c)]);
                out.values.push_back(float(sum / ((x1 - f * x) * (y1 - f * y))));
            }
    return out;
}
int factor(int width, int height, int most) { return (std::max(width, height) + most - 1) / most; }

// Without the noise of its border, unless it is small.
std::vector<display::Ring> smooth_outlines(const std::vector<float>& area, int width, int height) {
    const int f = factor(width, height, most_steps);
    const Grid coarse = reduced(area, width, height, 1, f);
    std::vector<display::Ring> out = display::outlines(coarse.values, coarse.width, coarse.height);
    for (display::Ring& ring : out)
        for (auto& corner : ring) corner = {float(f) * corner[0], float(f) * corner[1]};
    return out.empty() ? display::outlines(area, width, height) : out;
}

// The last line of a table that vcmetrics has written.
std::vector<Page::Number> recorded(const std::string& file) {
    std::vector<Page::Number> out;
    const auto table = report::read_numbers(file);
    if (!table || table->rows.empty()) base::fail(file, "is no table of vcmetrics");
    const std::vector<double>& last = table->rows.back();
    const auto value = [&](const std::string& name) {
        const auto at = std::find(table->names.begin(), table->names.end(), name);
        return at == table->names.end() ? std::nan("") : last[size_t(at - table->names.begin())];
    };
    for (const std::string& n : table->names)
        if (!base::ends_with(n, ".lo") && !base::ends_with(n, ".hi") && !base::ends_with(n, ".d"))
            out.push_back({n, value(n), value(n + ".lo"), value(n + ".hi")});
    return out;
}

// Of an infinitely fine picture, which moments of pixels stand for.
bool is_of_filled(const std::string& column) { return column == "DGPf" || column == "UGRf" || column == "DGIf"; }

// The numbers of the row, or the recorded ones.
std::vector<Page::Number> numbers_of(const Options& o, const RunState& run, const Row& row) {
    std::vector<Page::Number> out;
    if (!o.numbers_file.empty()) return recorded(o.numbers_file);
    for (size_t k = 0; k < run.plan.columns.size(); ++k) {
        const Number& n = row.numbers[k];
        const glare::Column& c = run.plan.columns[k];
        const bool stands_in = c.name == "DGP" && !row.measurement.filled;
        if ((!c.printed && !stands_in) || c.words) continue;
        out.push_back({c.name, n.value, n.middle + n.off.low, n.middle + n.off.high});
        if (!row.measurement.filled && is_of_filled(c.name)) out.back() = {c.name, NAN, NAN, NAN};
    }
    return out;
}

// Why numbers of the page are not those that a reader expects.
std::vector<std::string> notes_of(const Options& o, const RunState& run, const std::vector<Page::Number>& numbers) {
    std::vector<std::string> notes;
    if (o.numbers_file.empty() && !run.reading.lum.moments)
        notes.emplace_back(
            "The picture has no moments of its pixels (a stream of ptrace and its OpenEXR files have), and so there is "
            "no DGPf. DGP depends on the size of the pixels: sources that are smaller than a pixel count too little.");
    const auto is_known = [](const Page::Number& n) { return std::isfinite(n.low); };
    if (std::none_of(numbers.begin(), numbers.end(), is_known))
        notes.emplace_back(
            "There are no intervals: a single picture does not tell how far its noise reaches. The stream of its "
            "frames "
            "does (ptaccum without -last), and so does an OpenEXR file that ptaccum has made of them.");
    return notes;
}

std::vector<visibility::WeightedRay> rays_to(const std::vector<float>& area, const glare::Geometry& g,
                                             const image::Picture& picture, const region::SceneView& scene) {
    const std::vector<region::DistantSource> distant = scene.distant();
    std::vector<visibility::WeightedRay> out;
    const size_t step = size_t(std::count(area.begin(), area.end(), 1.f)) / most_rays + 1;
    for (size_t i = 0, k = 0; i < area.size(); ++i) {
        if (area[i] == 0) continue;
        const auto ray = g.projector.ray((g.x_of(i) + .5) / g.width, (g.y_of(i) + .5) / g.height);
        if (!ray) continue;
        base::Vec3 dir = ray->dir;
        bool is_sun = false;  // of the pixel or of one beside it
        for (const region::DistantSource& s : distant) {
            if (s.half_rad > sun_rad ||
                std::acos(std::min(1., base::dot(dir, s.dir))) > s.half_rad + 1.5 * std::sqrt(g.omega[i]))
                continue;
            dir = s.dir, is_sun = true;
        }
        if (k++ % step == 0 || is_sun)
            out.push_back({ray->origin, dir, ray->tmax, image::luminance(&picture.rgb[3 * i]) * g.omega[i]});
    }
    return out;
}

void add_regions(const Options& o, const image::Picture& picture, const glare::Geometry& g, Page& page) {
    for (const image::Mask& m : regions_in(o, picture).masks) {
        if (m.coverage.size() != size_t(g.width) * size_t(g.height)) continue;  // out of sight
        const auto top = top_of(m.coverage, g.width);
        page.outlines.push_back(
            {m.name, display::outlines(m.coverage, g.width, g.height), float(top.x), float(top.y), false});
    }
}

void add_sources(const Options& o, const image::Picture& picture, const RunState& run, const glare::Measurement& m,
                 Page& page) {
    const glare::Geometry& g = run.reading.geometry();
    const auto scene = visibility::open_scene(o.scene, o.scene_options);
    page.knows_objects = scene != nullptr;
    const auto light = [&](size_t i) { return image::luminance(&picture.rgb[3 * i]); };
    const std::vector<double> shares = glare::dgp_shares(glare::terms_of(m.sources), o.settings.constants);
    for (size_t k = 0; k < m.sources.size(); ++k) {
        const glare::GlareSource& s = m.sources[k];
        page.sources.push_back({k + 1, shares[k], s.lum, s.omega, s.P, s.eye_lux, s.direction, ""});
        if (shares[k] < report::speck) continue;
        const std::vector<float> area = area_of(m, g, s);
        size_t peak = 0;
        for (size_t i = 0; i < area.size(); ++i)
            if (area[i] > 0 && (area[peak] == 0 || light(i) > light(peak))) peak = i;
        if (scene) page.sources.back().what = visibility::seen_along(*scene, rays_to(area, g, picture, *scene));
        page.outlines.push_back({fmt::format("{}: {:.0f} %", k + 1, 100 * shares[k]),
                                 smooth_outlines(area, g.width, g.height), float(peak % size_t(g.width)),
                                 float(peak / size_t(g.width)), true});
    }
    for (const region::DistantSource& s : scene ? scene->distant() : std::vector<region::DistantSource>())
        if (s.half_rad < sun_rad)
            page.sky.push_back(fmt::format("{}: {:.1f}° above the horizon, {:.1f}° from north (the y axis) over east",
                                           scene->surface_name(s.surface), std::asin(s.dir.z) / base::degree,
                                           std::fmod(std::atan2(s.dir.x, s.dir.y) / base::degree + 360, 360)));
}

display::ToneOptions colours_of(const image::Picture& picture) {
    display::ToneOptions colours;
    colours.kind = display::ToneOptions::Kind::falsecolor, colours.legend = false;
    colours.max_cdm2 = display::falsecolor_scale(picture, colours).top;
    return colours;
}

void add_drawings(const image::Picture& picture, Page& page) {
    const display::ToneOptions colours = colours_of(picture);
    for (int most = most_pixels; most >= fewest_pixels; most /= 2) {
        Grid grid = reduced(picture.rgb, picture.width, picture.height, 3, factor(picture.width, picture.height, most));
        image::Picture small;
        small.width = grid.width, small.height = grid.height, small.rgb = std::move(grid.values);
        page.drawings = {{"As the eye sees it", display::png_bytes(display::tone(small, {}), "")},
                         {"Luminance", display::png_bytes(display::tone(small, colours), "")}};
        if (page.drawings[0].png.size() + page.drawings[1].png.size() <= most_bytes) break;
    }
    const display::Scale scale = display::falsecolor_scale(picture, colours);
    for (int k = 0; k <= 16; ++k) {
        const display::Colour c = display::ramp(k / 16.);
        page.legend.colours.push_back(fmt::format("#{:02x}{:02x}{:02x}", c[0], c[1], c[2]));
    }
    for (const double tick : display::ticks(scale))
        page.legend.ticks.emplace_back(scale.place(tick), fmt::format("{:g}", tick));
}

void add_variants(const Options& o, const image::Picture& picture, Page& page) {
    const display::ToneOptions colours = colours_of(picture);
    for (const Options::Variant& v : o.variants) {
        const image::Picture p = image::read_file(v.picture);
        Grid grid = reduced(p.rgb, p.width, p.height, 3, factor(p.width, p.height, most_pixels / 2));
        image::Picture small;
        small.width = grid.width, small.height = grid.height, small.rgb = std::move(grid.values);
        page.variants.push_back({v.name, display::png_bytes(display::tone(small, colours), ""), lines_in(v.lines)});
    }
    if (!o.day.empty()) page.day = lines_in(o.day);
}

// The lines that ptrace -wea writes of an hour, in words.
std::vector<std::string> hour_of(const image::Header& header) {
    constexpr std::pair<const char*, const char*> words[] = {
        {"TIME= ", "{}"},
        {"SUN= ", "sun: {} (altitude, and azimuth from north over east, in degrees)"},
        {"IRRADIANCE= ", "weather file: {} W/m2 (direct normal, diffuse horizontal)"},
        {"ILLUMINANCE= ", "sun and sky: {} lx (the same by Perez' efficacies, which the open sky has to 1e-4)"}};
    std::vector<std::string> lines;
    for (const auto& [name, text] : words)
        for (const std::string& line : header.lines)
            if (base::begins_with(line, name))
                lines.push_back(fmt::format(fmt::runtime(text), line.substr(std::strlen(name))));
    return lines;
}

// Lines by which a sky was made, and where the sun stands.
void add_sky(const Options& o, const std::vector<std::string>& files, const image::Header& header, Page& page) {
    if (!header.sky_name.empty()) page.sky.push_back(header.sky_name);
    for (std::string& line : hour_of(header)) page.sky.push_back(std::move(line));
    if (o.scene.empty()) return;
    for (const std::string& file : files) {
        if (!base::ends_with(file, ".rad") && !base::ends_with(file, ".sky")) continue;
        std::istringstream text(base::read_text_file(file, size_t(1) << 26, o.scene_options.opener("")));
        for (std::string line; std::getline(text, line);)
            for (const char* const program : {"gensky ", "gendaylit "})
                if (const size_t at = line.find(program); at != std::string::npos &&
                                                          (line[0] == '!' || line[0] == '#') &&
                                                          std::strchr("0123456789-", line[at + std::strlen(program)]))
                    page.sky.push_back(report::name_in_folder(file) + ": " + line.substr(at));
    }
}

void add_files(const Options& o, const std::vector<std::string>& files, Page& page) {
    std::error_code absent;
    for (const std::string& file : files) {
        const auto changed = [&](const auto& overlay) { return overlay.first == file; };
        if (!std::filesystem::is_regular_file(file, absent)) continue;
        const bool is_changed = std::any_of(o.overlays.begin(), o.overlays.end(), changed);
        page.files.push_back({file + (is_changed ? " (as changed in the page)" : ""),
                              base::sha256_of_file(file, o.scene_options.overlays)});
    }
}

}  // namespace

void write_report(const Options& o, const image::Picture& picture, const RunState& run, const Row& row) {
    const glare::Geometry& g = run.reading.geometry();
    Page page;
    page.title = image::label(picture.header);
    if (page.title.empty() && row.file != "-") page.title = report::name_in_folder(row.file);
    if (page.title.empty() && !o.scene.empty())
        page.title = std::filesystem::absolute(o.scene[0]).parent_path().filename().string();
    page.numbers = numbers_of(o, run, row);
    page.notes = notes_of(o, run, page.numbers);
    page.about = o.about;
    page.criteria = o.criteria;
    page.is_black = glare::is_black(row.measurement);
    page.certainty = o.ci.value_or(.95);
    page.view = g.projector.view();
    page.width = g.width, page.height = g.height;
    page.header = picture.header;
    image::add_date(page.header);
    add_regions(o, picture, g, page);
    add_sources(o, picture, run, row.measurement, page);
    add_drawings(picture, page);
    add_variants(o, picture, page);
    const std::vector<std::string> files = base::paths_of(*o.scene_options.read);
    add_sky(o, files, picture.header, page);
    add_files(o, files, page);
    std::vector<std::string> regions;
    if (!o.regions_file.empty())
        for (const image::Mask& m : regions_in(o, picture).masks) regions.push_back(m.name);
    if (picture.header.edit) leave_out_undrawn(regions, page.numbers);
    page.commands = commands_of(o, picture, view::to_options(page.view), regions);
    if (!o.plan_map.empty()) page.plan = {base::read_text_file(o.plan_map, longest_map), recorded(o.plan_numbers)};
    page.version = std::string("luxpipe ") + LUXPIPE_VERSION;
    const std::string text = report::page_text(page);
    base::refuse_to_overwrite({o.report_file}, files);
    image::write_bytes(o.report_file, text);
}
