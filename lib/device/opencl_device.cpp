// SPDX-License-Identifier: BSD-3-Clause
// The OpenCL device: wavefront kernels over buffers.  GPUs traverse the tree of bvh_compact.h, CPUs (PoCL) the tree of
// bvh8.h.  Drivers cache compiled programs (PoCL, NVIDIA), so that only a first run waits for them.
#include <cerrno>
#include <fmt/core.h>
#include <optional>

#include "base/error.h"
#include "base/shutdown.h"
#include "device/child.h"
#include "device/device.h"
#include "device/features.h"
#include "device/kernel_cache.h"
#include "device/layout.h"
#include "device/opencl_hours.h"
#include "device/opencl_paths.h"
#include "device/wavefront.h"

namespace device {
extern const char* const kernel_source;

namespace {

constexpr uint32_t ALL_FEATURES = ~0u;

#define SEND_OF_BVH(type, name) paths_.set_table(TABLE_##name, send(tree->name));
#define SEND_OF_SCENE(type, name) paths_.set_table(TABLE_##name, send(s.name));
#define SEND_OF_VIEW(type, name) paths_.set_table(TABLE_##name, send(tables.name));

kernels::float3 triple(const float (&v)[3]) { return {v[0], v[1], v[2]}; }

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
            most_paths_ = OpenclPaths::most_paths(device_, gpu_);
            if (!gpu_) compile(ALL_FEATURES);
        });
    }
    std::string name() const override { return "opencl: " + name_; }

    void upload(std::shared_ptr<const flatten::FlatScene> scene) override {
        call("loading the scene", [&] {
            const flatten::FlatScene& s = *scene;
            if (s.built.inputs != tree_inputs_) {
                tree_inputs_.clear();
                const auto& tree = compact_ ? s.built.compact : s.built.wide;
                BVH_TABLES(SEND_OF_BVH)
                tree_inputs_ = s.built.inputs;
            }
            FLAT_TABLES(SEND_OF_SCENE)
            send_view({});
            view_tables_.reset();
            needs_ = features_of_scene(s);
        });
        scene_ = std::move(scene);
    }

    void run(const Params& par, std::vector<float>& rgb) override {
        call("rendering", [&] {
            prepare(par);
            const bool shared = par.reuse_path_count != 0;  // then all parts have one film
            rgb.clear();
            in_parts(par, par.first, par.path_count, [&](const Params& part, uint32_t first) {
                paths_.reserve(part);
                run_paths(paths_, shared);
                paths_.store(part);
                if (!shared) paths_.receive(part, rgb, size_t(first) * 3);
                else if (first + part.path_count == par.path_count) paths_.receive(part, rgb, 0);
            });
        });
    }
    void run_hours(const Params& par, HourPaths& out) override {
        call("rendering hours", [&] {
            prepare(par);
            opencl_hours(paths_, par, most_paths_, out);
        });
    }
    void splat(const Params& par, const std::vector<SplatRay>& rays, std::vector<float>& rgb) override {
        call("drawing sources", [&] {
            prepare(par);
            rgb.clear();
            in_parts(par, 0, uint32_t(rays.size()), [&](const Params& part, uint32_t first) {
                const size_t n = part.path_count;
                std::vector<kernels::float4> o(n), d(n), c(n);
                for (size_t i = 0; i < n; i++) {
                    const SplatRay& ray = rays[first + i];
                    o[i] = kernels::shadow_org_words(triple(ray.org), ray.source);
                    d[i] = kernels::shadow_dir_words(triple(ray.dir), ray.dist);
                    c[i] = kernels::shadow_rad_words({ray.weight, ray.weight, ray.weight}, 0);
                }
                paths_.reserve(part);
                paths_.write(PATH_shadow_org, o);
                paths_.write(PATH_shadow_dir, d);
                paths_.write(PATH_shadow_rad, c);
                paths_.splat();
                paths_.store(part);
                paths_.receive(part, rgb, size_t(first) * 3);
            });
        });
    }
    void pilot(const Params& par, const std::vector<PilotRay>& rays, std::vector<PilotEnd>& ends) override {
        call("learning where light comes from", [&] {
            prepare(par);
            ends.resize(rays.size());
            in_parts(par, 0, uint32_t(rays.size()), [&](const Params& part, uint32_t first) {
                const size_t n = part.path_count;
                std::vector<kernels::float4> p(n), d(n), rad(n), share(n);
                for (size_t i = 0; i < n; i++) {
                    const PilotRay& ray = rays[first + i];
                    p[i] = kernels::org_words(triple(ray.org), 0);
                    d[i] = kernels::dir_words(triple(ray.dir), ray.length);
                }
                paths_.reserve(part);
                paths_.write(PATH_org, p);
                paths_.write(PATH_dir, d);
                paths_.begin_pilots();
                follow_paths(paths_);
                paths_.read(PATH_rad, rad);
                paths_.read(PATH_throughput, share);
                paths_.read(PATH_org, p);
                paths_.read(PATH_dir, d);
                for (size_t i = 0; i < n; i++)
                    ends[first + i] = {{rad[i].x, rad[i].y, rad[i].z},
                                       {share[i].x, share[i].y, share[i].z},
                                       {p[i].x, p[i].y, p[i].z},
                                       {d[i].x, d[i].y, d[i].z},
                                       kernels::dir_length(d[i]) == PILOT_AT_BOUNCE};
            });
        });
    }
    uint32_t preferred_batch_size() const override { return most_paths_; }
    bool compact_tree() const override { return compact_; }
    bool is_async() const override { return true; }
    void heed(const std::atomic<Wish>* wish) override {
        Device::heed(wish);
        paths_.before_bounce = [this] { heed_wish(); };
    }
    std::string own_bits() const override { return own_bits_; }

    // The values of kernels/self_test.h as this device gives them, after a frame of any scene.
    std::vector<float> self_test_numbers(uint32_t n) override {
        std::vector<float> out(n);
        call("testing the device", [&] {
            const cl::Buffer b(context_, CL_MEM_READ_WRITE, out.size() * 4);
            launch_alone("k_self_test", n, b);
            queue_.enqueueReadBuffer(b, CL_TRUE, 0, out.size() * 4, out.data());
        });
        return out;
    }
    std::string identity() override {
        std::string text;
        call("starting", [&] {
            text = name_ + device_.getInfo<CL_DEVICE_VERSION>() + device_.getInfo<CL_DRIVER_VERSION>() + options(0) +
                   (gpu_ ? "gpu" : "");
        });
        return text + kernel_source;
    }
    void set_own_bits(std::string bits) override { own_bits_ = std::move(bits); }

