// SPDX-License-Identifier: BSD-3-Clause
// See reflectance.h.  Diffuse, specular and transmitted parts: docs/spec/radiance-shading.md, section 3, without
// Fresnel.  Not limited: radiance (light, glow ...), values of functions and BSDF files, extinction.
#include "flatten/reflectance.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/error.h"

namespace flatten {
namespace {

using scene::Type;

constexpr double sum_rounding = 1e-6;  // of 0.7 + 0.2 + 0.1 and the like
constexpr double impossible = 2;       // above any error of a measurement or of a fit to one

enum class Range { color, fraction, roughness };  // 0 to 1 where no pattern multiplies it; 0 to 1; 0 and more
struct Part {
    const char* name;
    Range range;
    size_t first, count;  // real arguments
};

// Names of the bounded real arguments of a type.
std::vector<Part> parts_of(Type type) {
    const Part color{"reflectance", Range::color, 0, 3}, specularity{"specularity", Range::fraction, 3, 1};
    switch (type) {
    case Type::plastic:
    case Type::metal: return {color, specularity, {"roughness", Range::roughness, 4, 1}};
    case Type::plastic2:
    case Type::metal2: return {color, specularity, {"roughness", Range::roughness, 4, 2}};
    case Type::trans:
        return {color, specularity, {"roughness", Range::roughness, 4, 1}, {"transmittance", Range::fraction, 5, 2}};
    case Type::trans2:
        return {color, specularity, {"roughness", Range::roughness, 4, 2}, {"transmittance", Range::fraction, 6, 2}};
    case Type::transfunc:
    case Type::transdata: return {{"transmittance", Range::fraction, 4, 2}};
    case Type::ashik2: return {color, {"specular reflectance", Range::fraction, 3, 3}};
    case Type::mirror: return {color};
    case Type::glass:
    case Type::dielectric: return {{"transmissivity", Range::color, 0, 3}};
    case Type::interface: return {{"transmissivity", Range::color, 0, 3}, {"transmissivity", Range::color, 4, 3}};
    case Type::BRTDfunc:
    case Type::WGMDfunc:
    case Type::BSDF:
    case Type::aBSDF: return {{"reflectance", Range::color, 0, 6}, {"transmittance", Range::color, 6, 3}};
    case Type::mist: return {{"albedo", Range::color, 3, 3}};
    default: return {};
    }
}

// Constant part of the light that band 0, 1 or 2 reflects and transmits; 0: unknown.  Negative parts, by rounding or
// mistake, enter by their size.
double given_back(Type type, scene::Span<double> a, size_t band) {
    const auto arg = [&](size_t k) { return k < a.size() ? std::fabs(a[k]) : 0; };
    switch (type) {
    case Type::plastic:
    case Type::plastic2:
    case Type::trans:
    case Type::trans2: return arg(band) * std::fabs(1 - a[3]) + arg(3);
    case Type::plasfunc:  // the share of the function in the specularity is unknown
    case Type::metfunc:
    case Type::transfunc:
    case Type::plasdata:
    case Type::metdata:
    case Type::transdata: return arg(band) * std::fabs(1 - a[3]);
    case Type::metal:
    case Type::metal2:
    case Type::mirror:
    case Type::glass:
    case Type::dielectric: return arg(band);
    case Type::interface: return std::max(arg(band), arg(band + 4));
    case Type::ashik2: return arg(band) + arg(band + 3);
    case Type::BRTDfunc:
    case Type::WGMDfunc:
    case Type::BSDF:
    case Type::aBSDF: return std::max(arg(band), arg(band + 3)) + arg(band + 6);
    case Type::mist: return arg(band + 3);
    default: return 0;
    }
}

// False after a warning of one part, because the sum would repeat it.
bool within_bounds(const Part& part, scene::Span<double> a, bool patterned, const std::string& place,
                   const std::string& named) {
    const size_t end = std::min(part.first + part.count, a.size());
    if (part.first >= end) return true;
    const auto [least, most] = std::minmax_element(a.begin() + part.first, a.begin() + end);
    if (*least < 0) base::warn(place, fmt::format("{}{} {:g} is below 0", named, part.name, *least));
    const bool bounded = part.range == Range::fraction || (part.range == Range::color && !patterned);
    const bool above = bounded && *most > 1 + sum_rounding;
    if (above) base::warn(place, fmt::format("{}{} {:g} is above 1", named, part.name, *most));
    return *least >= 0 && !above;
}

}  // namespace

void check_reflectance(const scene::Scene& scene, const scene::Object& material, bool patterned, bool any) {
    const auto a = scene.reals(material);
    const std::string place = scene.place(material);
    const std::string named = fmt::format("{} \"{}\": ", type_name(material.type), scene.name(material));
    double sum = 0;
    for (size_t band = 0; band < 3; band++) sum = std::max(sum, given_back(material.type, a, band));
    if (!patterned && !any && sum >= impossible)
        base::fail(place,
                   fmt::format("{}gives back {:g} times the light that it gets: a percentage, or 0 to 255, where "
                               "0 to 1 is meant?  -any-reflectance renders it",
                               named, sum));
    bool told = false;
    for (const Part& part : parts_of(material.type)) told = !within_bounds(part, a, patterned, place, named) || told;
    if (!told && !patterned && sum > 1 + sum_rounding)
        base::warn(place, fmt::format("{}gives back {:g} times the light that it gets", named, sum));
}

}  // namespace flatten
