// SPDX-License-Identifier: BSD-3-Clause
// In place of the OpenCL device, in builds without it (-DLUXPIPE_OPENCL=OFF).
#include "base/error.h"
#include "device/device.h"
#include "device/kernel_cache.h"

namespace device {

std::string choose_kernel_cache() { return ""; }
std::vector<std::string> opencl_devices() { return {}; }
bool opencl_has_gpu() { return false; }

std::unique_ptr<Device> make_opencl_device(const std::string&) {
    base::fail("-device", "this ptrace was built without OpenCL; cpu is what it has");
}

}  // namespace device
