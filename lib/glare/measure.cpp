// SPDX-License-Identifier: BSD-3-Clause
// Calculates each required quantity once, in the order of their dependence (measure.h).
#include "glare/measure.h"
#include <algorithm>
#include <cmath>
#include <functional>
#include "glare/filled.h"
#include "glare/threshold.h"

namespace glare {
namespace {

// The images of a measurement, and what -I and -G make of them: then copies.
struct Images {
    Luminance lum, classification;
    std::vector<float> own_lum, own_classification;
    void change(const std::function<std::vector<float>(const Luminance&)>& changed) {
        const bool one = classification.grey == lum.grey;
        own_lum = changed(lum), lum.grey = own_lum.data();
        if (!one) own_classification = changed(classification);
        classification.grey = one ? lum.grey : own_classification.data();
    }
};

// Gain of a sum over pixels, all or those above a luminance, where drawn sources are at their place.
double gain_of_place(const Reading& r, const Luminance& lum, const Luminance& classification_image, double above) {
    double lux = 0;
    for (const DrawnPixel& p : r.drawn_pixels)
        if (classification_image.at(p.pixel) > above)
            lux += lum.at(p.pixel) * (p.omega_cos - r.geometry().omega_cos[p.pixel]);
    return lux;
}

// Means and medians of L, L/P and L/P^2.
void position_statistics(const ViewTables& tables, const Luminance& lum, Measurement& m) {
    const Geometry& g = *tables.geometry;
    std::vector<float> values;
    values.reserve(g.valid_count);
    double sum1 = 0, sum2 = 0;
    for (int power = 0; power <= 2; ++power) {
        values.clear();
        for (size_t i = 0; i < g.omega.size(); ++i) {
            if (!g.valid(i)) continue;
            const double P = tables.position_index[i], L = lum.at(i);
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
    m.settings = settings.formulas;
    m.sources = found.sources;
    m.direct_lux = found.direct_lux;
    m.glare = glare_terms(lum, classification_image, g, settings, threshold, m.sources);
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

Glare filled_glare(const Reading& r, const Images& images, const Measurement& m, const FindSources& find_sources) {
    const Geometry& g = r.placed_geometry ? *r.placed_geometry : r.geometry();
    Luminance classification = images.classification;
    classification.moments = images.lum.moments;
    FilledPixels own = filled_pixels(images.lum), classified;
    const bool one = classification.grey == images.lum.grey;
    if (!one) classified = filled_pixels(classification);
    const Luminance light = own.as(images.lum), bright = one ? light : classified.as(classification);
    Photometry photometry = m;
    photometry.ev = m.placed_ev;
    const Sources found = find_sources(light, bright, g, m.threshold, {});
    return glare_of(light, bright, g, r.plan().settings, r.plan().methods, photometry, found, m.task_lum, m.threshold);
}

void measure_glare(const Reading& r, Images& images, Measurement& m) {
    const Geometry& g = r.geometry();
    const Settings& settings = r.plan().settings;
    if (settings.field_cut)
        images.change([&](const Luminance& image) { return cut_field(image, g, settings.field_cut); });
    const Luminance &lum = images.lum, &classification_image = images.classification;
    const bool has_task = settings.task || !settings.task_region.empty();
    double task_lum = r.plan().methods.reference_luminance(lum, g, settings, m.mean_lum);
    for (size_t k = 0; k < r.tables->regions.size() && !settings.task; ++k)
        if (r.plan().regions->masks[k].name == settings.task_region) task_lum = r.tables->regions[k].tal(lum);
    task_lum = float(task_lum);
    const double threshold = source_threshold(settings, has_task, task_lum);

    Sources found = r.tables->find_sources(lum, classification_image, g, threshold, r.tables->sets);
    static_cast<Glare&>(m) =
        glare_of(lum, classification_image, g, settings, r.plan().methods, m, found, task_lum, threshold);
    static_cast<SetStatistics&>(m) = found.sets;
    m.runs = std::move(found.runs), m.runs_before_zones = std::move(found.runs_before_zones);
    m.sources_before_zones = std::move(found.before_zones);
    m.placed_direct_lux = m.direct_lux + gain_of_place(r, lum, classification_image, threshold);
    if (r.plan().requirements & require::filled && lum.moments && !settings.field_cut && !settings.fill)
        m.filled = filled_glare(r, images, m, r.tables->find_sources);
    if (m.mask) m.pgsv = pgsv(*m.mask, m.mean_lum, m.ev, has_task, m.task_lum);
}

struct Filled {
    bool is_drawn = false;           // by area
    bool is_sampled = false;         // its variance is that of samples
    double mean = 0, luminance = 0;  // of the pixel; on the share of it that is filled
    double beside = 0;               // the largest luminance of what is drawn in the pixels around
};
Filled filled_pixel(const Reading& r, size_t i) {
    const float* const of = &(*r.lum.moments)[image::moment_numbers * i];
    Filled f;
    f.is_drawn = of[image::moment_right] != 0 || of[image::moment_up] != 0;
    f.is_sampled = of[image::moment_difference] != 0;
    f.mean = f.luminance = r.lum.at(i);
    if (const double m1 = r.lum.grey[i]; m1 > 0) f.luminance *= 1 + of[image::moment_variance] / (m1 * m1);
    return f;
}
Filled filled_among_others(const Reading& r, size_t i) {
    Filled f = filled_pixel(r, i);
    if (!f.is_drawn) return f;
    const long width = r.lum.width, x = long(i) % width, y = long(i) / width;
    for (long v = std::max(0L, y - 1); v <= std::min(r.lum.height - 1L, y + 1); ++v)
        for (long u = std::max(0L, x - 1); u <= std::min(width - 1, x + 1); ++u)
            if (const Filled other = filled_pixel(r, size_t(v * width + u)); other.is_drawn)
                f.beside = std::max(f.beside, other.luminance);
    return f;
}

// Moments with so much of the variance of each pixel; null: nothing changes.
image::Moments with_variance(const Reading& r, double (*kept)(const Filled&)) {
    std::shared_ptr<std::vector<float>> out;
    for (size_t i = 0; i < r.lum.size(); ++i) {
        const double part = kept(filled_among_others(r, i));
        if (part == 1) continue;
        if (!out) out = std::make_shared<std::vector<float>>(*r.lum.moments);
        (*out)[image::moment_numbers * i + image::moment_variance] *= float(part);
    }
    return out;
}

constexpr double least_sun_cdm2 = 5e5;  // a thousandth of the sun; no lamp is so bright

// Highlights of rough surfaces in the sun are not drawn, and are brightest in their middle: filled evenly, one that is
// narrower than its pixel counts for more than the larger and less bright source of a larger picture; spread over its
// pixel, for less.
double without_highlights(const Filled& f) {
    constexpr double narrow = .5;  // share of the pixel
    const bool is_narrow = f.mean < narrow * f.luminance;
    return !f.is_drawn && f.is_sampled && is_narrow && f.luminance > least_sun_cdm2 ? 0 : 1;
}

// Of light other than a sun that is drawn a larger picture may show that it is less even, or that what lies beside it
// in the pixel joins its source.
double less_filled(const Filled& f) {
    const bool is_sun = f.is_drawn && f.luminance > least_sun_cdm2, is_exact = !f.is_drawn && !f.is_sampled;
    return is_sun || is_exact ? 1 : 2. / 3;
}

// A corner of the sun in a bright pixel counts as light that is less bright than the sun and fills more; a larger
// picture has it with the luminance of the other part.
double whole_suns(const Filled& f) {
    constexpr double even = 1.1;  // the disc's parts differ by no more
    if (!f.is_drawn || f.beside < std::max(least_sun_cdm2, even * f.luminance)) return 1;
    return (f.beside - f.mean) / (f.luminance - f.mean);
}

}  // namespace

Measurement measure(const Reading& r) {
    Measurement m = measure(r, r.lum, r.lum);
    if (!m.filled || r.tables->find_by_other_reach.empty()) return m;
    for (const FindSources& find : r.tables->find_by_other_reach)
        m.of_other_reach.push_back(filled_glare(r, {r.lum, r.lum, {}, {}}, m, find));
    for (const auto kept : {without_highlights, less_filled, whole_suns}) {
        Luminance other = r.lum;
        other.moments = with_variance(r, kept);
        if (other.moments) m.of_other_reach.push_back(measure_filled(r, other, m));
    }
    return m;
}

Glare measure_filled(const Reading& r, const Luminance& lum, const Measurement& m) {
    return filled_glare(r, {lum, lum, {}, {}}, m, r.tables->find_sources);
}

double off_by_reach(const Measurement& m, double (*value)(const Glare&)) {
    if (!m.filled) return std::nan("");
    double most = 0;
    for (const Glare& other : m.of_other_reach)
        if (const double off = value(other) - value(*m.filled); std::fabs(off) > std::fabs(most)) most = off;
    return most;
}

Measurement measure(const Reading& r, const Luminance& lum, const Luminance& classification_image) {
    const Plan& plan = r.plan();
    Images images{lum, classification_image, {}, {}};
    if (plan.settings.fill)
        images.change([&](const Luminance& image) { return fill_rows(image, r.geometry(), *plan.settings.fill); });
    Measurement m = measure_regions(r, images.lum);
    m.not_finite = lum.not_finite;
    m.negative = lum.negative;
    m.settings = plan.settings.formulas;
    m.black_corners = r.black_corners;
    static_cast<Photometry&>(m) = plan.methods.photometry(images.lum, r.geometry(), plan.settings);
    m.placed_ev = m.ev + gain_of_place(r, images.lum, images.lum, 0);
    if (plan.requirements & require::rammg) m.rammg = rammg(images.lum, *r.tables->pyramid);
    if (plan.requirements & require::medians) position_statistics(*r.tables, images.lum, m);
    if (plan.requirements & require::sources) measure_glare(r, images, m);
    return m;
}

Measurement measure_regions(const Reading& r, const Luminance& lum) {
    Measurement m;
    for (const RegionPixels& region : r.tables->regions) {
        m.region_values.emplace_back();
        if (r.plan().requirements & require::regions_in_full) m.region_values.back() = region.measure(lum);
        else m.region_values.back().tal = region.tal(lum);
    }
    return m;
}

}  // namespace glare
