// SPDX-License-Identifier: BSD-3-Clause
// A machine that runs paths: the CPU with the shared code compiled natively, or an OpenCL device.
#pragma once
#include <atomic>
#include <memory>
#include <string>
#include <vector>
#include "kernels/dialect/host.h"
#include "flatten/flat_scene.h"
#include "device/pilot_rays.h"

namespace device {

using kernels::Params;

// A straight ray from the eye to a point of active source `source`, and the share of a pixel it stands for.
struct SplatRay {
    float org[3], dir[3], dist, weight;
    uint32_t source;
};

// Thrown by run(), splat() and pilot() when they end early (Device::cancel_when).
struct Cancelled {};

class Device {
public:
    virtual ~Device() = default;
    virtual std::string name() const = 0;
    // Builds the device's BVH and takes the tables, in place of those it had.  A processor reads them where they are.
    virtual void upload(std::shared_ptr<const flatten::FlatScene> scene) = 0;
    // Numbers first .. first + count - 1 of that scene (FlatScene::f) have changed: which sources are drawn depends on
    // the view.
    virtual void update_float_table(size_t first, size_t count) = 0;
    // Runs par.path_count paths; rgb gets 3 floats a path, or, where paths share, for each sample of the picture's
    // pixels.
    virtual void run(const Params& par, std::vector<float>& rgb) = 0;
    // MODE_SPLAT: radiance times weight for each ray, 3 floats each.
    virtual void splat(const Params& par, const std::vector<SplatRay>& rays, std::vector<float>& rgb) = 0;
    // MODE_PILOT: how the pilot of each ray ends.
    virtual void pilot(const Params& par, const std::vector<PilotRay>& rays, std::vector<PilotEnd>& ends) = 0;
    // Pixels with several samples in each frame (FOCUS_WORDS of kernels/tables.h), for the passes that follow.
    virtual void set_focus(std::vector<uint32_t> entries) = 0;
    // Paths to hand over at once, so that the device is full.
    virtual uint32_t preferred_batch_size() const = 0;
    // Names the bits of a device that gives others than the processor does (self_test.h), for the fingerprint.
    virtual std::string own_bits() const { return ""; }
    virtual void set_own_bits(std::string) {}
    // For the self-test: everything that the device's results depend on (driver, version, options), empty where there
    // is nothing to test; and, after a frame, the first n values of kernels/self_test.h as the device computes them.
    virtual std::string identity() { return ""; }
    virtual std::vector<float> self_test_numbers(uint32_t) { return {}; }
    // Is the host free while it runs?
    virtual bool is_async() const { return false; }
    // Where this is true, what runs ends within a tile of paths (OpenCL: a bounce of them) with Cancelled.
    virtual void cancel_when(const std::atomic<bool>* asked) { cancel_ = asked; }

protected:
    void end_if_cancelled() const {
        if (cancel_ && *cancel_) throw Cancelled{};
    }
    const std::atomic<bool>* cancel_ = nullptr;
};

// name: "cpu", or for tests "cpu:NAME" with an instruction set (baseline, avx2: one path at a time) or
// many paths side by side (lanes8, lanes16: where ispc was there when luxpipe was built).
std::unique_ptr<Device> make_cpu_device(const std::string& name);
// Are these kernels in the program, and has this machine their instructions?
bool has_cpu_variant(const std::string& name);
// name: "opencl[:index][:compact|bvh8][:gpu]" (opencl_list.h), index among all OpenCL devices, GPUs first.  Throws
// Error (system) without any.  It has not passed a self-test yet: that is lib/render.
std::unique_ptr<Device> make_opencl_device(const std::string& name);
// "opencl:0 NVIDIA H200 (GPU, NVIDIA CUDA)" each; empty without an OpenCL platform.  Both ask in a child process, which
// a failing driver may end; it costs a warning.
std::vector<std::string> opencl_devices();
bool opencl_has_gpu();

}  // namespace device