private:
    template <class F>
    void call(const char* doing, F&& work) {
        const base::EndsSoon here;
        try {
            work();
        } catch (const cl::Error& e) {
            errno = 0;
            base::fail_system(where_, fmt::format("{}: {} failed: {}", doing, e.what(), opencl_error(e.err())));
        }
    }
    // Paths first .. first + count - 1, as many at a time as memory allows: a device may report more memory than it can
    // allocate.
    template <class F>
    void in_parts(const Params& par, uint32_t first, uint32_t count, F&& work) {
        for (uint32_t done = 0; done < count;) {
            Params part = par;
            part.first = first + done;
            part.path_count = std::min(most_paths_, count - done);
            try {
                work(part, done);
                done += part.path_count;
            } catch (const cl::Error& e) {
                const bool memory = e.err() == CL_MEM_OBJECT_ALLOCATION_FAILURE || e.err() == CL_OUT_OF_RESOURCES ||
                                    e.err() == CL_INVALID_BUFFER_SIZE;
                if (!memory || part.path_count <= REUSE_SQUARE) throw;
                most_paths_ = std::max(part.path_count / 2 / REUSE_SQUARE, 1u) * REUSE_SQUARE;
                paths_.release();
            }
        }
    }
    // Sends the tables of the view, and compiles kernels: a GPU's contain only the features of the scene and its
    // passes, because each costs registers of every work item.
    void prepare(const Params& par) {
        if (par.view_tables && par.view_tables != view_tables_) {
            send_view(*par.view_tables);
            view_tables_ = par.view_tables;
        }
        if (!gpu_) return;
        needs_ |= features_of_pass(par);
        if (has_ != needs_) compile(needs_);
    }
    std::string options(uint32_t features) const {
        std::string text = fmt::format("-cl-std=CL1.2 -DLUX_HAS={}u", features);
        if (compact_) text += " -DLUX_COMPACT";
        const auto fp = device_.getInfo<CL_DEVICE_SINGLE_FP_CONFIG>();
        if (fp & CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT) text += " -cl-fp32-correctly-rounded-divide-sqrt";
        return text;
    }
    void compile(uint32_t features) {
        program_ = cl::Program(context_, std::string(kernel_source));
        const cl_device_id device = device_();
        const cl_int code = clBuildProgram(program_(), 1, &device, options(features).c_str(), nullptr, nullptr);
        if (code != CL_SUCCESS) {
            std::string log;
            try {
                log = program_.getBuildInfo<CL_PROGRAM_BUILD_LOG>(device_).substr(0, 2000);
            } catch (const cl::Error&) {}
            errno = 0;
            base::fail_system(where_, fmt::format("the kernels do not compile: {} {}", opencl_error(code), log));
        }
        paths_.use(program_);
        has_ = features;
        check_layout();
    }
    void launch_alone(const char* name, uint32_t n, const cl::Buffer& result) {
        cl::Kernel k(program_, name);
        k.setArg(0, result);
        paths_.launch(k, n);
    }
    template <class Values>
    cl::Buffer send(const Values& values) {
        const size_t bytes = values.size() * sizeof(typename Values::value_type);
        cl::Buffer b(context_, CL_MEM_READ_ONLY, std::max<size_t>(bytes, 64));
        if (bytes) queue_.enqueueWriteBuffer(b, CL_TRUE, 0, bytes, values.data());
        return b;
    }
    void send_view(const kernels::ViewTables& tables) { VIEW_TABLES(SEND_OF_VIEW) }
    void check_layout() {
        require_same_layout(where_, [&](RecordSizes& sizes) {
            const cl::Buffer b(context_, CL_MEM_READ_WRITE, sizeof sizes);
            launch_alone("k_layout", 1, b);
            queue_.enqueueReadBuffer(b, CL_TRUE, 0, sizeof sizes, sizes.data());
        });
    }

    std::string where_, name_, own_bits_;
    bool gpu_, compact_;
    uint32_t most_paths_ = 0, needs_ = 0;  // FEATURE_* of the scene and its passes
    std::optional<uint32_t> has_;          // and those that the kernels have
    cl::Device device_;
    cl::Context context_;
    cl::CommandQueue queue_;
    cl::Program program_;
    OpenclPaths paths_;
    std::shared_ptr<const flatten::FlatScene> scene_;
    std::shared_ptr<const kernels::ViewTables> view_tables_;  // that it has
    std::string tree_inputs_;                                 // of the tree that it has (flatten::Trees)
};

}  // namespace

std::unique_ptr<Device> make_opencl_device(const std::string& name) {
    if (choose_kernel_cache().empty())
        base::warn("OpenCL", "no private folder to keep compiled kernels in: they are compiled at every start");
    errno = 0;
    if (!ask_in_child([] { return std::to_string(opencl_entries().size()); }))
        base::fail_system("-device " + name, "an OpenCL driver failed when asked for its devices");
    const auto devices = opencl_entries();
    if (devices.empty()) base::fail_system("-device " + name, "no OpenCL platform or device on this machine");
    const OpenclChoice choice = choose_opencl(name, devices);
    return std::make_unique<OpenclDevice>(devices[choice.index], choice);
}

}  // namespace device
