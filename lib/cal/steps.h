// SPDX-License-Identifier: BSD-3-Clause
// A program over any number of virtual registers, between the graph (codegen.cpp) and the VM's words (assemble.cpp).
#pragma once
#include <cstdint>
#include <string>
#include <vector>
#include "cal/compile.h"

namespace cal {

// One instruction over virtual registers; -1 = none.
struct Step {
    uint32_t op;
    int d = -1, a = -1, b = -1, c = -1;  // c: OP_SEL
    bool immediate = false;              // b is `value`
    float value = 0;
    uint32_t aux = 0;  // raw destination, b field or table, by operation
    int target = -1;   // jumps: index of the step to go on with
};

struct Steps {
    std::vector<Step> list;
    std::vector<int> width;  // of register blocks, by first register; 0 inside a block
};

// Appends the program's words; returns its entry.  Throws Error(place) if it needs more registers than there are.
uint32_t assemble(const Steps& steps, const std::string& place, Code& code);

}  // namespace cal
