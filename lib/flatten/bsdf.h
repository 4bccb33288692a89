// SPDX-License-Identifier: BSD-3-Clause
// The tables of a BSDF file for the kernels (kernels/material/bsdf.h).
#pragma once
#include <string>
#include <vector>
#include "cal/compile.h"
#include "kernels/dialect/host.h"
#include "scene/bsdf_xml.h"

namespace flatten {

struct BandColours;  // flatten/band_colours.h

struct BsdfRecords {
    std::vector<kernels::BsdfComponent> components;
    std::vector<kernels::BsdfTable> tables;
    std::vector<kernels::BsdfRing> rings;
};

// Appends to the records and, values, to `code`; returns the first of the four components (Modifier.bsdf_at).
// bands: null, or what stands for R, G and B.
uint32_t add_bsdf(const scene::Bsdf& bsdf, const BandColours* bands, BsdfRecords& records, cal::Code& code,
                  const std::string& place);

}  // namespace flatten
