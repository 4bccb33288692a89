// SPDX-License-Identifier: BSD-3-Clause
// The OpenCL devices of this machine, GPUs first: an index into this list is the N of `-device opencl:N`.
#pragma once
#define CL_HPP_TARGET_OPENCL_VERSION 120
#define CL_HPP_MINIMUM_OPENCL_VERSION 120
#define CL_HPP_ENABLE_EXCEPTIONS
#define CL_TARGET_OPENCL_VERSION 120
#include <CL/opencl.hpp>

#include <string>
#include <vector>

namespace device {

struct OpenclEntry {
    cl::Platform platform;
    cl::Device device;
    bool gpu;
};

// A failing driver may abort the program: ask in a child process first (device/child.h).
std::vector<OpenclEntry> opencl_entries();

// "NVIDIA H200 (GPU, NVIDIA CUDA)"
std::string describe(const OpenclEntry& e);

// "CL_OUT_OF_RESOURCES (-5)"
std::string opencl_error(int code);

// Parses "opencl[:index|:name][:compact|bvh8][:gpu]" among these devices: by default the first one with the tree that
// suits it; by name the first whose description contains it, ignoring case.  gpu: treats it as a GPU (for tests).
// Throws Error.
struct OpenclChoice {
    size_t index;
    bool as_gpu, compact;
};
OpenclChoice choose_opencl(const std::string& name, const std::vector<OpenclEntry>& devices);

}  // namespace device
