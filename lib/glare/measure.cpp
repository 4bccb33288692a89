// SPDX-License-Identifier: BSD-3-Clause
// Calculates each required quantity once, in the order of their dependence (measure.h).
#include "glare/measure.h"
#include <algorithm>
#include <cmath>
#include "base/angle.h"
#include "base/error.h"
#include "base/split.h"
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

PictureAnalyzer::PictureAnalyzer(const Settings& settings, const Requirements& requirements,
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

void PictureAnalyzer::set_regions(image::MaskSet regions, image::DrawRegions draw, const Requirements& requirements) {
    const std::vector<std::string> names = names_of(regions);
    require_task(settings_, names);
    if (geometry_) region_pixels_ = lay(regions, draw, "regions");
    regions_ = std::move(regions), draw_ = std::move(draw);
    region_names_ = names;
    requirements_.regions_in_full = requirements.regions_in_full;
}

void PictureAnalyzer::prepare(const view::View& view, const image::Picture& picture, const std::string& place) {
    if (geometry_ && geometry_->fits(view, picture.width, picture.height)) return;
    if (view.type == 'l') base::fail(place, "a parallel view (-vtl) has no eye point: glare is not defined for it");
    try {
        view::validate(view);
    } catch (const base::Error& e) {
        base::fail(place, std::string("the view cannot be used: ") + e.what());
    }
    finder_.reset();
    placed_geometry_.reset(), drawn_pixels_.clear(), moments_.reset();
    geometry_.reset();
    auto rays = methods_.geometry ? methods_.geometry(view, place) : std::make_unique<const ViewGeometry>(view);
    geometry_ = std::make_unique<Geometry>(std::move(rays), picture.width, picture.height);
    narrow_ = requirements_.all_light && geometry_->share_of_light() < .9;
    finder_ = make_finder();
    if (requirements_.rammg) pyramid_ = std::make_unique<Pyramid>(*geometry_, settings_.rammg_area);
    find_position_index();
    mask_.reset();
    region_pixels_.clear();
    if (regions_) region_pixels_ = lay(*regions_, draw_, place);
}

void PictureAnalyzer::find_position_index() {
    const Geometry& g = *geometry_;
    position_index_.assign(requirements_.medians ? g.omega.size() : 0, 0);
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

void PictureAnalyzer::background_and_dgp(const SourceFinder& finder, Measurement& m) const {
    const double rest_lux = m.ev - m.direct_lux;
    m.background0 = finder.nothing_left(std::fabs(rest_lux), m.ev) ? 0 : rest_lux / evalglare_pi;
    m.background = m.background0;
    if (settings_.background == 1) {
        double flux = 0, omega = 0;
        for (const GlareSource& s : m.sources) flux += s.lum * s.omega, omega += s.omega;
        const double rest = m.omega - omega;
        m.background = finder.nothing_left(rest, m.omega) ? m.mean_lum : (m.omega * m.mean_lum - flux) / rest;
    } else if (settings_.background == 2) {
        m.background = m.ev / evalglare_pi;
    }
    m.eye_lux_used = settings_.external_ev.value_or(m.ev);
    m.dgp_computed = dgp(m.glare, m.ev, settings_.constants);
    m.dgp = dgp(m.glare, m.eye_lux_used, settings_.constants) *
            (settings_.low_light ? low_light_factor(m.eye_lux_used) : 1);
}

void PictureAnalyzer::glare(Luminance& lum, Luminance& classification_image, SourceFinder& finder,
                            Measurement& m) const {
    const Geometry& g = *geometry_;
    if (settings_.field_cut) cut_field(lum, g, settings_.field_cut);
    if (settings_.field_cut && &classification_image != &lum) cut_field(classification_image, g, settings_.field_cut);
    const bool has_task = settings_.task || !settings_.task_region.empty();
    m.task_lum = finder.reference_luminance(lum, m.mean_lum);
    for (size_t k = 0; k < region_names_.size() && !settings_.task; ++k)
        if (region_names_[k] == settings_.task_region) m.task_lum = region_pixels_[k].tal(lum);
    m.task_lum = float(m.task_lum);
    m.threshold = source_threshold(settings_, has_task, m.task_lum);

    if (settings_.zones && (settings_.zones->inner.x < 0 || settings_.zones->inner.y < 0 ||
                            settings_.zones->inner.x >= g.width || settings_.zones->inner.y >= g.height))
        base::fail("-l", "the zone's centre is outside the picture");
    if (requirements_.filled && lum.moments && !settings_.field_cut && !settings_.fill)
        m.filled = std::make_shared<const Measurement>(measure_filled(lum, classification_image, finder, m));
    finder.find_groups(lum, classification_image, m.threshold);
    pixel_sets(lum, finder, m);
    m.sources = finder.split(lum);
    m.direct_lux = finder.direct_lux();
    m.placed_direct_lux = m.direct_lux + gain_of_place(lum, classification_image, m.threshold);
    m.glare = glare_terms(lum, classification_image, g, settings_, m.threshold, m.sources);
    m.any_source = !m.sources.empty();
    background_and_dgp(finder, m);
    if (m.mask) m.pgsv = pgsv(*m.mask, m.mean_lum, m.ev, has_task, m.task_lum);
}

// Statistics of band, mask and zones, before zones split the sources.
void PictureAnalyzer::pixel_sets(const Luminance& lum, SourceFinder& finder, Measurement& m) const {
    const Geometry& g = *geometry_;
    if (settings_.band_rad) {
        const std::vector<uint32_t> band = band_pixels(g, *settings_.band_rad);
        m.band = finder.statistics(band, lum);
        finder.mark_band(band);
    }
    if (mask_) m.mask = finder.statistics(*mask_, lum);
    if (!settings_.zones) return;
    m.zone1 = finder.statistics(zone_pixels(g, *settings_.zones, 1), lum);
    if (settings_.zones->outer_opening) m.zone2 = finder.statistics(zone_pixels(g, *settings_.zones, 2), lum);
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
    if (requirements_.filled && !lum.moments && !std::exchange(told_no_moments_, true))
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
    if (settings_.mask_file && requirements_.sources && !mask_) mask_ = mask_pixels(*settings_.mask_file, *geometry_);
    Measurement m = measure(lum, lum, *finder_);
    m.black_corners = black_corners;
    return m;
}

Measurement PictureAnalyzer::measure(Luminance& lum, Luminance& classification_image, SourceFinder& finder) const {
    Measurement m;
    m.not_finite = lum.not_finite;
    m.negative = lum.negative;
    if (settings_.fill) fill_rows(lum, *geometry_, *settings_.fill);
    if (settings_.fill && &classification_image != &lum) fill_rows(classification_image, *geometry_, *settings_.fill);
    static_cast<Photometry&>(m) = finder.photometry(lum);
    m.placed_ev = m.ev + gain_of_place(lum, lum, 0);
    regions(lum, m);
    if (requirements_.rammg) m.rammg = rammg(lum, *pyramid_);
    if (requirements_.medians) position_statistics(lum, m);
    if (requirements_.sources) glare(lum, classification_image, finder, m);
    return m;
}

std::unique_ptr<SourceFinder> PictureAnalyzer::make_finder(const Geometry& geometry) const {
    if (methods_.finder) return methods_.finder(geometry, settings_);
    return std::make_unique<ConnectedSources>(geometry, settings_);
}

std::unique_ptr<SourceFinder> PictureAnalyzer::make_finder() const { return make_finder(*geometry_); }

void PictureAnalyzer::regions(const Luminance& lum, Measurement& m) const {
    for (const RegionPixels& r : region_pixels_) {
        m.region_values.emplace_back();
        if (requirements_.regions_in_full) m.region_values.back() = r.measure(lum);
        else m.region_values.back().tal = r.tal(lum);
    }
}

Measurement PictureAnalyzer::measure_regions(const Luminance& lum) const {
    Measurement m;
    regions(lum, m);
    return m;
}

}  // namespace glare
