// SPDX-License-Identifier: BSD-3-Clause
// Devices by the names of -device, and the list of available devices.
#include <fmt/core.h>

#include "render/make_device.h"

#include "base/error.h"
#include "device/kernel_cache.h"
#include "render/self_test.h"

namespace render {
using device::Params;
namespace {

void say_processor_goes_on(const base::Error& e) {
    if (e.kind != base::Kind::system) throw;
    base::warn(e.where, e.message + "; the processor goes on in its place");
}

// -device auto on a machine with a GPU: after the GPU's first failure the processor replaces it, even within a frame,
// because it gives the same bits.  A GPU with other bits is replaced only before its first frame.
class GpuOrCpu : public device::Device {
public:
    explicit GpuOrCpu(std::unique_ptr<device::Device> gpu) : device_(std::move(gpu)) {}
    std::string name() const override { return device_->name(); }
    uint32_t preferred_batch_size() const override { return device_->preferred_batch_size(); }
    bool compact_tree() const override { return device_->compact_tree(); }
    bool is_async() const override { return device_->is_async(); }
    std::string own_bits() const override { return device_->own_bits(); }

    void upload(std::shared_ptr<const flatten::FlatScene> scene) override {
        scene_.reset();
        attempt([&] { device_->upload(scene); });
        if (!on_cpu_) scene_ = std::move(scene);
    }
    void heed(const std::atomic<device::Wish>* wish) override {
        Device::heed(wish);
        device_->heed(wish);
    }
    void run(const Params& par, std::vector<float>& rgb) override {
        attempt([&] { device_->run(par, rgb); });
        has_run_ = true;
    }
    void run_hours(const Params& par, device::HourPaths& out) override {
        attempt([&] { device_->run_hours(par, out); });
        has_run_ = true;
    }
    void splat(const Params& par, const std::vector<device::SplatRay>& rays, std::vector<float>& rgb) override {
        attempt([&] { device_->splat(par, rays, rgb); });
    }
    void pilot(const Params& par, const std::vector<device::PilotRay>& rays,
               std::vector<device::PilotEnd>& ends) override {
        attempt([&] { device_->pilot(par, rays, ends); });
    }

private:
    template <class F>
    void attempt(F&& work) {
        try {
            return work();
        } catch (const base::Error& e) {
            if (on_cpu_ || (has_run_ && !own_bits().empty())) throw;
            say_processor_goes_on(e);
        }
        device_ = device::make_cpu_device("cpu");
        on_cpu_ = true;
        device_->heed(wish_);
        if (scene_) device_->upload(std::move(scene_));
        scene_.reset();
        work();
    }

    std::unique_ptr<device::Device> device_;
    bool on_cpu_ = false, has_run_ = false;
    std::shared_ptr<const flatten::FlatScene> scene_;  // for the processor, if it has to take over
};

std::unique_ptr<device::Device> tested(std::unique_ptr<device::Device> device, const std::string& folder) {
    device->set_own_bits(self_test(*device, folder));
    return device;
}

std::unique_ptr<device::Device> make_tested_opencl_device(const std::string& name) {
    return tested(device::make_opencl_device(name), device::choose_kernel_cache());
}

std::unique_ptr<device::Device> make_auto_device() {
    if (!device::opencl_has_gpu()) return device::make_cpu_device("cpu");
    try {
        return std::make_unique<GpuOrCpu>(make_tested_opencl_device("opencl"));
    } catch (const base::Error& e) {
        say_processor_goes_on(e);
        return device::make_cpu_device("cpu");
    }
}

}  // namespace

std::vector<std::string> list_devices() {
    std::vector<std::string> out = {device::make_cpu_device("cpu")->name()};
    for (auto& d : device::opencl_devices()) out.push_back(d);
    return out;
}

std::unique_ptr<device::Device> make_device(const std::string& name) {
    if (name == "auto") return make_auto_device();
    const std::string kind = name.substr(0, name.find(':'));
    if (kind == "cpu") return device::make_cpu_device(name);
    if (kind == "opencl") return make_tested_opencl_device(name);
    base::fail("-device", fmt::format("\"{}\" is not auto, cpu or opencl[:index or name]", name));
}

}  // namespace render
