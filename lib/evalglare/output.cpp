// SPDX-License-Identifier: BSD-3-Clause
// Format strings are evalglare's, down to its blanks; the numbers come from measure.h.
#include "evalglare/output.h"
#include <algorithm>
#include <cmath>
#include <map>
#include <type_traits>
#include <fmt/printf.h>

namespace evalglare {

using namespace glare;
using OutputSettings = evalglare::Settings;

namespace {

// Where an operation is invalid, x86 gives -nan, and so do evalglare's recorded lines; other processors give nan.
template <class T>
T as_on_x86(T value) {
#ifndef __x86_64__
    if constexpr (std::is_same_v<T, double>)
        if (std::isnan(value)) return -value;
#endif
    return value;
}

template <class... Values>
std::string print(const char* format, const Values&... values) {
    return fmt::sprintf(format, as_on_x86(values)...);
}

// L^2 w / P^2 of all sources, whatever -w says; evalglare's total is the one of the sources before zones split them.
double sum_of_terms(const Measurement& m) {
    double sum = 0;
    if (m.sources_before_zones.empty()) {
        for (const GlareTerm& o : m.glare) sum += dgp_term(o, {});
    } else {
        for (const GlareSource& o : m.sources_before_zones) sum += dgp_term({o.lum, o.omega, o.P, 0, 0, 0}, {});
    }
    return sum;
}

// DGP share of one source: alone over the total, log10 of each (r_contrast), and in units of DGP (r_dgp).
struct Shares {
    double contrast, dgp;
};
Shares shares_of(const GlareTerm& s, double sum, const Measurement& m, const DgpConstants& k) {
    const double scale = std::pow(m.ev, k.a3);
    const double alone = std::log10(1 + dgp_term(s, {}) / scale);
    return {alone / std::log10(1 + sum / scale), k.c2 * alone / m.dgp_computed};
}

std::string statistics_line(const PixelStatistics& a) {
    if (a.pixels == 0) return print("%f %f %f %f %f %f %f %f", a.omega, a.mean, 0., 0., 0., 0., 0., 0.);
    return print("%f %f %f %f %f %f %f %f", a.omega, a.mean, a.median, a.deviation, a.p75, a.p95, a.lowest, a.highest);
}

std::string zone_line(const PixelStatistics& a, int zone, long count, const char* gap) {
    const std::string z = "z" + std::to_string(zone);
    return print(
               "zoning:%s_omega,%s_av_lum,%s_median_lum,%s_std_lum,%s_perc_75,%s_perc_95,%s_lum_min,%s_lum_max,E%s,i_%"
               "s:%s",
               z, z, z, z, z, z, z, z, z, z, gap) +
           statistics_line(a) + print(" %f %d\n", a.eye_lux, count);
}

std::string source_lines(const Measurement& m, const glare::Settings& settings, int height) {
    std::string out = print(
        "%d No pixels x-pos y-pos L_s Omega_s Posindx L_b L_t E_v Edir Max_Lum Sigma xdir ydir zdir Eglare "
        "Lveil_cie teta glare_zone r_contrast r_dgp\n",
        int(m.sources.size()));
    const double sum = sum_of_terms(m);
    for (size_t i = 0; i < m.sources.size(); ++i) {
        const GlareSource& s = m.sources[i];
        const GlareTerm& g = m.glare[i];
        const Shares share = shares_of(g, sum, m, settings.constants);
        out += print("%d %f %f %f %f %.10f %f %f %f %f %f %f %f %f %f %f %f %f %f %d %f %f \n", int(i + 1), s.pixels,
                     s.x, height - s.y, s.lum, s.omega, s.P, m.background, m.task_lum, m.ev, m.direct_lux, m.max_lum,
                     s.sigma_deg, s.direction.x, s.direction.y, s.direction.z, s.eye_lux,
                     veil_cie({g}, settings.formulas.veil_cut), g.theta_deg, s.zone, share.contrast, share.dgp);
    }
    if (m.sources.empty()) {
        out += print("%d %f %f %f %f %.10f %f %f %f %f %f %f", 0, 0., 0., 0., 0., 0., 0., m.background, m.task_lum,
                     m.ev, m.direct_lux, m.max_lum);
        for (int k = 0; k < 11; ++k) out += print(" %f", 0.);
        out += "\n";
    }
    return out;
}

// evalglare divides the mean of L/P^2 by the solid angle twice.
std::string summary_line(const Measurement& m, const Reading& reading) {
    double flux = 0, omega = 0;
    for (const GlareSource& s : m.sources) flux += s.lum * s.omega, omega += s.omega;
    const double d = dgr(m.glare, m.mean_lum);
    const double values[] = {m.dgp,
                             m.mean_lum,
                             m.ev,
                             m.background,
                             m.direct_lux,
                             dgi(m.glare, m.background),
                             ugr(m.glare, m.background),
                             vcp(m.glare, d),
                             cgi(m.glare, m.direct_lux, m.ev),
                             m.sources.empty() ? 0 : flux / omega,
                             omega,
                             veil_poynter(m.glare),
                             veil_cie(m.glare, reading.plan().settings.formulas.veil_cut),
                             d,
                             ugp(m.glare, m.background),
                             ugr_exp(m.glare, m.background0, m.ev),
                             dgi_mod(m.glare, m.background, m.ev),
                             m.mean_pos,
                             m.mean_pos2 / reading.geometry().omega_sum,
                             m.median,
                             m.median_pos,
                             m.median_pos2,
                             ugp2(m.glare, m.background)};
    std::string out =
        "dgp,av_lum,E_v,lum_backg,E_v_dir,dgi,ugr,vcp,cgi,lum_sources,omega_sources,Lveil,Lveil_cie,dgr,ugp,ugr_exp,"
        "dgi_mod,"
        "av_lum_pos,av_lum_pos2,med_lum,med_lum_pos,med_lum_pos2,ugp2:";
    for (double v : values) out += print(" %f", v);
    return out + "\n";
}

// Quantities that the fast modes do not calculate are 0 in their lines.
Measurement as_fast(Measurement m) {
    m.ev = m.eye_lux_used;
    m.background = m.direct_lux = m.max_lum = 0;
    for (GlareSource& s : m.sources) s.eye_lux = 0;
    for (GlareTerm& s : m.glare) s.eye_lux = 0;
    return m;
}

std::string fast_line(const Measurement& m, bool short_line) {
    if (short_line) return print("%f\n", m.dgp);
    return print("%f %f \n", m.dgp, ugr(m.glare, m.background));
}

// -z angle 3: a line for each patch, then one for each bright pixel of each patch.
std::string patch_lines(const Measurement& m, const Geometry& g) {
    std::string out;
    std::map<uint32_t, int> number;  // of the live groups
    for (const GlareSource& s : m.sources) {
        const int n = int(number.size()) + 1;
        number[s.group] = n;
        out += print("%d %f %f %f %f %.10f %f %f %f %f \n", n, s.pixels, s.x, s.y, s.lum, s.omega, s.P, s.direction.x,
                     s.direction.y, s.direction.z);
    }
    std::vector<Run> runs = m.runs;  // rows from the bottom, each from the left
    std::sort(runs.begin(), runs.end(), [&](const Run& a, const Run& b) {
        const int ya = g.y_of(a.start), yb = g.y_of(b.start);
        return ya != yb ? ya < yb : a.start < b.start;
    });
    for (const Run& r : runs)
        for (uint32_t p = r.start; p < r.start + r.length; ++p) {
            const Vec3 d = g.direction(p);
            out += print("%d %d %f %f %f \n", int(r.group), number[r.group], d.x, d.y, d.z);
        }
    return out;
}

std::string black_corners(double percent, bool stopping) {
    return print(
               " corner pixels are to  %f %% black! \nerror! The image has black corners AND header contains a "
               "perspective view type "
               "definition !!!\n",
               percent) +
           (stopping ? "stopping...!!!!\n" : "");
}

}  // namespace

std::string stdout_text(const base::Error& refusal) {
    if (const auto* corners = dynamic_cast<const BlackCorners*>(&refusal)) return black_corners(corners->percent, true);
    const auto* sizes = dynamic_cast<const MaskSize*>(&refusal);
    return sizes ? print("resolution main image : %dx%d\nresolution masking image : %dx%d\n", sizes->width,
                         sizes->height, sizes->mask_width, sizes->mask_height)
                 : "";
}

std::string lines(const Measurement& m, const OutputSettings& out, const Reading& reading) {
    const glare::Settings& settings = reading.plan().settings;
    std::string text;
    if (m.black_corners && *m.black_corners > 70) text += black_corners(*m.black_corners, false);
    if (out.ev_only && !out.fast) return text + print("%f\n", m.ev);
    if (settings.patches && settings.patches->mode == 3) return text + patch_lines(m, reading.geometry());
    if (m.band)
        text +=
            "band:band_omega,band_av_lum,band_median_lum,band_std_lum,band_perc_75,band_perc_95,band_lum_min,band_lum_"
            "max: " +
            statistics_line(*m.band) + "\n";
    if (out.fast == 3) return text;
    const bool detailed = out.detailed || m.mask;
    if (m.mask)
        text += print(
                    "masking:no_pixels,omega,av_lum,median_lum,std_lum,perc_75,perc_95,lum_min,lum_max,pgsv_con,pgsv_"
                    "sat,pgsv,Ev_mask: %d ",
                    m.mask->pixels) +
                statistics_line(*m.mask) +
                print(" %f %f %f %f\n", m.pgsv.contrast, m.pgsv.saturation, m.pgsv.value, m.mask->eye_lux);
    if (detailed && m.zone1) text += zone_line(*m.zone1, 1, m.zone1->pixels, " ");
    if (detailed && m.zone2) text += zone_line(*m.zone2, 2, m.zone1->pixels, "  ");  // evalglare repeats zone 1's count
    if (out.fast)
        return text + (detailed ? source_lines(as_fast(m), settings, reading.lum.height) : "") +
               fast_line(m, out.fast == 1 || !settings.external_ev);
    if (detailed) return text + source_lines(m, settings, reading.lum.height) + summary_line(m, reading);
    const double ugr_value = ugr(m.glare, m.background), dgi_value = dgi(m.glare, m.background);
    const double vcp_value = vcp(m.glare, dgr(m.glare, m.mean_lum)), cgi_value = cgi(m.glare, m.direct_lux, m.ev);
    const double veil = veil_poynter(m.glare);
    if (out.dgp_and_ev) {
        const double corrected = m.dgp_computed * (settings.low_light ? low_light_factor(m.ev) : 1);
        return text + print("dgp,dgi,ugr,vcp,cgi,dgp_ext,Ev_calc,abs_max,Lveil: %f %f %f %f %f %f %f %f %f \n",
                            corrected, dgi_value, ugr_value, vcp_value, cgi_value, 0., m.ev, m.max_lum, veil);
    }
    return text + print("dgp,dgi,ugr,vcp,cgi,Lveil: %f %f %f %f %f %f  \n", m.dgp, dgi_value, ugr_value, vcp_value,
                        cgi_value, veil);
}

}  // namespace evalglare
