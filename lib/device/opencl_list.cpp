// SPDX-License-Identifier: BSD-3-Clause
// The list of OpenCL devices (opencl_list.h), and its text for users (device.h).
#include "device/opencl_list.h"

#include <algorithm>
#include <cstdlib>
#include <fmt/core.h>
#include <glob.h>
#include <sstream>
#include <strings.h>

#include "base/error.h"
#include "device/child.h"
#include "device/device.h"
#include "device/kernel_cache.h"

namespace device {
namespace {

std::string clean(std::string s) {
    while (!s.empty() && (s.back() == '\0' || s.back() == ' ')) s.pop_back();
    return s;
}

// Linux shows a graphics processor as a file.  Asking OpenCL takes a tenth of a second, which is saved if there is no
// such file.  Render nodes (AMD, Intel, Mesa), AMD's compute, NVIDIA, Windows' Linux, Mali, Adreno.
bool system_shows_gpu() {
    glob_t found = {};
    int flags = GLOB_NOSORT;
    for (const char* files :
         {"/dev/dri/renderD*", "/dev/kfd", "/dev/nvidia[0-9]*", "/dev/dxg", "/dev/mali*", "/dev/kgsl*"}) {
        glob(files, flags, nullptr, &found);
        flags |= GLOB_APPEND;
    }
    const bool any = found.gl_pathc > 0;
    globfree(&found);
    return any;
}

}  // namespace

std::vector<OpenclEntry> opencl_entries() {
    choose_kernel_cache();
    // Intel's runtime for processors vectorises work items, and then compiles large kernels wrongly.
    setenv("CL_CONFIG_CPU_VECTORIZER_MODE", "1", 0);
    std::vector<OpenclEntry> out;
    std::vector<cl::Platform> platforms;
    try {
        cl::Platform::get(&platforms);
    } catch (const cl::Error&) {
        return out;
    }
    for (const auto& p : platforms) {
        std::vector<cl::Device> devices;
        try {
            p.getDevices(CL_DEVICE_TYPE_ALL, &devices);
            for (const auto& d : devices)
                out.push_back({p, d, (d.getInfo<CL_DEVICE_TYPE>() & CL_DEVICE_TYPE_GPU) != 0});
        } catch (const cl::Error&) {
            continue;
        }
    }
    std::stable_sort(out.begin(), out.end(), [](const OpenclEntry& a, const OpenclEntry& b) { return a.gpu > b.gpu; });
    return out;
}

std::string opencl_error(int code) {
    static const std::pair<int, const char*> names[] = {
#define CODE(name) {CL_##name, "CL_" #name}
        CODE(DEVICE_NOT_FOUND),
        CODE(DEVICE_NOT_AVAILABLE),
        CODE(COMPILER_NOT_AVAILABLE),
        CODE(MEM_OBJECT_ALLOCATION_FAILURE),
        CODE(OUT_OF_RESOURCES),
        CODE(OUT_OF_HOST_MEMORY),
        CODE(BUILD_PROGRAM_FAILURE),
        CODE(MAP_FAILURE),
        CODE(EXEC_STATUS_ERROR_FOR_EVENTS_IN_WAIT_LIST),
        CODE(INVALID_VALUE),
        CODE(INVALID_DEVICE),
        CODE(INVALID_CONTEXT),
        CODE(INVALID_COMMAND_QUEUE),
        CODE(INVALID_MEM_OBJECT),
        CODE(INVALID_BINARY),
        CODE(INVALID_BUILD_OPTIONS),
        CODE(INVALID_PROGRAM),
        CODE(INVALID_PROGRAM_EXECUTABLE),
        CODE(INVALID_KERNEL_NAME),
        CODE(INVALID_KERNEL),
        CODE(INVALID_KERNEL_ARGS),
        CODE(INVALID_WORK_GROUP_SIZE),
        CODE(INVALID_EVENT),
        CODE(INVALID_OPERATION),
        CODE(INVALID_BUFFER_SIZE),
        CODE(INVALID_ARG_VALUE),
        CODE(INVALID_QUEUE_PROPERTIES)
#undef CODE
    };
    for (const auto& [number, name] : names)
        if (number == code) return fmt::format("{} ({})", name, code);
    return fmt::format("OpenCL error {}", code);
}

std::string describe(const OpenclEntry& e) {
    return fmt::format("{} ({}, {})", clean(e.device.getInfo<CL_DEVICE_NAME>()), e.gpu ? "GPU" : "CPU",
                       clean(e.platform.getInfo<CL_PLATFORM_NAME>()));
}

namespace {

size_t index_of(const std::string& name, const std::vector<OpenclEntry>& devices) {
    for (size_t i = 0; i < devices.size(); i++) {
        const std::string has = describe(devices[i]);
        for (size_t at = 0; at + name.size() <= has.size(); at++)
            if (strncasecmp(&has[at], name.c_str(), name.size()) == 0) return i;
    }
    base::fail("-device", fmt::format("there is no OpenCL device \"{}\"; -devices lists them", name));
}

}  // namespace

OpenclChoice choose_opencl(const std::string& name, const std::vector<OpenclEntry>& devices) {
    size_t index = 0;
    std::string tree;
    bool gpu = false;
    std::string rest = name.size() > 6 ? name.substr(7) : "";
    while (!rest.empty()) {
        const size_t colon = rest.find(':');
        const std::string word = rest.substr(0, colon);
        rest = colon == std::string::npos ? "" : rest.substr(colon + 1);
        if (word == "compact" || word == "bvh8") tree = word;
        else if (word == "gpu") gpu = true;
        else if (!word.empty() && word.find_first_not_of("0123456789") == std::string::npos && word.size() < 5)
            index = size_t(std::stoul(word));
        else if (!word.empty()) index = index_of(word, devices);
    }
    if (index >= devices.size())
        base::fail("-device", fmt::format("there is no OpenCL device {} (only {})", index, devices.size()));
    gpu = gpu || devices[index].gpu;
    return {index, gpu, tree.empty() ? gpu : tree == "compact"};
}

std::vector<std::string> opencl_devices() {
    const auto text = ask_in_child([] {
        std::string lines;
        const auto devices = opencl_entries();
        for (size_t i = 0; i < devices.size(); i++) lines += fmt::format("opencl:{} {}\n", i, describe(devices[i]));
        return lines;
    });
    if (!text) base::warn("OpenCL", "a driver failed when asked for its devices and is left out");
    std::vector<std::string> out;
    std::istringstream lines(text.value_or(""));
    for (std::string line; std::getline(lines, line);) out.push_back(line);
    return out;
}

bool opencl_has_gpu() {
    if (!system_shows_gpu()) return false;
    const auto text = ask_in_child([] {
        const auto devices = opencl_entries();
        return std::string(!devices.empty() && devices[0].gpu ? "gpu" : "");
    });
    if (!text) base::warn("OpenCL", "a driver failed when asked for its devices and is left out");
    return text == "gpu";
}

}  // namespace device
