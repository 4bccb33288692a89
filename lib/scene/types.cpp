// SPDX-License-Identifier: BSD-3-Clause
// The table of primitive types.
#include "scene/types.h"
#include <unordered_map>

namespace scene {

namespace {

// reals: the counts allowed, as bits, or 0 = reals_min or more.  transform: see transform_from().
struct Row {
    const char* name;
    int strings_min;
    uint32_t reals;
    int reals_min;
    int transform;
};
constexpr uint32_t only(int n) { return 1u << n; }
constexpr uint32_t any = 0;

// clang-format off
const Row rows[] = {
    {"source", 0, only(4), 0, -1}, {"sphere", 0, only(4), 0, -1}, {"bubble", 0, only(4), 0, -1},
    {"polygon", 0, any, 9, -1}, {"cone", 0, only(8), 0, -1}, {"cup", 0, only(8), 0, -1},
    {"cylinder", 0, only(7), 0, -1}, {"tube", 0, only(7), 0, -1}, {"ring", 0, only(8), 0, -1},
    {"mesh", 1, only(0), 0, 1}, {"instance", 1, only(0), 0, 1},
    {"light", 0, only(3), 0, -1}, {"illum", 0, only(3), 0, -1}, {"glow", 0, only(4), 0, -1},
    {"spotlight", 0, only(7), 0, -1}, {"mirror", 0, only(3), 0, -1}, {"prism1", 5, any, 0, 5},
    {"prism2", 9, any, 0, 9}, {"mist", 0, only(0) | only(3) | only(6) | only(7), 0, -1},
    {"plastic", 0, only(5), 0, -1}, {"metal", 0, only(5), 0, -1}, {"trans", 0, only(7), 0, -1},
    {"plastic2", 4, only(6), 0, 4}, {"metal2", 4, only(6), 0, 4}, {"trans2", 4, only(8), 0, 4},
    {"ashik2", 4, only(8), 0, 4}, {"WGMDfunc", 13, any, 9, 13}, {"dielectric", 0, only(5), 0, -1},
    {"interface", 0, only(8), 0, -1}, {"glass", 0, only(3) | only(4), 0, -1}, {"plasfunc", 2, any, 4, 2},
    {"metfunc", 2, any, 4, 2}, {"transfunc", 2, any, 6, 2}, {"plasdata", 4, any, 4, 4}, {"metdata", 4, any, 4, 4},
    {"transdata", 4, any, 6, 4}, {"BRTDfunc", 10, any, 9, 10},
    {"BSDF", 6, only(0) | only(3) | only(6) | only(9), 0, 6}, {"aBSDF", 5, only(0) | only(3) | only(6) | only(9), 0, 5},
    {"antimatter", 1, any, 0, -1},
    {"texfunc", 4, any, 0, 4}, {"texdata", 8, any, 0, 8}, {"colorfunc", 4, any, 0, 4}, {"brightfunc", 2, any, 0, 2},
    {"colordata", 8, any, 0, 8}, {"brightdata", 4, any, 0, 4}, {"colorpict", 7, any, 0, 7},
    {"colortext", 2, only(15) | only(16), 0, -1}, {"brighttext", 2, only(11) | only(12), 0, -1},
    {"spectrum", 0, any, 3, -1}, {"specfile", 1, any, 0, -1}, {"specdata", 4, any, 0, 4}, {"specfunc", 2, any, 2, 2},
    {"specpict", 5, any, 0, 5}, {"mixfunc", 4, any, 0, 4}, {"mixdata", 6, any, 0, 6}, {"mixpict", 7, any, 0, 7},
    {"mixtext", 4, only(9) | only(10), 0, -1},
    {"alias", 0, any, 0, -1},
};
// clang-format on
static_assert(sizeof rows / sizeof rows[0] == static_cast<size_t>(Type::count), "a row for every type, in its order");

const Row& row(Type t) { return rows[static_cast<size_t>(t)]; }

}  // namespace

const char* type_name(Type t) { return row(t).name; }

bool type_from_name(std::string_view name, Type& t) {
    static const auto index = [] {
        std::unordered_map<std::string_view, Type> m;
        for (size_t i = 0; i < static_cast<size_t>(Type::count); i++) m.emplace(rows[i].name, static_cast<Type>(i));
        return m;
    }();
    const auto found = index.find(name);
    if (found == index.end()) return false;
    t = found->second;
    return true;
}

std::string argument_fault(Type type, size_t strings, size_t reals) {
    const Row& r = row(type);
    if (strings < static_cast<size_t>(r.strings_min))
        return "needs at least " + std::to_string(r.strings_min) + " string arguments, has " + std::to_string(strings);
    const std::string has = ", has " + std::to_string(reals);
    if (type == Type::polygon)
        return reals >= 9 && reals % 3 == 0 ? "" : "needs 9 or more real arguments, a multiple of 3" + has;
    if (r.reals == any)
        return reals >= static_cast<size_t>(r.reals_min)
                   ? ""
                   : "needs at least " + std::to_string(r.reals_min) + " real arguments" + has;
    if (reals < 32 && (r.reals >> reals & 1)) return "";
    std::string counts;
    for (int n = 0; n < 32; n++)
        if (r.reals >> n & 1) counts += (counts.empty() ? "" : " or ") + std::to_string(n);
    return "needs " + counts + " real arguments" + has;
}

int transform_from(Type type) { return row(type).transform; }

}  // namespace scene
