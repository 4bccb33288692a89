// SPDX-License-Identifier: BSD-3-Clause
// Names of all primitive types, and how many arguments each takes.
// Materials are rows of kernels/material/materials.h.  To add another type: its name in object.h (enum Type) and a row
// in types.cpp, in the same order.
#pragma once
#include <string>
#include "scene/object.h"

namespace scene {

// "" if the numbers of arguments fit the type, else what it needs, for people ("5 real arguments").
std::string argument_fault(Type type, size_t strings, size_t reals);

// Number of strings before a transform of the string arguments may begin; -1: the type takes no transform there.
int transform_from(Type type);

}  // namespace scene
