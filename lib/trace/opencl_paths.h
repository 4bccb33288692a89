// SPDX-License-Identifier: BSD-3-Clause
// The paths in flight on an OpenCL device: their state, their queues, and the kernels that take them from stage to
// stage (kernels/entry.cl).  Calls throw cl::Error.
#pragma once
#include "kernels/host.h"
#include "trace/opencl_list.h"

namespace trace {

using kernels::Params;

// The buffers of a scene and of the path state, in the order of their lists (kernels/intersect.h,
// kernels/path/state.h), which is that of the kernels' arguments.
#define LUX_TABLE_NUMBER(type, name) TABLE_##name,
enum { SCENE_TABLES(LUX_TABLE_NUMBER) TABLES };
#define LUX_FIELD_NUMBER(type, name, when) PATH_##name,
enum { PATH_STATE(LUX_FIELD_NUMBER) PATH_FIELDS };

class OpenclPaths {
public:
    OpenclPaths() = default;
    // gpu: reading a counter stalls it, and work items that stand side by side should take the same branches.
    OpenclPaths(const cl::Context& context, const cl::CommandQueue& queue, bool gpu);
    // Its kernels from now on.  Those for a GPU shade apart what has met nothing (HAS(SKY), kernels/features.h).
    void use(const cl::Program& program);

    cl::Buffer tables[TABLES];  // the scene's

    // Room for so many paths, and the parameters of their pass.
    void reserve(const Params& par, uint32_t slots);
    // Whole fields of the first n paths.
    void write(int field, const std::vector<kernels::float4>& values);
    void read(int field, std::vector<kernels::float4>& values);

    // Follows the paths of a pass to their ends, which then light the near ends of their groups where they are shared.
    void run(const Params& par);
    // The same from rays that have been written: MODE_WALK, and the shadow rays of MODE_DRAW.
    void walk(const Params& par);
    void draw(const Params& par);
    // What they have gathered, 3 floats each, in the order of the film (kernels/share.h): the device puts them there,
    // for a host would take as long as a GPU for all the rest.
    void receive(const Params& par, std::vector<float>& film);

    // Runs a kernel over n work items.
    void launch(cl::Kernel& kernel, uint32_t n);

private:
    cl::Buffer room(size_t count, size_t bytes_each) const;
    // Runs a kernel that takes the scene, the parameters, the fields, and then `others`.
    template <class... Buffers>
    void stage(cl::Kernel& kernel, uint32_t n, const Buffers&... others) {
        unsigned a = 0;
        for (const auto& table : tables) kernel.setArg(a++, table);
        kernel.setArg(a++, params_);
        for (const auto& field : fields_) kernel.setArg(a++, field);
        (kernel.setArg(a++, others), ...);
        launch(kernel, n);
    }
    void begin(cl::Kernel& kernel, const Params& par);
    void follow();
    void sort(uint32_t active);
    uint32_t count();
    void read_pinned(const cl::Buffer& from, size_t bytes, std::vector<float>& to);

    bool gpu_ = false;
    cl::Context context_;
    cl::CommandQueue queue_;
    cl::Kernel generate_, extend_, shade_, shadow_, swap_, draw_, walk_, thin_, link_, panes_, connect_, weigh_,
        collect_;
    cl::Kernel film_kernel_, sky_, count_kinds_, begin_kinds_, sort_kinds_;
    cl::Buffer fields_[PATH_FIELDS];
    cl::Buffer params_, counters_, kinds_, now_, next_, shadow_queue_, sorted_, film_, pinned_;
    size_t film_bytes_ = 0;
    char* pinned_at_ = nullptr;  // where the host sees pinned_
    uint32_t capacity_ = 0;
    uint32_t needs_ = PATH_ALWAYS;  // the fields that have that capacity
};

}  // namespace trace
