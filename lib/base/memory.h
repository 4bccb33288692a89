// SPDX-License-Identifier: BSD-3-Clause
// Memory of large tables: asked for once, and given back.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace base {

// Room for so many elements more; from call to call it at least doubles, so that many small ones stay cheap.
template <class Vector>
void make_room(Vector& v, size_t more) {
    if (more > v.capacity() - v.size()) v.reserve(std::max(v.size() + more, 2 * v.capacity()));
}

uint64_t machine_memory();  // bytes; 0 if unknown

// Freed blocks of up to 32 MB stay with the process (glibc), as the next frame needs them again: a page that the system
// gives costs as much as 4 KB of pixels.
void keep_freed_memory();
// Returns them to the system.
void give_back_memory();

}  // namespace base
