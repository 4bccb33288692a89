// SPDX-License-Identifier: BSD-3-Clause
// Self-test of a device.  Before its first frame it does some arithmetic (kernels/self_test.h) and renders a small
// room; both are compared with the processor's results.
#pragma once
#include <string>
#include "device/device.h"

namespace render {

// Returns the device's own_bits (device.h): "" if it gives the processor's bits or has nothing to test; otherwise warns
// and returns a name of its bits for fingerprints.  Throws Error (system) for differences larger than rounding.
// The result is remembered in this folder by the device's identity; without one ("") the test runs at every start.
std::string self_test(device::Device& device, const std::string& folder);

}  // namespace render
