// SPDX-License-Identifier: BSD-3-Clause
// Columns of vcmetrics by name, and the quantities that each one requires.  To add a metric: CONTRIBUTING.md.
#pragma once
#include <functional>
#include <string>
#include <vector>
#include "glare/measure.h"

namespace glare {

// Effect of noise on a metric, by which lib/report chooses the error estimate.
enum class Noise {
    no_interval,   // intervals are not known, or were not shown to hold
    bias_alone,    // as glare, without an interval
    linear,        // no bias
    dgp,           // linear and squared terms of luminance
    glare,         // squares of luminance: bias proportional to the variance of the noise
    contrast,      // absolute differences: bias proportional to the deviation of the noise; no interval
    region,        // mean of a region: few pixels, skewed
    region_ratio,  // ratio of two
};

inline bool has_interval(Noise n) { return n != Noise::no_interval && n != Noise::bias_alone && n != Noise::contrast; }
inline bool has_bias(Noise n) { return n != Noise::no_interval && n != Noise::linear && n != Noise::region; }

struct Column {
    std::string name;
    std::function<double(const Measurement&)> value;
    Noise noise = Noise::no_interval;
    bool printed_unbiased = false;       // DGPu, CRu: the column shows the value without bias
    bool of_filled = false;              // DGPf, DGP.px: with the bias, where it is unknown
    bool printed = true;                 // false: it serves a stopping rule only
    const char* const* words = nullptr;  // class: the value is an index of these
    bool has_interval() const { return glare::has_interval(noise); }
    // The interval is around the value without bias.
    bool has_bias() const { return glare::has_bias(noise); }
};

struct ColumnChoice {
    std::vector<std::string> names;    // of -metrics, empty: the default set
    std::vector<std::string> hidden;   // not printed
    std::vector<std::string> regions;  // in the order of the file
    bool regions_come = false;         // true: if there are none yet, "TAL" stands for no column
    std::vector<ContrastPair> pairs;
    bool pairs_come = false;  // the same of pairs and "CR"
    bool accelerad = false;   // AcceleradRT's columns and its contrast ratio, high over low; names are ignored
};

// Names without a region (TAL, mean, median, min, max, share) stand for all regions, CR for all pairs.  Throws Error on
// an unknown name, with a list of the known ones.
std::vector<Column> choose_columns(const ColumnChoice& choice, const Settings& settings, Requirements& requirements);

// The column of the error that pixels cause in a metric, "DGP.px"; empty: there is none, or it has no interval.
std::string pixels_column(const std::string& metric);

// By how much its values may differ where two inputs are compared: the wider of an amount and a share of the value.
struct DefaultTolerance {
    double amount = 0, share = 1e-4;
};
DefaultTolerance tolerance_of(const std::string& metric);

// The columns that are compared if none is named.
std::vector<std::string> compared_columns();

// "Ev DGP DGI ...": for the help text.
std::string column_names();

}  // namespace glare
