// SPDX-License-Identifier: BSD-3-Clause
// See spectral_patterns.h.
#include "cal/spectral_patterns.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cal/spectrum.h"
#include "image/picture.h"

namespace cal {
namespace {

using Nodes = std::vector<int>;
using Weights = std::array<double, 3>;

// What a constant value between two wavelengths gives the three colours.
Weights band_weights(const Parts& p, double a, double b) {
    if (!p.spec.bands) return band_weight(a, b);
    const auto& of = p.spec.of_light ? p.spec.bands->light : p.spec.bands->surface;
    const double low = std::min(a, b), high = std::max(a, b);
    const double from = low <= spectrum::first_nm ? low - 1 : low, to = high >= spectrum::last_nm ? high + 1 : high;
    Weights w{0, 0, 0};
    for (size_t i = 0; i < of[0].size(); i++) {
        const double nm = spectrum::first_nm + double(i);
        const double inside = std::min(to, nm + .5) - std::max(from, nm - .5);
        for (size_t k = 0; k < 3 && inside > 0; k++) w[k] += of[k][i] * inside;
    }
    return w;
}

void add(Parts& p, int value, const Weights& w, Nodes& sum) {
    for (size_t k = 0; k < 3; k++)
        if (w[k] != 0 || !p.spec.bands) sum[k] = p.graph->add(sum[k], p.graph->mul(value, p.graph->constant(w[k])));
}

// A colour outside the triangle of the primaries is moved towards the grey of its luminance.
void inside_gamut(Parts& p, Nodes rgb, Nodes& out) {
    Graph& g = *p.graph;
    int y = g.constant(0);
    for (size_t k = 0; k < 3; k++) y = g.add(y, g.mul(rgb[k], g.constant(image::luminance_weights[k])));
    const int least = g.make(OP_MIN, g.make(OP_MIN, rgb[0], rgb[1]), rgb[2]);
    const int share =
        g.choose(g.make(OP_NEG, least), g.choose(y, g.make(OP_DIV, y, g.sub(y, least)), g.constant(0)), g.constant(1));
    for (int c : rgb) out.push_back(g.choose(y, g.add(y, g.mul(g.sub(c, y), share)), g.constant(0)));
}

// The sum of weighted values as a colour.
void put(Parts& p, const Nodes& sum, Nodes& out) {
    if (p.spec.bands) out = sum;
    else inside_gamut(p, sum, out);
}

// ---- spectra that are the same everywhere

void constant_spectrum(Parts& p, const std::function<double(double)>& f, Nodes& out) {
    Nodes rgb;
    for (double v : spectrum_rgb(f, 1)) rgb.push_back(p.graph->constant(v));
    inside_gamut(p, rgb, out);
}

void constant_in_bands(Parts& p, std::vector<double> nm, std::vector<double> values, Nodes& out) {
    if (nm.size() > 1 && nm.front() > nm.back()) {
        std::reverse(nm.begin(), nm.end());
        std::reverse(values.begin(), values.end());
    }
    const spectrum::Spectrum s = spectrum::of_samples(nm, values, p.spec.place);
    const spectrum::Bands& bands = *p.spec.bands;
    for (double v : p.spec.of_light ? colour_of_light(bands, s) : colour_of_surface(bands, s))
        out.push_back(p.graph->constant(v));
}

// ---- functions of the wavelength, for each point

template <class F>
void sampled_spectrum(Parts& p, double low, double high, F value, Nodes& out) {
    const double step_nm = p.spec.bands ? 5 : 10;
    Nodes sum(3, p.graph->constant(0));
    for (double nm = 380 + step_nm / 2; nm < 780; nm += step_nm) {
        if (nm < low || nm > high) continue;
        const Weights w =
            p.spec.bands ? band_weights(p, nm - step_nm / 2, nm + step_nm / 2) : spectrum_weight(nm, step_nm);
        if (p.spec.bands && w == Weights{0, 0, 0}) continue;
        add(p, value(p.graph->constant(nm)), w, sum);
    }
    put(p, sum, out);
}

}  // namespace

// Values at even steps from the first wavelength to the last, both included; 0 outside.
void spectrum_pattern(Parts& p, Nodes& out) {
    const std::vector<double>& r = p.spec.reals;
    if (r.size() < 5) p.fail("bad number of real arguments");
    const double first = r[0], last = r[1];
    if (first == last) p.fail("a spectrum needs two different wavelengths");
    if (r.size() == 5 && std::fabs(first - last) == 400 && std::fmax(first, last) == 780) {  // R, G, B themselves
        Nodes rgb;
        for (size_t k = 0; k < 3; k++) rgb.push_back(p.graph->constant(r[2 + (first > last ? k : 2 - k)]));
        out = in_bands(p, rgb);
        return;
    }
    const double intervals = double(r.size() - 3);
    if (p.spec.bands) {
        std::vector<double> nm;
        for (size_t i = 0; i + 2 < r.size(); i++) nm.push_back(first + (last - first) * double(i) / intervals);
        return constant_in_bands(p, nm, {r.begin() + 2, r.end()}, out);
    }
    constant_spectrum(
        p,
        [&](double nm) {
            const double t = (nm - first) / (last - first) * intervals;
            if (t < 0 || t > intervals) return 0.0;
            const size_t i = size_t(std::fmin(t, intervals - 1));
            return r[2 + i] + (r[3 + i] - r[2 + i]) * (t - double(i));
        },
        out);
}

void specfile_pattern(Parts& p, Nodes& out) {
    const DataFile data = p.read(0);
    if (data.dimensions.size() != 1) p.fail("a spectrum has one dimension, wavelength");
    const DataFile::Dimension& d = data.dimensions[0];
    if (p.spec.bands) {
        std::vector<double> nm;
        for (uint32_t i = 0; i < d.count; i++) nm.push_back(d.count > 1 ? d.at(i) : d.begin);
        return constant_in_bands(p, nm, {data.values.begin(), data.values.end()}, out);
    }
    constant_spectrum(
        p,
        [&](double nm) {
            for (uint32_t i = 0; i + 1 < d.count; i++) {
                const double t = (nm - d.at(i)) / (d.at(i + 1) - d.at(i));
                if (t >= 0 && t <= 1) return data.values[i] + (data.values[i + 1] - data.values[i]) * t;
            }
            return 0.0;
        },
        out);
}

void specfunc_pattern(Parts& p, Nodes& out) {
    if (p.spec.reals.size() < 2) p.fail("bad number of real arguments");
    p.file(1);
    p.no_more_than_transform(2);
    const double a = p.spec.reals[0], b = p.spec.reals[1];
    sampled_spectrum(
        p, std::fmin(a, b), std::fmax(a, b), [&](int nm) { return p.call(0, {nm}); }, out);
}

void specdata_pattern(Parts& p, Nodes& out) {
    p.file(2);
    const Nodes x = p.coordinates(3);
    const uint32_t table = p.data(1, x.size() + 1);
    sampled_spectrum(
        p, 380, 780,
        [&](int nm) {
            Nodes at = x;
            at.push_back(nm);
            return p.call(0, {p.graph->channel(p.graph->lookup(OP_DATA, at, table), 0), nm});
        },
        out);
}

// An RGB picture's channels stand for the middles of the bands 780-588, 588-480, 480-380.  In a hyperspectral one each
// band is constant over its wavelengths.
void specpict_pattern(Parts& p, Nodes& out) {
    const auto spectral = p.spectral(1);
    if (!spectral) {
        const double middles[3] = {684, 534, 430}, limits[4] = {780, 588, 480, 380};
        const Nodes rgb = picture_values(p, 1, 2);
        for (size_t k = 0; k < 3; k++) out.push_back(p.call(0, {rgb[k], p.graph->constant(middles[k])}));
        if (!p.spec.bands) return;
        const Nodes values = std::exchange(out, Nodes(3, p.graph->constant(0)));
        for (size_t k = 0; k < 3; k++) add(p, values[k], band_weights(p, limits[k], limits[k + 1]), out);
        return;
    }
    p.file(2);
    const Nodes x = p.coordinates(3);
    if (x.size() != 2) p.fail("a picture needs two coordinates");
    Nodes sum(3, p.graph->constant(0));
    const double width = (spectral->to - spectral->from) / spectral->bands;
    for (int band = 0; band < spectral->bands; band++) {
        const double begin = spectral->from + band * width;
        const Weights w = band_weights(p, begin, begin + width);
        if (p.spec.bands && w == Weights{0, 0, 0}) continue;
        const int look = p.graph->lookup(OP_DATA, {x[1], x[0]}, spectral->tables[size_t(band / 3)], 3);
        add(p, p.call(0, {p.graph->channel(look, band % 3), p.graph->constant(begin + width / 2)}), w, sum);
    }
    put(p, sum, out);
}

std::vector<int> in_bands(Parts& p, const std::vector<int>& rgb) {
    if (!p.spec.bands) return rgb;
    Graph& g = *p.graph;
    const int redder = g.sub(rgb[0], rgb[1]), bluer = g.sub(rgb[2], rgb[1]);
    Nodes out;
    for (size_t k = 0; k < 3; k++)
        out.push_back(g.add(rgb[1], g.add(g.mul(redder, g.constant(p.spec.bands->red[k])),
                                          g.mul(bluer, g.constant(p.spec.bands->blue[k])))));
    return out;
}

}  // namespace cal
