// SPDX-License-Identifier: BSD-3-Clause
// Where PoCL keeps compiled kernels, which are programs that will be run: in a folder of the user's own.
#pragma once

namespace device {

// Call before OpenCL is used first.  By itself PoCL takes /tmp, where anybody may plant a kernel, if HOME is not set,
// and has no devices at all if the folder cannot be written.  False: the folder will be gone at the end.
bool choose_kernel_cache();

}  // namespace device
