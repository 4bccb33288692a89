// SPDX-License-Identifier: BSD-3-Clause
// The table of primitive types.
#include "scene/types.h"
#include <unordered_map>

namespace scene {

namespace {

// Number of real arguments: one of some counts (bits), or, without any, `least` and more.
struct Reals {
    uint32_t counts;
    int least;
};
constexpr Reals only(int n) { return {1u << n, 0}; }
constexpr Reals any(int a, int b, int c = 0, int d = 0) {
    return {1u << a | 1u << b | (c ? 1u << c : 0) | (d ? 1u << d : 0), 0};
}
constexpr Reals from(int least) { return {0, least}; }

struct Row {
    const char* name;
    int strings_min;
    Reals reals;
    int transform;  // see transform_from()
};
// The strings of .cal functions stand before a transform.
#define ROW_OF_MATERIAL(number, type, strings, reals, absent, values, lobe, light, eye, region, back, traits) \
    {#type, strings, reals, (values) + (lobe) > 0 ? (strings) : -1},

// clang-format off
const Row rows[] = {
    {"source", 0, only(4), -1}, {"sphere", 0, only(4), -1}, {"bubble", 0, only(4), -1}, {"polygon", 0, from(9), -1},
    {"cone", 0, only(8), -1}, {"cup", 0, only(8), -1}, {"cylinder", 0, only(7), -1}, {"tube", 0, only(7), -1},
    {"ring", 0, only(8), -1}, {"mesh", 1, only(0), 1}, {"instance", 1, only(0), 1},
    MATERIALS(ROW_OF_MATERIAL, ROW_OF_MATERIAL)
    {"texfunc", 4, from(0), 4}, {"texdata", 8, from(0), 8}, {"colorfunc", 4, from(0), 4},
    {"brightfunc", 2, from(0), 2}, {"colordata", 8, from(0), 8}, {"brightdata", 4, from(0), 4},
    {"colorpict", 7, from(0), 7}, {"colortext", 2, any(15, 16), -1}, {"brighttext", 2, any(11, 12), -1},
    {"spectrum", 0, from(3), -1}, {"specfile", 1, from(0), -1}, {"specdata", 4, from(0), 4},
    {"specfunc", 2, from(2), 2}, {"specpict", 5, from(0), 5}, {"mixfunc", 4, from(0), 4}, {"mixdata", 6, from(0), 6},
    {"mixpict", 7, from(0), 7}, {"mixtext", 4, any(9, 10), -1}, {"alias", 0, from(0), -1},
};
// clang-format on
#undef ROW_OF_MATERIAL
static_assert(sizeof rows / sizeof rows[0] == size_t(Type::count), "a row for every type, in its order");

const Row& row_of(Type t) { return rows[size_t(t)]; }

}  // namespace

const char* type_name(Type t) { return row_of(t).name; }

bool type_from_name(std::string_view name, Type& t) {
    static const auto index = [] {
        std::unordered_map<std::string_view, Type> m;
        for (size_t i = 0; i < size_t(Type::count); i++) m.emplace(rows[i].name, Type(i));
        return m;
    }();
    const auto found = index.find(name);
    if (found == index.end()) return false;
    t = found->second;
    return true;
}

std::string argument_fault(Type type, size_t strings, size_t reals) {
    const Row& r = row_of(type);
    if (strings < size_t(r.strings_min))
        return "needs at least " + std::to_string(r.strings_min) + " string arguments, has " + std::to_string(strings);
    const std::string has = ", has " + std::to_string(reals);
    if (type == Type::polygon)
        return reals >= 9 && reals % 3 == 0 ? "" : "needs 9 or more real arguments, a multiple of 3" + has;
    if (r.reals.counts == 0)
        return reals >= size_t(r.reals.least)
                   ? ""
                   : "needs at least " + std::to_string(r.reals.least) + " real arguments" + has;
    if (reals < 32 && (r.reals.counts >> reals & 1)) return "";
    std::string counts;
    for (int n = 0; n < 32; n++)
        if (r.reals.counts >> n & 1) counts += (counts.empty() ? "" : " or ") + std::to_string(n);
    return "needs " + counts + " real arguments" + has;
}

int transform_from(Type type) { return row_of(type).transform; }

}  // namespace scene
