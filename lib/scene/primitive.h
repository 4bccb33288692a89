// SPDX-License-Identifier: BSD-3-Clause
// One primitive as written in the text, on its way from the lexer through transforms into the tables.
#pragma once
#include <string>
#include <vector>
#include "scene/object.h"

namespace scene {

struct Primitive {
    Type type = Type::alias;
    std::string modifier, name;
    std::vector<std::string> strings;  // of an alias: the reference
    std::vector<double> reals;
    uint32_t file = 0, line = 0;
    static constexpr int32_t by_name = -2;
    int32_t modifier_object = by_name;  // binary files name modifiers by index: an object of the scene, or VOID
};

}  // namespace scene
