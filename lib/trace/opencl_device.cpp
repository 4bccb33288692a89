// SPDX-License-Identifier: BSD-3-Clause
// The OpenCL device: wavefront kernels over buffers; GPUs get the scalar two-wide BVH, CPUs (PoCL) the eight-wide one.
// Compiled programs are cached by the drivers themselves (PoCL, NVIDIA), so that only a first run pays for them.
#include <cstring>
#include <fmt/core.h>

#include "base/error.h"
#include "flatten/build_input.h"
#include "trace/child.h"
#include "trace/device.h"
#include "trace/features.h"
#include "trace/kernel_cache.h"
#include "trace/opencl_paths.h"

namespace trace {
extern const char* const kernel_source;

namespace {

constexpr uint32_t ALL_FEATURES = ~0u;

#define SEND_OF_BVH(type, name) paths_.tables[TABLE_##name] = send(tree->name.data(), tree->name.size() * 4);
#define SEND_OF_SCENE(type, name) paths_.tables[TABLE_##name] = send(s.name.data(), s.name.size() * 4);

class OpenclDevice : public Device {
public:
    OpenclDevice(const OpenclEntry& e, const OpenclChoice& choice)
        : where_(fmt::format("opencl:{}", choice.index)), gpu_(choice.as_gpu), compact_(choice.compact) {
        call("starting", [&] {
            name_ = describe(e);
            context_ = cl::Context(e.device);
            queue_ = cl::CommandQueue(context_, e.device);
            device_ = e.device;
            paths_ = OpenclPaths(context_, queue_, gpu_);
            if (!gpu_) compile(ALL_FEATURES);
        });
    }
    std::string name() const override { return "opencl: " + name_; }

    void upload(flatten::FlatScene s) override {
        call("loading the scene", [&] {
            {
                const std::vector<bvh::Input> in = flatten::build_inputs(s);
                const auto tree =
                    compact_ ? std::make_shared<const bvh::Tree>(bvh::build_compact(in.data(), in.size(), s.tell_tree))
                             : s.host_tree();
                BVH_TABLES(SEND_OF_BVH)
            }
            FLAT_TABLES(SEND_OF_SCENE)
            paths_.tables[TABLE_focus] = send(nullptr, 0);
            scene_has_ = features_of_scene(s);
        });
    }

    void set_numbers(std::vector<float> numbers) override {
        call("sending the view's sources", [&] { paths_.tables[TABLE_f] = send(numbers.data(), numbers.size() * 4); });
    }

