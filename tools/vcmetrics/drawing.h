// SPDX-License-Identifier: BSD-3-Clause
// What was measured, drawn: outlines of glare sources, and a picture for people with sources, regions and metrics.
#pragma once
#include <string>
#include <vector>
#include "glare/measure.h"
#include "image/masks.h"
#include "image/picture.h"
#include "options.h"
#include "run.h"

struct Place {
    int x = 0, y = 0;  // row 0 = top
};
// The middle of the upper edge of an area.
Place top_of(const std::vector<float>& area, int width);

// 1 at the pixels of a source, else 0.
std::vector<float> area_of(const glare::Measurement& measurement, const glare::Geometry& geometry,
                           const glare::GlareSource& source);
// The regions of -regions as that picture has them.
image::MaskSet regions_in(const Options& options, const image::Picture& picture);

// The outline of a source, as JSON (display/outline.h).
std::string source_outline(const glare::Measurement& measurement, const glare::Geometry& geometry,
                           const glare::GlareSource& source);

// Writes the file of -over: the picture toned for the eye; glare sources outlined, with their number and share of DGP;
// regions outlined, with their names; the metrics below.
void draw_measured(const Options& options, const image::Picture& picture, const RunState& run,
                   const glare::Measurement& measurement);
