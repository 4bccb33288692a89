// SPDX-License-Identifier: BSD-3-Clause
// The skies that light the scene, one after another: files of -sky, or the hours of a weather file.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "render/hour_skies.h"

struct Sky {
    std::string name;                // of the picture
    std::string file;                // as scene::read_more() takes it; empty: none
    std::optional<uint64_t> seed;    // of its frames; none: the option's
    bool dark = false;               // an hour without daylight: one black frame
    std::string unknown;             // why there is no light to render by: a black frame that says so; else empty
    std::vector<std::string> lines;  // of its header
    std::optional<std::pair<int64_t, int64_t>> hour = {};  // of its header, likewise
    std::optional<render::HourSky> light = {};             // of an hour that is not dark

    bool beside_shared = false;  // rendered by itself, in a run whose other hours share their paths

    bool is_black() const { return dark || !unknown.empty(); }  // nothing is rendered
};

// "skies/sky_0900.rad" has the name "sky_0900".
Sky sky_of_file(const std::string& path);

struct HourOptions {
    std::optional<double> used_from;  // -occupied: of values of -hours @file; none: of the file's kind
    double shift_h = 0;               // -wea-shift
};

// The hours chosen (weather/choose.h), and a line for the user about them.
struct HourSkies {
    std::vector<Sky> skies;
    std::string mean_sky;  // scene text; empty: all hours are dark
    std::string note;
};
HourSkies skies_of_hours(const std::string& weather_file, const std::string& hours, const HourOptions& options,
                         uint64_t seed);
