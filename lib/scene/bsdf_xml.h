// SPDX-License-Identifier: BSD-3-Clause
// Scattering data of BSDF files: the XML of LBNL's Window and of genBSDF, as plain tables.
// Sides are RADIANCE's: side 0 is where the surface normal points (+z), which the files, written from the window's
// outside, call "Back".  Values are BSDF, 1/sr, never negative; lengths are metres.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>
#include "base/open_file.h"

namespace scene {

// Patches of a hemisphere: rings of equal patches, centred on azimuth 0.
struct BsdfBasis {
    std::string name;
    std::vector<double> theta;    // bounds of the rings in degrees, 0 .. 90; one more than rings
    std::vector<uint32_t> count;  // patches of each ring
    size_t cells() const;
};

// A tensor tree: node n is a leaf (child LEAF) of value[n], or has 2^dims children from child[n] on; bit k of a child's
// place is the upper half of dimension k.  Node 0 is the root.
struct BsdfTree {
    static constexpr uint32_t LEAF = 0xffffffffu;
    int dims = 0;   // 3 or 4; 0 = no tree
    int depth = 0;  // the smallest leaf is 2^-depth wide
    std::vector<float> value;
    std::vector<uint32_t> child;
};

// Reflection or transmission for light from one side.
struct BsdfTable {
    bool present = false;
    uint32_t incident = 0, exit = 0;  // matrix: indices of Bsdf::bases
    std::vector<float> y, x, z;       // matrix: value at incident * exit cells + exit; x and z empty without colour
    BsdfTree tree, u, v;              // tensor: luminance, CIE u' and v' (no tree without colour)
};

struct Bsdf {
    std::string name;
    double thickness = 0, width = 0, height = 0;
    std::vector<BsdfBasis> bases;
    std::array<BsdfTable, 2> reflection, transmission;  // by the side of the incident light: 0 = +z, 1 = -z
};

// path is opened as it is; errors name it.  by: as for base::open_file().
Bsdf read_bsdf(const std::string& path, const base::Opener& by = {});
Bsdf parse_bsdf(const std::string& text, const std::string& place);

}  // namespace scene
