// SPDX-License-Identifier: BSD-3-Clause
// Settings of a measurement.  Letters and defaults are evalglare's.  Angles named `opening` are full opening
// angles in radians, as for evalglare's -t, -l, -r.
#pragma once
#include <limits>
#include <optional>
#include <string>
#include "base/error.h"
#include "glare/formulas.h"
#include "view/position_index.h"
#include "glare/rammg.h"

namespace glare {
using view::PositionModel;

struct Circle {
    int x = 0, y = 0;  // y from the bottom
    double opening = 0;
};
struct Zones {
    Circle inner;
    std::optional<double> outer_opening;
};
struct Fill {
    int y_max = 0, y_min = 0;
};
struct Patches {
    double angle_deg = 0;
    int mode = 1;
};

enum class DgpForm {
    merged,  // sources found and merged as evalglare does
    pixel,   // every bright pixel is a source of its own
};

// What formulas are given besides the picture; each reads it in `settings` of its Glare or Measurement.
struct FormulaSettings {
    double veil_cut = -std::numeric_limits<double>::infinity();  // -k: terms of LveilCIE up to it do not count
};

struct Settings {
    std::optional<double> threshold;               // -b: up to 100 a factor of the reference luminance, above it cd/m2
    double search_opening = 0.2;                   // -r
    bool smooth = false;                           // -s
    bool peaks = true;                             // -x off, -y on
    double peak_limit = 50000;                     // -Y, cd/m2
    std::optional<Circle> task;                    // -t, -T
    std::string task_region;                       // -task NAME
    int field_cut = 0;                             // -G 1, 2, 3
    int background = 0;                            // -q 0, 1, 2
    bool low_light = false;                        // -C l+
    std::optional<double> external_ev;             // -i, -I
    std::optional<Fill> fill;                      // -I
    PositionModel position = PositionModel::guth;  // -P 1: kim
    FormulaSettings formulas;
    DgpConstants constants;  // -w
    DgpForm dgp_form = DgpForm::merged;
    std::optional<Patches> patches;        // -z
    std::optional<Zones> zones;            // -l, -L
    std::optional<double> band_rad;        // -B: half height
    std::optional<std::string> mask_file;  // -A
    bool force = false;                    // -f: a perspective picture with black corners is measured
    RammgArea rammg_area = RammgArea::view;
};

// Limits of pictures.
struct BlackCorners : base::Error {
    double percent;
    BlackCorners(std::string place, double black_percent)
        : base::Error(base::Kind::input, std::move(place),
                      "the view is perspective (-vtv) but " + std::to_string(int(black_percent)) +
                          " % of the corners are black, as in a fisheye picture; correct the view with -vt, or "
                          "use -f to measure it all the same"),
          percent(black_percent) {}
};
struct MaskSize : base::Error {
    int width, height, mask_width, mask_height;
    MaskSize(std::string place, int w, int h, int mask_w, int mask_h)
        : base::Error(base::Kind::input, std::move(place),
                      "the mask has " + std::to_string(mask_w) + " x " + std::to_string(mask_h) +
                          " pixels, the picture " + std::to_string(w) + " x " + std::to_string(h)),
          width(w),
          height(h),
          mask_width(mask_w),
          mask_height(mask_h) {}
};

// Quantities to calculate beyond Ev and the luminance statistics, which are always there: bits of Requirements.
using Requirements = unsigned;
namespace require {
constexpr Requirements sources = 1, rammg = 2, medians = 4,
                       mask = 8,  // -A
    all_light = 16,               // all light at the eye; a narrow view shows only a part of it
    filled = 32,                  // also sources of filled pixels (filled.h)
    regions_in_full = 64,         // more than their TAL
    reach = 128;                  // also filled sources that are joined from nearer and farther
}

}  // namespace glare
