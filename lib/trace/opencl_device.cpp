// SPDX-License-Identifier: BSD-3-Clause
// The OpenCL device: wavefront kernels over buffers; GPUs get the scalar two-wide BVH, CPUs (PoCL) the eight-wide one.
// Compiled programs are cached by the drivers themselves (PoCL, NVIDIA), so that only a first run pays for them.
#include <cstring>
#include <fmt/core.h>

#include "base/error.h"
#include "flatten/build_input.h"
#include "trace/child.h"
#include "trace/device.h"
#include "trace/kernel_cache.h"
#include "trace/opencl_list.h"

namespace trace {
extern const char* const kernel_source;

namespace {

using kernels::float4;  // types of the lists below
using kernels::LinkWords;
using kernels::Panes;
using kernels::uint4;

constexpr uint32_t LOCAL = 64;  // one local size for all kernels: drivers specialise on it

// The buffers of a scene and of the path state, in the order of their lists (kernels/intersect.h,
// kernels/path/state.h).
#define TABLE_NUMBER(type, name) TABLE_##name,
enum { SCENE_TABLES(TABLE_NUMBER) TABLES };
#define FIELD_NUMBER(type, name, when) PATH_##name,
enum { PATH_STATE(FIELD_NUMBER) PATH_FIELDS };

#define RESERVE_FIELD(type, name, when) paths_[PATH_##name] = room(((when) & ~needs_) == 0 ? slots : 1, sizeof(type));

#define SEND_OF_BVH(type, name) tables_[TABLE_##name] = send(tree->name.data(), tree->name.size() * 4);
#define SEND_OF_SCENE(type, name) tables_[TABLE_##name] = send(s.name.data(), s.name.size() * 4);

class OpenclDevice : public Device {
public:
    OpenclDevice(int index, const OpenclEntry& e, bool bvh2)
        : where_(fmt::format("opencl:{}", index)), gpu_(e.gpu), bvh2_(bvh2) {
        call("starting", [&] {
            name_ = describe(e);
            context_ = cl::Context(e.device);
            device_ = e.device;
            queue_ = cl::CommandQueue(context_, e.device);
            program_ = cl::Program(context_, std::string(kernel_source));
            std::string options = "-cl-std=CL1.2";
            if (bvh2_) options += " -DLUX_BVH2";
            const auto fp = e.device.getInfo<CL_DEVICE_SINGLE_FP_CONFIG>();
            if (fp & CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT) options += " -cl-fp32-correctly-rounded-divide-sqrt";
            try {
                program_.build(options.c_str());
            } catch (const cl::Error&) {
                std::string log = program_.getBuildInfo<CL_PROGRAM_BUILD_LOG>(e.device);
                base::fail_system(where_, "the kernels do not compile: " + log.substr(0, 2000));
            }
            generate_ = cl::Kernel(program_, "k_generate");
            extend_ = cl::Kernel(program_, "k_extend");
            shade_ = cl::Kernel(program_, "k_shade");
            shadow_ = cl::Kernel(program_, "k_shadow");
            swap_ = cl::Kernel(program_, "k_swap");
            draw_ = cl::Kernel(program_, "k_draw");
            walk_ = cl::Kernel(program_, "k_walk");
            thin_ = cl::Kernel(program_, "k_thin");
            link_ = cl::Kernel(program_, "k_link");
            connect_ = cl::Kernel(program_, "k_connect");
            weigh_ = cl::Kernel(program_, "k_weigh");
            collect_ = cl::Kernel(program_, "k_collect");
            film_kernel_ = cl::Kernel(program_, "k_film");
            counters_ = cl::Buffer(context_, CL_MEM_READ_WRITE, 16);
            params_ = cl::Buffer(context_, CL_MEM_READ_ONLY, sizeof(Params));
            check_layout();
        });
    }
    std::string name() const override { return "opencl: " + name_; }

    void upload(flatten::FlatScene s) override {
        call("loading the scene", [&] {
            {
                const std::vector<bvh::Input> in = flatten::build_inputs(s);
                const auto tree =
                    bvh2_ ? std::make_shared<const bvh::Tree>(bvh::build2(in.data(), in.size(), s.tell_tree))
                          : s.host_tree();
                BVH_TABLES(SEND_OF_BVH)
            }
            FLAT_TABLES(SEND_OF_SCENE)
            tables_[TABLE_guide] = send(nullptr, 0);
            tables_[TABLE_focus] = send(nullptr, 0);
        });
    }

    void set_numbers(std::vector<float> numbers) override {
        call("sending the view's sources", [&] { tables_[TABLE_f] = send(numbers.data(), numbers.size() * 4); });
    }

