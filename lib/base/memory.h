// SPDX-License-Identifier: BSD-3-Clause
// What was freed, given back to the system: glibc keeps blocks of up to 32 MB for later.
#pragma once

namespace base {

void give_back_memory();

}  // namespace base
