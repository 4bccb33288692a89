// SPDX-License-Identifier: BSD-3-Clause
// The tables of a BSDF file for the kernels (kernels/material/bsdf.h).
#pragma once
#include <string>
#include "cal/compile.h"
#include "scene/bsdf_xml.h"

namespace flatten {

// Appends to code.words and code.floats; returns the index of the four components (Modifier.bsdf_at).
uint32_t bsdf_tables(const scene::Bsdf& bsdf, cal::Code& code, const std::string& place);

}  // namespace flatten
