// SPDX-License-Identifier: BSD-3-Clause
// Devices by the names that users write: "auto", "cpu", "opencl", "opencl:1", "opencl:NVIDIA".
#pragma once
#include <memory>
#include <string>
#include <vector>
#include "device/device.h"

namespace render {

// "auto": a GPU by OpenCL, else the CPU.  An OpenCL device has passed its self-test (self_test.h).  Throws Error (place
// -device) if there is no device of this name, or if it computes garbage.
std::unique_ptr<device::Device> make_device(const std::string& name);
std::vector<std::string> list_devices();  // one line each, for -devices

}  // namespace render
