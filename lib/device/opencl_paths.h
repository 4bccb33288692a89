// SPDX-License-Identifier: BSD-3-Clause
// The paths in flight on an OpenCL device: their state, their queues, and the kernels of each stage (kernels/entry.cl):
// a backend of wavefront.h.  Calls throw cl::Error.
#pragma once
#include <functional>

#include "kernels/dialect/host.h"
#include "device/opencl_list.h"

namespace device {

// Buffers of a scene and of the path state, in the order of their lists (kernels/bvh/intersect.h,
// kernels/integrator/state.h), which is the order of the kernels' arguments.
#define LUX_TABLE_NUMBER(type, name) TABLE_##name,
enum { SCENE_TABLES(LUX_TABLE_NUMBER) TABLES };
#define LUX_FIELD_NUMBER(type, name, when, members) PATH_##name,
enum { PATH_STATE(LUX_FIELD_NUMBER) PATH_FIELDS };

// The kernels, k_NAME each.
// clang-format off
#define LUX_STAGES(S)                                                                                           \
    S(generate) S(extend) S(count_kinds) S(begin_kinds) S(sort_kinds) S(sky) S(shade) S(shadow) S(swap) S(splat) \
    S(suns) S(suffix_shares) S(pilot) S(suffix_roulette) S(connection) S(transmittance) S(connect)               \
    S(normalise_mis) S(gather) S(film)
// clang-format on
#define LUX_STAGE_NUMBER(name) STAGE_##name,
enum { LUX_STAGES(LUX_STAGE_NUMBER) STAGES };

class OpenclPaths {
public:
    OpenclPaths() = default;
    // gpu: reading a counter stalls it, and neighbouring work items should take the same branches.
    OpenclPaths(const cl::Context& context, const cl::CommandQueue& queue, bool gpu);
    // Sets the kernels.  Kernels for a GPU shade paths without a hit separately (HAS(SKY), kernels/features.h).
    void use(const cl::Program& program);
    void set_table(int table, const cl::Buffer& buffer);  // of the scene
    const cl::Buffer& table(int table) const { return tables_[table]; }
    std::function<void()> before_bounce;  // may throw

    // Number of paths that the device's memory can hold.
    static uint32_t most_paths(const cl::Device& device, bool gpu);
    // Allocates memory for the paths of a pass, and sets its parameters.
    void reserve(const kernels::Params& par);
    void release();  // frees that memory
    // Reads or writes whole fields of the first n paths.
    void write(int field, const std::vector<kernels::float4>& values);
    void read(int field, std::vector<kernels::float4>& values);

    // Stages (wavefront.h) of the paths reserved last.  Rays that the host has written: those of MODE_PILOT, and the
    // shadow rays of MODE_SPLAT.
    void generate() { begin(STAGE_generate); }
    void begin_pilots() { begin(STAGE_pilot); }
    void splat() { stage(STAGE_splat, count_); }
    bool has_paths();
    void extend();
    void shade();
    void shadow();
    void next_bounce();
    template <class F>
    void in_reuse_parts(F&& reuse) {
        reuse(*this);
    }
    void begin_round(uint32_t turn);
    void suffix_roulette() { stage(STAGE_suffix_roulette, count_); }
    void see_connections() { stage(STAGE_connection, count_); }
    void attenuate_connections() { stage(STAGE_transmittance, count_); }
    void connect() { stage(STAGE_connect, count_); }
    void normalise_mis() { stage(STAGE_normalise_mis, count_); }
    void gather() { stage(STAGE_gather, count_); }

    // For many hours: responses of the queue's paths to so many suns, 6 floats each (k_suns), and those paths; what
    // the paths have found in this round, after what is in `found` (k_suffix_shares).
    void suns(uint32_t suns, std::vector<uint32_t>& queue, std::vector<float>& rows);
    void suffix_shares(std::vector<kernels::float4>& found);

    // Adds the paths' radiance to the film, 3 floats each, in its order (kernels/integrator/path_reuse.h), on the
    // device, because the host would take as long as a GPU takes for the rest.
    void store(const kernels::Params& par);
    // Reads the film from index `at` on.
    void receive(const kernels::Params& par, std::vector<float>& film, size_t at);

    // Runs a kernel over n work items.
    void launch(const cl::Kernel& kernel, uint32_t n);

private:
    // A kernel and its present buffers, so that a launch sets only those that change.
    struct Stage {
        cl::Kernel kernel;
        std::vector<cl_mem> has;
        void give(unsigned argument, const cl::Buffer& buffer);
    };
    cl::Buffer room(size_t count, size_t bytes_each) const;
    void forget_arguments();  // a new buffer may reuse the handle of a freed one
    template <class... Buffers>
    void launch(int stage, uint32_t n, const Buffers&... arguments) {
        unsigned a = 0;
        (stages_[stage].give(a++, arguments), ...);
        launch(stages_[stage].kernel, n);
    }
    // Runs a kernel that takes the scene, the parameters, the fields, and then `others`.
    template <class... Buffers>
    void stage(int stage, uint32_t n, const Buffers&... others) {
        unsigned a = 0;
        for (const auto& table : tables_) stages_[stage].give(a++, table);
        stages_[stage].give(a++, params_);
        for (const auto& field : fields_) stages_[stage].give(a++, field);
        (stages_[stage].give(a++, others), ...);
        launch(stages_[stage].kernel, n);
    }
    void begin(int stage);
    void sort();
    void read_pinned(const cl::Buffer& from, size_t bytes, std::vector<float>& to, size_t at);

    bool gpu_ = false;
    cl::Context context_;
    cl::CommandQueue queue_;
    Stage stages_[STAGES];
    cl::Buffer tables_[TABLES], fields_[PATH_FIELDS];
    cl::Buffer wide_;  // of what many hours ask
    cl::Buffer params_, counters_, kinds_, now_, next_, shadow_queue_, sorted_, film_, pinned_;
    size_t film_bytes_ = 0;
    char* pinned_at_ = nullptr;  // where the host sees pinned_
    uint32_t capacity_ = 0;
    kernels::Params par_ = {};
    uint32_t count_ = 0;                 // paths of the pass
    uint32_t active_ = 0, bounces_ = 0;  // at most so many are in the queue; since begin()
    uint32_t needs_ = PATH_ALWAYS;       // the fields that have that capacity
};

}  // namespace device
