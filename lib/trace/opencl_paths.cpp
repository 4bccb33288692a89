// SPDX-License-Identifier: BSD-3-Clause
// See opencl_paths.h.
#include "trace/opencl_paths.h"

#include <algorithm>
#include <cstring>

namespace trace {
namespace {

using kernels::float4;  // types of the list of fields
using kernels::LinkWords;
using kernels::Panes;
using kernels::uint4;

constexpr uint32_t LOCAL = 64;  // one local size for all kernels: drivers specialise on it
static_assert(LOCAL == PATH_KINDS, "a group has a work item for each kind of path");
constexpr size_t PIECE = size_t(1) << 21;  // bytes read back at a time
constexpr uint32_t zeros[2 * PATH_KINDS] = {};

}  // namespace

OpenclPaths::OpenclPaths(const cl::Context& context, const cl::CommandQueue& queue, bool gpu)
    : gpu_(gpu), context_(context), queue_(queue) {
    params_ = cl::Buffer(context_, CL_MEM_READ_ONLY, sizeof(Params));
    counters_ = room(4, 4);
    kinds_ = room(2 * PATH_KINDS, 4);
    queue_.enqueueWriteBuffer(kinds_, CL_TRUE, 0, sizeof zeros, zeros);
}

void OpenclPaths::use(const cl::Program& program) {
    generate_ = cl::Kernel(program, "k_generate");
    extend_ = cl::Kernel(program, "k_extend");
    shade_ = cl::Kernel(program, "k_shade");
    shadow_ = cl::Kernel(program, "k_shadow");
    swap_ = cl::Kernel(program, "k_swap");
    draw_ = cl::Kernel(program, "k_draw");
    walk_ = cl::Kernel(program, "k_walk");
    thin_ = cl::Kernel(program, "k_thin");
    link_ = cl::Kernel(program, "k_link");
    panes_ = cl::Kernel(program, "k_panes");
    connect_ = cl::Kernel(program, "k_connect");
    weigh_ = cl::Kernel(program, "k_weigh");
    collect_ = cl::Kernel(program, "k_collect");
    film_kernel_ = cl::Kernel(program, "k_film");
    count_kinds_ = cl::Kernel(program, "k_count_kinds");
    begin_kinds_ = cl::Kernel(program, "k_begin_kinds");
    sort_kinds_ = cl::Kernel(program, "k_sort_kinds");
    sky_ = cl::Kernel(program, "k_sky");
}

cl::Buffer OpenclPaths::room(size_t count, size_t bytes_each) const {
    return cl::Buffer(context_, CL_MEM_READ_WRITE, count * bytes_each);
}

void OpenclPaths::reserve(const Params& par, uint32_t slots) {
    const uint32_t needs = kernels::path_needs(&par);
    queue_.enqueueWriteBuffer(params_, CL_TRUE, 0, sizeof par, &par);
    if (slots <= capacity_ && (needs & ~needs_) == 0) return;
    capacity_ = std::max(capacity_, slots);
    needs_ |= needs;
#define LUX_ROOM(type, name, when) fields_[PATH_##name] = room(((when) & ~needs_) == 0 ? capacity_ : 1, sizeof(type));
    PATH_STATE(LUX_ROOM)
    for (cl::Buffer* queue : {&now_, &next_, &shadow_queue_, &sorted_}) *queue = room(capacity_, 4);
}

void OpenclPaths::write(int field, const std::vector<float4>& values) {
    queue_.enqueueWriteBuffer(fields_[field], CL_TRUE, 0, values.size() * 16, values.data());
}

void OpenclPaths::read(int field, std::vector<float4>& values) {
    queue_.enqueueReadBuffer(fields_[field], CL_TRUE, 0, values.size() * 16, values.data());
}

void OpenclPaths::launch(cl::Kernel& kernel, uint32_t n) {
    const cl::NDRange items((n + LOCAL - 1) / LOCAL * LOCAL);
    queue_.enqueueNDRangeKernel(kernel, cl::NullRange, items, cl::NDRange(LOCAL));
}

uint32_t OpenclPaths::count() {
    uint32_t n = 0;
    queue_.enqueueReadBuffer(counters_, CL_TRUE, 0, 4, &n);
    return n;
}

void OpenclPaths::run(const Params& par) {
    reserve(par, par.slots);
    begin(generate_, par);
    follow();
    if (par.shared_slots == 0) return;
    for (cl::Kernel* kernel : {&thin_, &link_, &panes_, &connect_, &weigh_, &collect_}) stage(*kernel, par.slots);
}

void OpenclPaths::walk(const Params& par) {
    begin(walk_, par);
    follow();
}

void OpenclPaths::draw(const Params& par) { stage(draw_, par.slots); }

// Fills the queue with the paths that have a ray.
void OpenclPaths::begin(cl::Kernel& kernel, const Params& par) {
    queue_.enqueueWriteBuffer(counters_, CL_FALSE, 0, 16, zeros);
    stage(kernel, par.slots, counters_, now_);
}

// Follows the paths of the queue to their ends.
void OpenclPaths::follow() {
    const int rounds = gpu_ ? 4 : 1;  // between looks at the counter; idle work items leave at once
    for (uint32_t active = count(); active > 0; active = count())
        for (int i = 0; i < rounds; i++) {
            stage(extend_, active, counters_, now_);
            if (gpu_) {
                sort(active);
                stage(sky_, active, counters_, now_);
            }
            stage(shade_, active, counters_, now_, next_, shadow_queue_);
            stage(shadow_, active, counters_, shadow_queue_);
            swap_.setArg(0, counters_);
            launch(swap_, 1);
            std::swap(now_, next_);
        }
}

// Paths of one kind side by side: a counting sort.
void OpenclPaths::sort(uint32_t active) {
    stage(count_kinds_, active, counters_, now_, kinds_);
    begin_kinds_.setArg(0, kinds_);
    launch(begin_kinds_, 1);
    stage(sort_kinds_, active, counters_, now_, kinds_, sorted_);
    std::swap(now_, sorted_);
}

void OpenclPaths::receive(const Params& par, std::vector<float>& film) {
    const size_t bytes = size_t(kernels::film_places(&par)) * 12;
    if (bytes > film_bytes_) film_ = room(film_bytes_ = bytes, 1);
    film_kernel_.setArg(0, params_);
    film_kernel_.setArg(1, fields_[PATH_rad]);
    film_kernel_.setArg(2, film_);
    launch(film_kernel_, par.slots);
    if (gpu_) {
        read_pinned(film_, bytes, film);
        return;
    }
    film.resize(bytes / 4);
    queue_.enqueueReadBuffer(film_, CL_TRUE, 0, bytes, film.data());
}

// By way of memory that a GPU writes to by itself, as vendors advise: two pieces of it, one of which is copied from
// while the next one comes.  Room for all of them is made while the GPU is still at work.
void OpenclPaths::read_pinned(const cl::Buffer& from, size_t bytes, std::vector<float>& to) {
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
    to.resize(bytes / 4);
    for (size_t at = 0; at < bytes; at += PIECE) {
        if (at + PIECE < bytes) send_for(at + PIECE);
        come[place(at)].wait();
        std::memcpy(reinterpret_cast<char*>(to.data()) + at, pinned_at_ + place(at) * PIECE, size_at(at));
    }
}

}  // namespace trace
