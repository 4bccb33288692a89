// SPDX-License-Identifier: BSD-3-Clause
// See opencl_paths.h.
#include "device/opencl_paths.h"

#include <algorithm>
#include <cstring>

namespace device {
namespace {

using kernels::ConnectionWords;
using kernels::float4;  // types of the list of fields
using kernels::Mixture;
using kernels::Transmittances;
using kernels::uint4;

constexpr uint32_t LOCAL = 64;  // one local size for all kernels: drivers specialise on it
static_assert(LOCAL == PATH_KINDS, "a group has a work item for each kind of path");
constexpr size_t PIECE = size_t(1) << 21;  // bytes read back at a time
constexpr size_t QUEUES = 4;
constexpr uint32_t zeros[2 * PATH_KINDS] = {};

}  // namespace

OpenclPaths::OpenclPaths(const cl::Context& context, const cl::CommandQueue& queue, bool gpu)
    : gpu_(gpu), context_(context), queue_(queue) {
    params_ = cl::Buffer(context_, CL_MEM_READ_ONLY, sizeof(kernels::Params));
    counters_ = room(4, 4);
    kinds_ = room(2 * PATH_KINDS, 4);
    release();
}

void OpenclPaths::use(const cl::Program& program) {
#define LUX_KERNEL(name) stages_[STAGE_##name].kernel = cl::Kernel(program, "k_" #name);
    LUX_STAGES(LUX_KERNEL)
    forget_arguments();
}

void OpenclPaths::set_table(int table, const cl::Buffer& buffer) {
    tables_[table] = buffer;
    forget_arguments();
}

void OpenclPaths::forget_arguments() {
    for (Stage& stage : stages_) stage.has.clear();
}

void OpenclPaths::Stage::give(unsigned argument, const cl::Buffer& buffer) {
    if (argument >= has.size()) has.resize(argument + 1);
    if (has[argument] == buffer()) return;
    kernel.setArg(argument, buffer);
    has[argument] = buffer();
}

cl::Buffer OpenclPaths::room(size_t count, size_t bytes_each) const {
    return cl::Buffer(context_, CL_MEM_READ_WRITE, count * bytes_each);
}

// Half of the memory, because the scene and other programs use it, too.
uint32_t OpenclPaths::most_paths(const cl::Device& device, bool gpu) {
#define LUX_SIZE(type, name, when, members) sizeof(type),
    constexpr size_t sizes[] = {PATH_STATE(LUX_SIZE)};
    size_t all = QUEUES * 4, largest = 0;
    for (const size_t size : sizes) all += size, largest = std::max(largest, size);
    const uint64_t one = device.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>() / largest,
                   total = device.getInfo<CL_DEVICE_GLOBAL_MEM_SIZE>() / 2 / all;
    const uint64_t most = std::min({gpu ? uint64_t(1) << 21 : uint64_t(1) << 18, one, total});
    return std::max(uint32_t(most) / REUSE_SQUARE, 1u) * REUSE_SQUARE;
}

void OpenclPaths::release() {
    for (cl::Buffer& field : fields_) field = {};
    for (cl::Buffer* queue : {&now_, &next_, &shadow_queue_, &sorted_}) *queue = {};
    queue_.enqueueWriteBuffer(kinds_, CL_TRUE, 0, sizeof zeros, zeros);
    forget_arguments();
    capacity_ = 0;
    needs_ = PATH_ALWAYS;
}

void OpenclPaths::reserve(const kernels::Params& par) {
    const uint32_t count = par.path_count;
    par_ = par;
    queue_.enqueueWriteBuffer(params_, CL_TRUE, 0, sizeof par, &par);
    count_ = count;
    const uint32_t needs = needs_ | kernels::path_needs(&par), capacity = std::max(capacity_, count);
    if (capacity == capacity_ && needs == needs_) return;
    release();
#define LUX_ROOM(type, name, when, members) \
    fields_[PATH_##name] = room(((when) & ~needs) == 0 ? capacity : 1, sizeof(type));
    PATH_STATE(LUX_ROOM)
    for (cl::Buffer* queue : {&now_, &next_, &shadow_queue_, &sorted_}) *queue = room(capacity, 4);
    capacity_ = capacity;
    needs_ = needs;
}

void OpenclPaths::write(int field, const std::vector<float4>& values) {
    queue_.enqueueWriteBuffer(fields_[field], CL_TRUE, 0, values.size() * 16, values.data());
}

void OpenclPaths::read(int field, std::vector<float4>& values) {
    queue_.enqueueReadBuffer(fields_[field], CL_TRUE, 0, values.size() * 16, values.data());
}

// In several launches if a single one could last until a desktop's watchdog stops it: k_connection traces up to 16 rays
// a work item.
void OpenclPaths::launch(const cl::Kernel& kernel, uint32_t n) {
    const uint32_t most = kernel() == stages_[STAGE_connection].kernel() ? 1u << 18 : n;
    for (uint32_t first = 0; first < n; first += most) {
        const cl::NDRange items((std::min(most, n - first) + LOCAL - 1) / LOCAL * LOCAL);
        queue_.enqueueNDRangeKernel(kernel, first > 0 ? cl::NDRange(first) : cl::NullRange, items, cl::NDRange(LOCAL));
    }
}

// Fills the queue with the paths that have a ray.
void OpenclPaths::begin(int first) {
    queue_.enqueueWriteBuffer(counters_, CL_FALSE, 0, 16, zeros);
    stage(first, count_, counters_, now_);
    bounces_ = 0;
}

bool OpenclPaths::has_paths() {
    const uint32_t unread = gpu_ ? 4 : 1;  // bounces between reads of the counter; idle work items leave at once
    if (bounces_++ % unread == 0) {
        queue_.enqueueReadBuffer(counters_, CL_TRUE, 0, 4, &active_);
        if (active_ > 0 && before_bounce) before_bounce();
    }
    return active_ > 0;
}

void OpenclPaths::extend() { stage(STAGE_extend, active_, counters_, now_); }

void OpenclPaths::shade() {
    if (gpu_) {
        sort();
        stage(STAGE_sky, active_, counters_, now_);
    }
    stage(STAGE_shade, active_, counters_, now_, next_, shadow_queue_);
}

void OpenclPaths::suns(uint32_t suns, std::vector<uint32_t>& queue, std::vector<float>& rows) {
    uint32_t n = 0;
    queue_.enqueueReadBuffer(counters_, CL_TRUE, 0, 4, &n);
    queue.resize(n);
    rows.resize(size_t(n) * suns * 6);
    if (rows.empty()) return;
    wide_ = room(rows.size(), 4);
    stage(STAGE_suns, n, counters_, now_, wide_);
    queue_.enqueueReadBuffer(now_, CL_TRUE, 0, 4 * size_t(n), queue.data());
    queue_.enqueueReadBuffer(wide_, CL_TRUE, 0, 4 * rows.size(), rows.data());
}

void OpenclPaths::begin_round(uint32_t turn) {
    par_.reuse_turn = turn;
    queue_.enqueueWriteBuffer(params_, CL_TRUE, 0, sizeof par_, &par_);
}

void OpenclPaths::suffix_shares(std::vector<float4>& found) {
    const size_t before = found.size(), more = size_t(count_) * REUSE_GROUP;
    found.resize(before + more);
    wide_ = room(more, sizeof(float4));
    stage(STAGE_suffix_shares, count_, wide_);
    queue_.enqueueReadBuffer(wide_, CL_TRUE, 0, more * sizeof(float4), &found[before]);
}

void OpenclPaths::shadow() { stage(STAGE_shadow, active_, counters_, shadow_queue_); }

void OpenclPaths::next_bounce() {
    launch(STAGE_swap, 1, counters_);
    std::swap(now_, next_);
}

// Sorts paths by kind: a counting sort.
void OpenclPaths::sort() {
    stage(STAGE_count_kinds, active_, counters_, now_, kinds_);
    launch(STAGE_begin_kinds, 1, kinds_);
    stage(STAGE_sort_kinds, active_, counters_, now_, kinds_, sorted_);
    std::swap(now_, sorted_);
}

void OpenclPaths::store(const kernels::Params& par) {
    const size_t bytes = size_t(kernels::film_places(&par)) * 12;
    if (bytes > film_bytes_) {
        film_ = {}, film_bytes_ = 0;
        forget_arguments();
        film_ = room(bytes, 1), film_bytes_ = bytes;
    }
    launch(STAGE_film, count_, params_, fields_[PATH_rad], film_);
}

void OpenclPaths::receive(const kernels::Params& par, std::vector<float>& film, size_t at) {
    const size_t bytes = size_t(kernels::film_places(&par)) * 12;
    if (gpu_) return read_pinned(film_, bytes, film, at);
    film.resize(at + bytes / 4);
    queue_.enqueueReadBuffer(film_, CL_TRUE, 0, bytes, &film[at]);
}

// Reads through pinned memory, as vendors advise, in two pieces: one is copied while the next one arrives.  The
// result's memory is allocated while the GPU still works.
void OpenclPaths::read_pinned(const cl::Buffer& from, size_t bytes, std::vector<float>& to, size_t start) {
    if (!pinned_at_) {
        pinned_ = cl::Buffer(context_, CL_MEM_READ_WRITE | CL_MEM_ALLOC_HOST_PTR, 2 * PIECE);
        pinned_at_ =
            static_cast<char*>(queue_.enqueueMapBuffer(pinned_, CL_TRUE, CL_MAP_READ | CL_MAP_WRITE, 0, 2 * PIECE));
    }
    cl::Event come[2];
    const auto size_at = [&](size_t at) { return std::min(PIECE, bytes - at); };
    const auto place = [&](size_t at) { return at / PIECE % 2; };
    const auto send_for = [&](size_t at) {
        queue_.enqueueReadBuffer(from, CL_FALSE, at, size_at(at), pinned_at_ + place(at) * PIECE, nullptr,
                                 &come[place(at)]);
        queue_.flush();
    };
    if (bytes > 0) send_for(0);
    to.resize(start + bytes / 4);
    for (size_t at = 0; at < bytes; at += PIECE) {
        if (at + PIECE < bytes) send_for(at + PIECE);
        come[place(at)].wait();
        std::memcpy(reinterpret_cast<char*>(&to[start]) + at, pinned_at_ + place(at) * PIECE, size_at(at));
    }
}

}  // namespace device
