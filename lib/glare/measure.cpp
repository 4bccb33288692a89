// SPDX-License-Identifier: BSD-3-Clause
// Calculates each required quantity once, in the order of their dependence (measure.h).
#include "glare/measure.h"
#include <algorithm>
#include <cmath>
#include "base/angle.h"
#include "base/error.h"
#include "base/split.h"
#include "glare/filled.h"
#include "glare/position_index.h"
#include "glare/threshold.h"

namespace glare {

using base::pi;

namespace {

std::vector<std::string> names_of(const image::MaskSet& regions) {
    std::vector<std::string> out;
    for (const image::Mask& m : regions.masks) out.push_back(m.name);
    return out;
}

void require_task(const Settings& settings, const std::vector<std::string>& regions) {
    if (!settings.task_region.empty() &&
        std::find(regions.begin(), regions.end(), settings.task_region) == regions.end())
        base::fail("-task", "there is no region \"" + settings.task_region + "\"");
}

// A picture of irradiance (-i of ptrace and RADIANCE's programs), by the command line in its header.
bool is_of_irradiance(const image::Header& header) {
    bool out = false;
    for (const std::string& line : header.lines) {
        const std::vector<std::string> words = base::split_words(line);
        const std::string program = words.empty() ? "" : words[0].substr(words[0].rfind('/') + 1);
        if (program != "ptrace" && program != "rpict" && program != "rvu" && program != "rpiece") continue;
        for (const std::string& word : words)
            if (base::begins_with(word, "-i") && word.size() <= 3) out = word != "-i-";
    }
    return out;
}

}  // namespace

PictureAnalyzer::PictureAnalyzer(const Settings& settings, Requirements requirements,
                                 std::optional<image::MaskSet> regions, image::DrawRegions draw, Methods methods)
    : methods_(std::move(methods)),
      settings_(settings),
      requirements_(requirements),
      regions_(std::move(regions)),
      draw_(std::move(draw)) {
    if (regions_) region_names_ = names_of(*regions_);
    require_task(settings_, region_names_);
}

// With the present geometry.
std::vector<RegionPixels> PictureAnalyzer::lay(image::MaskSet& regions, const image::DrawRegions& draw,
                                               const std::string& place) const {
    const int width = geometry_->width, height = geometry_->height;
    if (draw) regions = draw(geometry_->projector.view(), width, height);
    if (regions.width != width || regions.height != height)
        base::fail(place, "the picture has " + std::to_string(width) + " x " + std::to_string(height) +
                              " pixels, the regions " + std::to_string(regions.width) + " x " +
                              std::to_string(regions.height));
    std::vector<RegionPixels> out;
    for (const image::Mask& m : regions.masks) out.emplace_back(m.coverage, *geometry_);
    return out;
}

void PictureAnalyzer::set_regions(image::MaskSet regions, image::DrawRegions draw, Requirements requirements) {
    const std::vector<std::string> names = names_of(regions);
    require_task(settings_, names);
    if (geometry_) region_pixels_ = lay(regions, draw, "regions");
    regions_ = std::move(regions), draw_ = std::move(draw);
    region_names_ = names;
    requirements_ = (requirements_ & ~require::regions_in_full) | (requirements & require::regions_in_full);
}

void PictureAnalyzer::prepare(const view::View& view, const image::Picture& picture, const std::string& place) {
    if (geometry_ && geometry_->fits(view, picture.width, picture.height)) return;
    if (settings_.patches && view.type != 'a') base::fail("-z", "patches need an angular fisheye view (-vta)");
    if (view.type == 'l') base::fail(place, "a parallel view (-vtl) has no eye point: glare is not defined for it");
    try {
        view::validate(view);
    } catch (const base::Error& e) {
        base::fail(place, std::string("the view cannot be used: ") + e.what());
    }
    placed_geometry_.reset(), drawn_pixels_.clear(), moments_.reset();
    geometry_.reset();
    geometry_ = std::make_unique<Geometry>(methods_.geometry(view, place), picture.width, picture.height);
    if (requires_sources()) find_sources_ = methods_.sources(*geometry_, settings_);
    narrow_ = (requirements_ & require::all_light) && geometry_->share_of_light() < .9;
    if (requirements_ & require::rammg) pyramid_ = std::make_unique<Pyramid>(*geometry_, settings_.rammg_area);
    find_position_index();
    sets_ = pixel_sets();
    region_pixels_.clear();
    if (regions_) region_pixels_ = lay(*regions_, draw_, place);
}

void PictureAnalyzer::find_position_index() {
    const Geometry& g = *geometry_;
    position_index_.assign((requirements_ & require::medians) ? g.omega.size() : 0, 0);
    for (size_t i = 0; i < position_index_.size(); ++i)
        if (g.valid(i)) position_index_[i] = float(position_index(g, g.seen_direction(i), settings_.position));
}

void PictureAnalyzer::place_drawn_pixels(const image::Moments& moments) {
    if (moments == moments_) return;
    moments_ = moments;
    drawn_pixels_ = geometry_->drawn_pixels(moments);
    placed_geometry_ = drawn_pixels_.empty() ? nullptr : std::make_unique<Geometry>(geometry_->with(drawn_pixels_));
}

double PictureAnalyzer::gain_of_place(const Luminance& lum, const Luminance& classification_image, double above) const {
    double lux = 0;
    for (const DrawnPixel& p : drawn_pixels_)
        if (classification_image.at(p.pixel) > above)
            lux += lum.at(p.pixel) * (p.omega_cos - geometry_->omega_cos[p.pixel]);
    return lux;
}

// Means and medians of L, L/P and L/P^2.
void PictureAnalyzer::position_statistics(const Luminance& lum, Measurement& m) const {
    const Geometry& g = *geometry_;
    std::vector<float> values;
    values.reserve(g.valid_count);
    double sum1 = 0, sum2 = 0;
    for (int power = 0; power <= 2; ++power) {
        values.clear();
        for (size_t i = 0; i < g.omega.size(); ++i) {
            if (!g.valid(i)) continue;
            const double P = position_index_[i], L = lum.at(i);
            values.push_back(float(power == 0 ? L : power == 1 ? L / P : L / (P * P)));
            if (power == 1) sum1 += g.omega[i] * L / P;
            if (power == 2) sum2 += g.omega[i] * L / (P * P);
        }
        (power == 0 ? m.median : power == 1 ? m.median_pos : m.median_pos2) = median(values);
    }
    m.mean_pos = sum1 / g.omega_sum;
    m.mean_pos2 = sum2 / g.omega_sum;
}

// The same for whole and for filled pixels.  photometry: of the light that reaches the eye.
Glare glare_of(const Luminance& lum, const Luminance& classification_image, const Geometry& g, const Settings& settings,
               const Methods& methods, const Photometry& photometry, const Sources& found, double task_lum,
               double threshold) {
    Glare m;
    static_cast<Photometry&>(m) = photometry;
    m.task_lum = task_lum, m.threshold = threshold;
    m.sources = found.sources;
    m.direct_lux = found.direct_lux;
    m.glare = glare_terms(lum, classification_image, g, settings, threshold, m.sources);
    m.any_source = !m.sources.empty();
    const double rest_lux = m.ev - m.direct_lux;
    m.background0 = methods.nothing_left(std::fabs(rest_lux), m.ev) ? 0 : rest_lux / evalglare_pi;
    m.background = m.background0;
    if (settings.background == 1) {
        double flux = 0, omega = 0;
        for (const GlareSource& s : m.sources) flux += s.lum * s.omega, omega += s.omega;
        const double rest = m.omega - omega;
        m.background = methods.nothing_left(rest, m.omega) ? m.mean_lum : (m.omega * m.mean_lum - flux) / rest;
    } else if (settings.background == 2) {
        m.background = m.ev / evalglare_pi;
    }
    m.eye_lux_used = settings.external_ev.value_or(m.ev);
    m.dgp_computed = dgp(m.glare, m.ev, settings.constants);
    m.dgp =
        dgp(m.glare, m.eye_lux_used, settings.constants) * (settings.low_light ? low_light_factor(m.eye_lux_used) : 1);
    return m;
}

Glare PictureAnalyzer::filled_glare(const Luminance& lum, const Luminance& classification_image,
                                    const Measurement& m) const {
    const Geometry& g = placed_geometry_ ? *placed_geometry_ : *geometry_;
    Luminance classification = classification_image;
    classification.moments = lum.moments;
    FilledPixels own = filled_pixels(lum), classified = filled_pixels(classification);
    const Luminance light = own.as(lum), bright = classified.as(classification);
    Photometry photometry = m;
    photometry.ev = m.placed_ev;
    return glare_of(light, bright, g, settings_, methods_, photometry, find_sources_(light, bright, g, m.threshold, {}),
                    m.task_lum, m.threshold);
}

void PictureAnalyzer::glare(Luminance& lum, Luminance& classification_image, Measurement& m) const {
    const Geometry& g = *geometry_;
    if (settings_.field_cut) cut_field(lum, g, settings_.field_cut);
    if (settings_.field_cut && &classification_image != &lum) cut_field(classification_image, g, settings_.field_cut);
    const bool has_task = settings_.task || !settings_.task_region.empty();
    double task_lum = methods_.reference_luminance(lum, g, settings_, m.mean_lum);
    for (size_t k = 0; k < region_names_.size() && !settings_.task; ++k)
        if (region_names_[k] == settings_.task_region) task_lum = region_pixels_[k].tal(lum);
    task_lum = float(task_lum);
    const double threshold = source_threshold(settings_, has_task, task_lum);

    Sources found = find_sources_(lum, classification_image, g, threshold, sets_);
    static_cast<Glare&>(m) = glare_of(lum, classification_image, g, settings_, methods_, m, found, task_lum, threshold);
    static_cast<SetStatistics&>(m) = found.sets;
    m.runs = std::move(found.runs), m.runs_before_zones = std::move(found.runs_before_zones);
    m.sources_before_zones = std::move(found.before_zones);
    m.placed_direct_lux = m.direct_lux + gain_of_place(lum, classification_image, threshold);
    if (requirements_ & require::filled && lum.moments && !settings_.field_cut && !settings_.fill)
        m.filled = filled_glare(lum, classification_image, m);
    if (m.mask) m.pgsv = pgsv(*m.mask, m.mean_lum, m.ev, has_task, m.task_lum);
}

// Of band and zones; the mask's are read with the first picture.
PixelSets PictureAnalyzer::pixel_sets() const {
    const Geometry& g = *geometry_;
    PixelSets out;
    if (!(requirements_ & require::sources)) return out;
    if (settings_.band_rad) out.band = band_pixels(g, *settings_.band_rad);
    if (!settings_.zones) return out;
    const Circle& inner = settings_.zones->inner;
    if (inner.x < 0 || inner.y < 0 || inner.x >= g.width || inner.y >= g.height)
        base::fail("-l", "the zone's centre is outside the picture");
    out.zone1 = zone_pixels(g, *settings_.zones, 1);
    if (settings_.zones->outer_opening) out.zone2 = zone_pixels(g, *settings_.zones, 2);
    return out;
}

Luminance PictureAnalyzer::read(image::Picture& picture, const std::string& place,
                                const std::optional<view::View>& view) {
    if (!view && !picture.header.view)
        base::fail(place, "the header has no view; give one with -vf file or with -vt, -vh and -vv");
    prepare(view ? *view : *picture.header.view, picture, place);
    if (geometry_->valid_count == 0) base::fail(place, "no pixel of the picture lies in its view");
    Luminance lum = make_luminance(picture);
    place_drawn_pixels(lum.moments);
    if (lum.not_finite)
        base::warn(place, "pixels that are not finite count as black (-metrics not_finite counts them)");
    if ((requirements_ & require::filled) && !lum.moments && !std::exchange(told_no_moments_, true))
        base::warn(
            place,
            "has no moments of its pixels (a stream of ptrace and its OpenEXR files have): the effect of their size "
            "on glare is unknown");
    if (is_of_irradiance(picture.header) && !std::exchange(told_irradiance_, true))
        base::warn(place,
                   "shows irradiance (-i), divided by pi: luminances are of white surfaces, but openings show the sky "
                   "itself, so that means with both are neither; glare and Ev have no meaning here");
    if (lum.negative) base::warn(place, "pixels are negative (-metrics negative counts them)");
    return lum;
}

Measurement PictureAnalyzer::measure(image::Picture& picture, const std::string& place,
                                     const std::optional<view::View>& view) {
    Luminance lum = read(picture, place, view);
    return measure(lum, place);
}

Measurement PictureAnalyzer::measure(Luminance& lum, const std::string& place) {
    std::optional<double> black_corners;
    if (geometry_->projector.view().type == 'v') {
        black_corners = black_corner_percent(lum);
        if (*black_corners > 70 && !settings_.force) throw BlackCorners(place, *black_corners);
    }
    if (std::exchange(narrow_, false))
        base::warn(place, "Ev and DGP are of this narrow view; -vta -vh 180 -vv 180 has all that reaches the eye");
    if (settings_.mask_file && requires_sources() && !sets_.mask)
        sets_.mask = mask_pixels(*settings_.mask_file, *geometry_);
    Measurement m = measure(lum, lum);
    m.black_corners = black_corners;
    return m;
}

Measurement PictureAnalyzer::measure(Luminance& lum, Luminance& classification_image) const {
    Measurement m;
    m.not_finite = lum.not_finite;
    m.negative = lum.negative;
    if (settings_.fill) fill_rows(lum, *geometry_, *settings_.fill);
    if (settings_.fill && &classification_image != &lum) fill_rows(classification_image, *geometry_, *settings_.fill);
    static_cast<Photometry&>(m) = methods_.photometry(lum, *geometry_, settings_);
    m.placed_ev = m.ev + gain_of_place(lum, lum, 0);
    regions(lum, m);
    if (requirements_ & require::rammg) m.rammg = rammg(lum, *pyramid_);
    if (requirements_ & require::medians) position_statistics(lum, m);
    if (requirements_ & require::sources) glare(lum, classification_image, m);
    return m;
}

void PictureAnalyzer::regions(const Luminance& lum, Measurement& m) const {
    for (const RegionPixels& r : region_pixels_) {
        m.region_values.emplace_back();
        if (requirements_ & require::regions_in_full) m.region_values.back() = r.measure(lum);
        else m.region_values.back().tal = r.tal(lum);
    }
}

Measurement PictureAnalyzer::measure_regions(const Luminance& lum) const {
    Measurement m;
    regions(lum, m);
    return m;
}

}  // namespace glare
