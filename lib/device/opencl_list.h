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

// A failing driver may end the program here: ask in a child process first (device/child.h).
std::vector<OpenclEntry> opencl_entries();

// "NVIDIA H200 (GPU, NVIDIA CUDA)"
std::string describe(const OpenclEntry& e);

// "CL_OUT_OF_RESOURCES (-5)"
std::string opencl_error(int code);

// What "opencl[:index|:name][:compact|bvh8][:gpu]" names among these devices: without more the first, and for it the
// tree that suits; by name the first whose description holds it, in letters of either case.  gpu: it is used as a GPU
// is, whatever it is (for tests).  Throws Error.
struct OpenclChoice {
    size_t index;
    bool as_gpu, compact;
};
OpenclChoice choose_opencl(const std::string& name, const std::vector<OpenclEntry>& devices);

}  // namespace device
