// SPDX-License-Identifier: BSD-3-Clause
// BSDF files for the tests, written from their parts.
#pragma once
#include <random>
#include <sstream>
#include <string>

// One block of data: direction, its angle basis and numbers or braces, for one wavelength.
inline std::string bsdf_block(const std::string& direction, const std::string& data,
                              const std::string& basis = "LBNL/Klems Quarter",
                              const std::string& wavelength = "Visible") {
    return "<WavelengthData><Wavelength unit=\"Integral\">" + wavelength +
           "</Wavelength><WavelengthDataBlock>"
           "<WavelengthDataDirection>" +
           direction +
           "</WavelengthDataDirection>"
           "<ColumnAngleBasis>" +
           basis + "</ColumnAngleBasis><RowAngleBasis>" + basis +
           "</RowAngleBasis>"
           "<AngleBasis>LBNL/Shirley-Chiu</AngleBasis><ScatteringData>" +
           data +
           "</ScatteringData>"
           "</WavelengthDataBlock></WavelengthData>";
}
inline std::string bsdf_file(const std::string& structure, const std::string& blocks, const std::string& basis = "",
                             const std::string& material = "<Name>pane</Name>") {
    return "<?xml version=\"1.0\"?>\n<WindowElement><Optical><Layer><Material>" + material +
           "</Material><DataDefinition>"
           "<IncidentDataStructure>" +
           structure + "</IncidentDataStructure>" + basis + "</DataDefinition>" + blocks +
           "</Layer></Optical></WindowElement>";
}
// Values in [low, high) for a matrix or a leaf grid.
inline std::string bsdf_numbers(size_t count, unsigned seed, double low = 0, double high = 1) {
    std::mt19937 random(seed);
    std::ostringstream s;
    for (size_t i = 0; i < count; i++)
        s << low + (high - low) * double(random() % 10000) / 10000 << (i + 1 < count ? " " : "");
    return s.str();
}
// A tensor tree that branches by chance down to `depth` levels.
inline std::string bsdf_tree(int dims, int depth, std::mt19937& random) {
    if (depth == 0 || random() % 4 == 0) return "{" + std::to_string(double(random() % 1000) / 1000) + "}";
    if (depth == 1 && random() % 2) return "{" + bsdf_numbers(size_t(1) << dims, unsigned(random())) + "}";
    std::string s = "{";
    for (int c = 0; c < 1 << dims; c++) s += bsdf_tree(dims, depth - 1, random);
    return s + "}";
}
