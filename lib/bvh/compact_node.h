// SPDX-License-Identifier: BSD-3-Clause
// A node of kernels/bvh/bvh_compact.h: boxes as bytes, children in the slots that say which way they lie.
#pragma once
#include <cstdint>

#include "bvh/bounds.h"

namespace bvh {

constexpr unsigned compact_slots = 8;

// Puts each child of a node into a slot of its own, those that lie farthest along a slot's diagonal first.
void choose_slots(const Bounds* box, unsigned count, unsigned slot[compact_slots]);

// Writes COMPACT_NODE_FLOATS floats.  By slot: boxes (null: no child) and references, those of nodes one after the
// other, and of leaves, too, within 128 blocks.  Each packed box holds its box.
void write_compact_node(float* at, const Bounds* const box[compact_slots], const uint32_t ref[compact_slots]);

}  // namespace bvh
