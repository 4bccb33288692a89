// SPDX-License-Identifier: BSD-3-Clause
// Is a device to be believed?  Before its first frame it does some arithmetic (kernels/self_test.h) and renders a small
// room, and both are compared with what the processor gives.
#pragma once
#include <string>
#include "device/device.h"

namespace render {

// The device's own_bits (device.h): "" where it gives the processor's bits or has nothing to test; otherwise a warning,
// and a name for its bits, which belongs into fingerprints.  Throws Error (system) for garbage, which is more than
// rounding can explain.  A result is remembered beside the compiled kernels (device/kernel_cache.h) by the device's
// identity.
std::string self_test(device::Device& device);

}  // namespace render
