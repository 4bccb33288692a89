// SPDX-License-Identifier: BSD-3-Clause
// Chooses the folder of PoCL's compiled kernels, which are programs that will be run: one that belongs to the user.
#pragma once
#include <string>

namespace device {

// Call before the first use of OpenCL.  Without HOME PoCL uses /tmp, where anybody may plant a kernel, and it has no
// devices at all if the folder cannot be written.  Returns the folder; "" if it will be removed at the end.
std::string choose_kernel_cache();

}  // namespace device
