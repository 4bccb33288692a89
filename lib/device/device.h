// SPDX-License-Identifier: BSD-3-Clause
// A device that runs paths: the CPU with natively compiled kernels, or an OpenCL device.
#pragma once
#include <atomic>
#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>
#include "base/error.h"
#include "kernels/dialect/host.h"
#include "flatten/flat_scene.h"
#include "device/given_rays.h"
#include "device/hour_paths.h"

namespace device {

// Parameters of a pass, with the tables of its view (null: they are empty).
struct Params : kernels::Params {
    std::shared_ptr<const kernels::ViewTables> view_tables;
};
#define COUNT_OF_VIEW(type, name) par.name##_count = uint32_t(tables.name.size());
inline Params with_view(Params par, kernels::ViewTables tables) {
    VIEW_TABLES(COUNT_OF_VIEW)
    par.view_tables = std::make_shared<const kernels::ViewTables>(std::move(tables));
    return par;
}

// A request to a running pass.  end: run(), splat() and pilot() throw Cancelled.
enum class Wish { go_on, wait, end };
struct Cancelled {};

class Device {
public:
    virtual ~Device() = default;
    virtual std::string name() const = 0;
    // Holds this scene, in place of another one.
    void hold(const std::shared_ptr<const flatten::FlatScene>& scene) {
        if (held_.lock() == scene) return;
        held_.reset();
        upload(scene);
        held_ = scene;
    }
    // Uploads it.  The CPU reads its tables in place.
    virtual void upload(std::shared_ptr<const flatten::FlatScene> scene) = 0;
    // Runs par.path_count paths; rgb gets 3 floats for each path or, with path reuse, for each sample of the picture's
    // pixels.
    virtual void run(const Params& par, std::vector<float>& rgb) = 0;
    // The same of paths for many hours (PF_HOURS), which take long: a signal ends it with Cancelled.
    virtual void run_hours(const Params&, HourPaths&) {
        base::fail_system("-device " + name(), "renders hours one by one alone: -hours-apart");
    }
    // MODE_SPLAT: radiance times weight for each ray, 3 floats each.
    virtual void splat(const Params& par, const std::vector<SplatRay>& rays, std::vector<float>& rgb) = 0;
    // MODE_PILOT: the end of the pilot path of each ray.
    virtual void pilot(const Params& par, const std::vector<PilotRay>& rays, std::vector<PilotEnd>& ends) = 0;
    // Returns true if the device's rays go through Trees::compact.
    virtual bool compact_tree() const { return false; }
    // Number of paths to run at once, so that the device is busy.
    virtual uint32_t preferred_batch_size() const = 0;
    // Names the bits of a device whose results differ from the processor's (self_test.h), for the fingerprint.
    virtual std::string own_bits() const { return ""; }
    virtual void set_own_bits(std::string) {}
    // For the self-test: identity() is everything on which the device's results depend (driver, version, options),
    // empty if there is nothing to test; self_test_numbers(n) are, after a frame, the first n values of
    // kernels/self_test.h as the device computes them.
    virtual std::string identity() { return ""; }
    virtual std::vector<float> self_test_numbers(uint32_t) { return {}; }
    // Returns true if the host is free while the device runs.
    virtual bool is_async() const { return false; }
    // A running pass looks at it before each tile of paths (OpenCL: each bounce of them).
    virtual void heed(const std::atomic<Wish>* wish) { wish_ = wish; }

protected:
    void heed_wish() const {
        while (wish_ && *wish_ == Wish::wait) std::this_thread::sleep_for(std::chrono::milliseconds(5));
        if (wish_ && *wish_ == Wish::end) throw Cancelled{};
    }
    const std::atomic<Wish>* wish_ = nullptr;

private:
    std::weak_ptr<const flatten::FlatScene> held_;
};

// name: "cpu" or, for tests, "cpu:NAME": one path at a time (baseline, avx2), or paths side by side (lanes8, lanes16;
// builds with ispc).
std::unique_ptr<Device> make_cpu_device(const std::string& name);
// Returns true if the program contains these kernels and this machine has their instructions.
bool has_cpu_variant(const std::string& name);
// name: "opencl[:index][:compact|bvh8][:gpu]" (opencl_list.h), index among all OpenCL devices, GPUs first.  Throws
// Error (system) without such a device.  The device has not passed a self-test yet: see lib/render.
std::unique_ptr<Device> make_opencl_device(const std::string& name);
// "opencl:0 NVIDIA H200 (GPU, NVIDIA CUDA)" each; empty without an OpenCL platform.  Both ask in a child process,
// because a failing driver may abort; that costs a warning.
std::vector<std::string> opencl_devices();
bool opencl_has_gpu();

}  // namespace device