    void run(const Params& par, std::vector<float>& rgb) override {
        call("rendering", [&] {
            prepare(par);
            paths_.run(par);
            paths_.receive(par, rgb);
        });
    }
    void draw(const Params& par, const std::vector<DrawRay>& rays, std::vector<float>& rgb) override {
        call("drawing sources", [&] {
            const size_t n = rays.size();
            std::vector<kernels::float4> o(n), d(n), c(n);
            for (size_t i = 0; i < n; i++) {
                float source;
                std::memcpy(&source, &rays[i].source, 4);
                o[i] = {rays[i].org[0], rays[i].org[1], rays[i].org[2], source};
                d[i] = {rays[i].dir[0], rays[i].dir[1], rays[i].dir[2], rays[i].dist};
                c[i] = {rays[i].weight, rays[i].weight, rays[i].weight, 0};
            }
            prepare(par);
            paths_.reserve(par, uint32_t(n));
            paths_.write(PATH_shadow_org, o);
            paths_.write(PATH_shadow_dir, d);
            paths_.write(PATH_shadow_rad, c);
            paths_.draw(par);
            paths_.receive(par, rgb);
        });
    }
    void walk(const Params& par, const std::vector<WalkRay>& rays, std::vector<WalkEnd>& ends) override {
        call("learning where light comes from", [&] {
            const size_t n = rays.size();
            std::vector<kernels::float4> p(n), d(n), rad(n), share(n);
            for (size_t i = 0; i < n; i++) {
                p[i] = {rays[i].org[0], rays[i].org[1], rays[i].org[2], 0};
                d[i] = {rays[i].dir[0], rays[i].dir[1], rays[i].dir[2], rays[i].dir_w};
            }
            prepare(par);
            paths_.reserve(par, uint32_t(n));
            paths_.write(PATH_org, p);
            paths_.write(PATH_dir, d);
            paths_.walk(par);
            paths_.read(PATH_rad, rad);
            paths_.read(PATH_thr, share);
            paths_.read(PATH_org, p);
            paths_.read(PATH_dir, d);
            ends.resize(n);
            for (size_t i = 0; i < n; i++)
                ends[i] = {{rad[i].x, rad[i].y, rad[i].z},
                           {share[i].x, share[i].y, share[i].z},
                           {p[i].x, p[i].y, p[i].z},
                           {d[i].x, d[i].y, d[i].z},
                           d[i].w == WALK_AT_BOUNCE};
        });
    }
    void set_focus(std::vector<uint32_t> entries) override {
        call("sending the focus", [&] { paths_.tables[TABLE_focus] = send(entries.data(), entries.size() * 4); });
    }
    uint32_t good_slots() const override { return gpu_ ? 1u << 21 : 1u << 18; }
    bool leaves_host_free() const override { return true; }

private:
    template <class F>
    void call(const char* doing, F&& work) {
        try {
            work();
        } catch (const cl::Error& e) {
            base::fail_system(where_, fmt::format("{}: {} failed with OpenCL error {}", doing, e.what(), e.err()));
        }
    }
    // A GPU's kernels have what the scene and the pass need, for all of it takes registers of each work item.
    void prepare(const Params& par) {
        if (gpu_) compile(has_ | scene_has_ | features_of_pass(par));
    }
    void compile(uint32_t features) {
        if (compiled_ && features == has_) return;
        compiled_ = true;
        has_ = features;
        std::string options = fmt::format("-cl-std=CL1.2 -DLUX_HAS={}u", features);
        if (compact_) options += " -DLUX_COMPACT";
        const auto fp = device_.getInfo<CL_DEVICE_SINGLE_FP_CONFIG>();
        if (fp & CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT) options += " -cl-fp32-correctly-rounded-divide-sqrt";
        program_ = cl::Program(context_, std::string(kernel_source));
        try {
            program_.build(options.c_str());
        } catch (const cl::Error&) {
            std::string log = program_.getBuildInfo<CL_PROGRAM_BUILD_LOG>(device_);
            base::fail_system(where_, "the kernels do not compile: " + log.substr(0, 2000));
        }
        paths_.use(program_);
        check_layout();
    }
    cl::Buffer send(const void* data, size_t bytes) {
        cl::Buffer b(context_, CL_MEM_READ_ONLY, std::max<size_t>(bytes, 64));
        if (bytes) queue_.enqueueWriteBuffer(b, CL_TRUE, 0, bytes, data);
        return b;
    }
    // The structures must look the same on both sides.
    void check_layout() {
        cl::Kernel k(program_, "k_layout");
        cl::Buffer b(context_, CL_MEM_READ_WRITE, 64);
        k.setArg(0, b);
        paths_.launch(k, 1);
        uint32_t v[5];
        queue_.enqueueReadBuffer(b, CL_TRUE, 0, sizeof v, v);
        const uint32_t here[5] = {sizeof(Params), offsetof(Params, nx), offsetof(Params, mods_at), offsetof(Params, st),
                                  offsetof(Params, light_tree_at)};
        if (std::memcmp(v, here, sizeof v) != 0)
            base::fail_system(where_, "the device lays out structures differently");
    }

    std::string where_, name_;
    bool gpu_, compact_, compiled_ = false;
    uint32_t has_ = 0, scene_has_ = 0;  // FEATURE_* that the kernels have, and the scene
    cl::Device device_;
    cl::Context context_;
    cl::CommandQueue queue_;
    cl::Program program_;
    OpenclPaths paths_;
};

}  // namespace

std::unique_ptr<Device> make_opencl_device(const std::string& name) {
    if (!choose_kernel_cache())
        base::warn("OpenCL", "no private folder to keep compiled kernels in: they are compiled at every start");
    if (!ask_in_child([] { return std::to_string(opencl_entries().size()); }))
        base::fail_system("-device " + name, "an OpenCL driver failed when asked for its devices");
    const auto devices = opencl_entries();
    if (devices.empty()) base::fail_system("-device " + name, "no OpenCL platform or device on this machine");
    const OpenclChoice choice = choose_opencl(name, devices);
    return std::make_unique<OpenclDevice>(devices[choice.index], choice);
}

}  // namespace trace