    void run(const Params& par, std::vector<float>& rgb) override {
        call("rendering", [&] {
            reserve(par, par.slots);
            begin(generate_, par);
            follow();
            if (par.shared_slots != 0) share(par.slots);
            receive(par, rgb);
        });
    }
    void draw(const Params& par, const std::vector<DrawRay>& rays, std::vector<float>& rgb) override {
        call("drawing sources", [&] {
            const uint32_t n = uint32_t(rays.size());
            reserve(par, n);
            std::vector<kernels::float4> o(n), d(n), c(n);
            for (uint32_t i = 0; i < n; i++) {
                float source;
                std::memcpy(&source, &rays[i].source, 4);
                o[i] = {rays[i].org[0], rays[i].org[1], rays[i].org[2], source};
                d[i] = {rays[i].dir[0], rays[i].dir[1], rays[i].dir[2], rays[i].dist};
                c[i] = {rays[i].weight, rays[i].weight, rays[i].weight, 0};
            }
            queue_.enqueueWriteBuffer(params_, CL_FALSE, 0, sizeof par, &par);
            queue_.enqueueWriteBuffer(paths_[PATH_shadow_org], CL_TRUE, 0, n * 16, o.data());
            queue_.enqueueWriteBuffer(paths_[PATH_shadow_dir], CL_TRUE, 0, n * 16, d.data());
            queue_.enqueueWriteBuffer(paths_[PATH_shadow_rad], CL_TRUE, 0, n * 16, c.data());
            set_scene(draw_);
            launch(draw_, n);
            receive(par, rgb);
        });
    }
    void walk(const Params& par, const std::vector<WalkRay>& rays, std::vector<WalkEnd>& ends) override {
        call("learning where light comes from", [&] {
            const uint32_t n = uint32_t(rays.size());
            reserve(par, n);
            std::vector<kernels::float4> p(n), d(n), share(n);
            for (uint32_t i = 0; i < n; i++) {
                p[i] = {rays[i].org[0], rays[i].org[1], rays[i].org[2], 0};
                d[i] = {rays[i].dir[0], rays[i].dir[1], rays[i].dir[2], rays[i].dir_w};
            }
            queue_.enqueueWriteBuffer(paths_[PATH_org], CL_TRUE, 0, n * 16, p.data());
            queue_.enqueueWriteBuffer(paths_[PATH_dir], CL_TRUE, 0, n * 16, d.data());
            begin(walk_, par);
            follow();
            std::vector<kernels::float4> rad(n);
            queue_.enqueueReadBuffer(paths_[PATH_rad], CL_TRUE, 0, n * 16, rad.data());
            queue_.enqueueReadBuffer(paths_[PATH_thr], CL_TRUE, 0, n * 16, share.data());
            queue_.enqueueReadBuffer(paths_[PATH_org], CL_TRUE, 0, n * 16, p.data());
            queue_.enqueueReadBuffer(paths_[PATH_dir], CL_TRUE, 0, n * 16, d.data());
            ends.resize(n);
            for (uint32_t i = 0; i < n; i++)
                ends[i] = {{rad[i].x, rad[i].y, rad[i].z},
                           {share[i].x, share[i].y, share[i].z},
                           {p[i].x, p[i].y, p[i].z},
                           {d[i].x, d[i].y, d[i].z},
                           d[i].w == WALK_AT_BOUNCE};
        });
    }
    void set_guide(std::vector<uint32_t> guide) override {
        call("sending the guide", [&] { tables_[TABLE_guide] = send(guide.data(), guide.size() * 4); });
    }
    void set_focus(std::vector<uint32_t> pixels) override {
        call("sending the focus", [&] { tables_[TABLE_focus] = send(pixels.data(), pixels.size() * 4); });
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
    cl::Buffer send(const void* data, size_t bytes) {
        cl::Buffer b(context_, CL_MEM_READ_ONLY, std::max<size_t>(bytes, 64));
        if (bytes) queue_.enqueueWriteBuffer(b, CL_TRUE, 0, bytes, data);
        return b;
    }
    void reserve(const Params& par, uint32_t slots) {
        const uint32_t needs = kernels::path_needs(&par);
        if (slots <= capacity_ && (needs & ~needs_) == 0) return;
        capacity_ = std::max(capacity_, slots);
        needs_ |= needs;
        slots = capacity_;
        PATH_STATE(RESERVE_FIELD)
        now_ = room(slots, 4);
        next_ = room(slots, 4);
        shadow_queue_ = room(slots, 4);
    }
    // Fills the queue with the paths that have a ray.
    void begin(cl::Kernel& kernel, const Params& par) {
        queue_.enqueueWriteBuffer(params_, CL_FALSE, 0, sizeof par, &par);
        static const uint32_t zero[4] = {0, 0, 0, 0};  // static: it is read when this has returned
        queue_.enqueueWriteBuffer(counters_, CL_FALSE, 0, 16, zero);
        unsigned a = set_scene(kernel);
        kernel.setArg(a++, counters_);
        kernel.setArg(a++, now_);
        launch(kernel, par.slots);
    }
    // Follows the paths of the queue to their ends.
    void follow() {
        uint32_t active = count();
        // Reading a counter stalls a GPU: it looks every few rounds only, idle work items leave at once.
        const int rounds = gpu_ ? 4 : 1;
        while (active > 0) {
            for (int i = 0; i < rounds; i++) {
                unsigned a = set_scene(extend_);
                extend_.setArg(a++, counters_);
                extend_.setArg(a++, now_);
                launch(extend_, active);
                a = set_scene(shade_);
                shade_.setArg(a++, counters_);
                shade_.setArg(a++, now_);
                shade_.setArg(a++, next_);
                shade_.setArg(a++, shadow_queue_);
                launch(shade_, active);
                a = set_scene(shadow_);
                shadow_.setArg(a++, counters_);
                shadow_.setArg(a++, shadow_queue_);
                launch(shadow_, active);
                swap_.setArg(0, counters_);
                launch(swap_, 1);
                std::swap(now_, next_);
            }
            active = count();
        }
    }
    // Far ends light the near ends of their groups.
    void share(uint32_t slots) {
        for (cl::Kernel* k : {&thin_, &link_, &connect_, &weigh_, &collect_}) {
            set_scene(*k);
            launch(*k, slots);
        }
    }
    cl::Buffer room(size_t count, size_t bytes_each) {
        return cl::Buffer(context_, CL_MEM_READ_WRITE, count * bytes_each);
    }
    unsigned set_scene(cl::Kernel& k) {
        unsigned a = 0;
        for (const auto& table : tables_) k.setArg(a++, table);
        k.setArg(a++, params_);
        for (const auto& field : paths_) k.setArg(a++, field);
        return a;
    }
    void launch(cl::Kernel& k, uint32_t n) {
        queue_.enqueueNDRangeKernel(k, cl::NullRange, cl::NDRange((n + LOCAL - 1) / LOCAL * LOCAL), cl::NDRange(LOCAL));
    }
    uint32_t count() {
        uint32_t n = 0;
        queue_.enqueueReadBuffer(counters_, CL_TRUE, 0, 4, &n);
        return n;
    }
    // The device puts the pixels in their order: a host alone would take as long as a GPU for all the rest.
    void receive(const Params& par, std::vector<float>& rgb) {
        const size_t bytes = size_t(kernels::film_places(&par)) * 12;
        if (bytes > film_bytes_) film_ = room(film_bytes_ = bytes, 1);
        film_kernel_.setArg(0, params_);
        film_kernel_.setArg(1, paths_[PATH_rad]);
        film_kernel_.setArg(2, film_);
        launch(film_kernel_, par.slots);
        rgb.resize(bytes / 4);
        queue_.enqueueReadBuffer(film_, CL_TRUE, 0, bytes, rgb.data());
    }
    // The structures must look the same on both sides.
    void check_layout() {
        cl::Kernel k(program_, "k_layout");
        cl::Buffer b(context_, CL_MEM_READ_WRITE, 64);
        k.setArg(0, b);
        launch(k, 1);
        uint32_t v[5];
        queue_.enqueueReadBuffer(b, CL_TRUE, 0, sizeof v, v);
        const uint32_t here[5] = {sizeof(Params), offsetof(Params, nx), offsetof(Params, mods_at), offsetof(Params, st),
                                  offsetof(Params, light_tree_at)};
        if (std::memcmp(v, here, sizeof v) != 0)
            base::fail_system(where_, "the device lays out structures differently");
    }

    std::string where_, name_;
    bool gpu_, bvh2_;
    cl::Device device_;
    cl::Context context_;
    cl::CommandQueue queue_;
    cl::Program program_;
    cl::Kernel generate_, extend_, shade_, shadow_, swap_, draw_, walk_, thin_, link_, connect_, weigh_, collect_, film_kernel_;
    cl::Buffer tables_[TABLES], paths_[PATH_FIELDS];  // in the order of the kernels' arguments
    cl::Buffer params_, counters_, now_, next_, shadow_queue_, film_;
    size_t film_bytes_ = 0;
    uint32_t capacity_ = 0;
    uint32_t needs_ = PATH_ALWAYS;  // the fields that have that capacity
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
    return std::make_unique<OpenclDevice>(int(choice.index), devices[choice.index], choice.bvh2);
}

}  // namespace trace
