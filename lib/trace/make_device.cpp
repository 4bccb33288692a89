// SPDX-License-Identifier: BSD-3-Clause
// Devices by the names of -device, and the list of those that there are.
#include <fmt/core.h>

#include "base/error.h"
#include "trace/device.h"
#include "trace/progressive.h"

namespace trace {

std::vector<std::string> list_devices() {
    std::vector<std::string> out = {make_cpu_device("cpu")->name()};
    for (auto& d : opencl_devices()) out.push_back(d);
    return out;
}

std::unique_ptr<Device> make_device(const std::string& name) {
    if (name == "auto") return opencl_has_gpu() ? make_opencl_device("opencl") : make_cpu_device("cpu");
    const std::string kind = name.substr(0, name.find(':'));
    if (kind == "cpu") return make_cpu_device(name);
    if (kind == "opencl") return make_opencl_device(name);
    base::fail("-device", fmt::format("\"{}\" is not auto, cpu or opencl[:index]", name));
}

}  // namespace trace
