// SPDX-License-Identifier: BSD-3-Clause
// Measures one picture.
//   Ev = sum L w cos (paper Eq. 1), DGP (Eq. 2 with evalglare's constants), RAMMG (Eqs. 5, 6), TAL and CR (Eqs. 3, 4).
#pragma once
#include <optional>
#include <vector>
#include "glare/reading.h"
#include "glare/statistics.h"

namespace glare {

// Glare sources and the light beside them: of whole pixels, as evalglare has it, or of
// filled ones.  A formula of this alone has a meaning for both (columns.cpp).
struct Glare : Photometry {
    double task_lum = 0;  // reference luminance of the threshold: task area, else the mean
    double threshold = 0;
    double direct_lux = 0, background = 0, background0 = 0;  // background0: as with -q 0
    std::vector<GlareSource> sources;
    GlareTerms glare;         // the same, for the formulas (or every bright pixel)
    double dgp = 0;           // with the external Ev if there is one, corrected, at most 1
    double dgp_computed = 0;  // with the computed Ev, before corrections
    double eye_lux_used = 0;  // Ev used for `dgp`
    FormulaSettings settings;
};

struct Measurement : Glare, SetStatistics {
    std::optional<Glare> filled;  // by filled pixels (filled.h); none: not required, or the picture has no moments
    // The same with sources that are joined from nearer, and from farther (require::reach).  A gap
    // between two of them is known to a pixel, so that a larger picture may join or part them.
    std::vector<Glare> of_other_reach;
    // Ev and Edir with drawn sources at their place in the pixel; `ev` and `direct_lux` take its centre, as evalglare
    // does.
    double placed_ev = 0, placed_direct_lux = 0;
    long not_finite = 0, negative = 0;
    double rammg = 0;
    double mean_pos = 0, mean_pos2 = 0, median = 0, median_pos = 0, median_pos2 = 0;  // of L, L/P, L/P^2
    std::vector<RegionValues> region_values;
    Pgsv pgsv{0, 0, 0};
    std::optional<double> black_corners;       // percent, type v
    std::vector<Run> runs, runs_before_zones;  // pixels of sources (sources.h)
    std::vector<GlareSource> sources_before_zones;
};

// No light reaches the eye, and glare means nothing; and the likely reasons.
inline bool is_black(const Photometry& m) { return !(m.max_lum > 0); }
constexpr const char* why_black =
    "it is night, the eye is in a solid or below the ground, or the scene has no sky and no lamp";

Measurement measure(const Reading& reading);
// Filled pixels of that picture by other moments; m: its measurement, which has filled ones.
Glare measure_filled(const Reading& reading, const Luminance& lum, const Measurement& m);
// Most that a formula of filled pixels is off with another reach, 0 where that joins and parts no sources; nan: there
// are none.
double off_by_reach(const Measurement& m, double (*value)(const Glare&));
// Another image of the same view, on any thread.  classification_image: decides which pixels are bright.
Measurement measure(const Reading& reading, const Luminance& lum, const Luminance& classification_image);
// Values of regions only.
Measurement measure_regions(const Reading& reading, const Luminance& lum);

}  // namespace glare
