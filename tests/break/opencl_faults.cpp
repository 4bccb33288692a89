// SPDX-License-Identifier: BSD-3-Clause
// A preloaded library that stands between a program and OpenCL, and spoils it as OPENCL_FAULT says: words parted by
// blanks.
//   clNAME:N=CODE    call N (from 0) of that function, and all later ones, fail with this code; N! only call N
//   clNAME:N=hang    they never return;  =die: they end the program
//   read:N=nan|noise|bit   what is read back from call N on is not a number, is off by a third, has a last bit turned
//   memory=MB        the device says it has so much, and gives no more; a buffer has at most a quarter
//   lies=MB          the same, but it says that it has a thousand times that
//   fill=N           buffers hold bytes N before anything is written
//   gpu              devices say that they are GPUs, and the system shows one
// A device that is spoiled has a driver version of its own, so that nothing is remembered of it.
#define CL_TARGET_OPENCL_VERSION 120
#include <CL/cl.h>
#include <dlfcn.h>
#include <glob.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <map>
#include <mutex>
#include <sstream>
#include <string>
#include <vector>

namespace {

std::vector<std::string> words() {
    const char* text = std::getenv("OPENCL_FAULT");
    std::istringstream in(text ? text : "");
    std::vector<std::string> all;
    for (std::string word; in >> word;) all.push_back(word);
    return all;
}

bool says(const std::string& wanted) {
    for (const std::string& word : words())
        if (word == wanted) return true;
    return false;
}

// The number after "name=", 0 without it.
long number(const std::string& name) {
    for (const std::string& word : words())
        if (word.rfind(name + "=", 0) == 0) return std::atol(word.c_str() + name.size() + 1);
    return 0;
}

std::mutex lock;

// What the call that is being made has to suffer: "" or what follows the "=".
std::string fate(const std::string& name) {
    static std::map<std::string, long> calls;
    std::lock_guard<std::mutex> hold(lock);
    const long call = calls[name]++;
    for (const std::string& word : words()) {
        if (word.rfind(name + ":", 0) != 0) continue;
        const char* at = word.c_str() + name.size() + 1;
        char* end = nullptr;
        const long n = std::strtol(at, &end, 10);
        const bool once = *end == '!';
        if (once ? call == n : call >= n) return word.substr(word.find('=') + 1);
    }
    return "";
}

// 0: the call may be made.
int failure(const char* name) {
    const std::string what = fate(name);
    while (what == "hang") sleep(1000);
    if (what == "die") _exit(99);
    return std::atoi(what.c_str());
}

template <class F>
F* real(const char* name, F*) {
    return reinterpret_cast<F*>(dlsym(RTLD_NEXT, name));
}

std::atomic<size_t> given{0};
std::map<cl_mem, size_t> sizes;

}  // namespace

#define REAL(name) real(#name, &name)
// Functions that return their code.
#define PASS(name, parameters, arguments)                 \
    extern "C" cl_int name parameters {                   \
        if (const int code = failure(#name)) return code; \
        return REAL(name) arguments;                      \
    }
// Those that return a handle and give the code by their last argument.
#define MAKE(type, name, parameters, arguments) \
    extern "C" type name parameters {           \
        if (const int code = failure(#name)) {  \
            if (error) *error = code;           \
            return nullptr;                     \
        }                                       \
        return REAL(name) arguments;            \
    }

PASS(clGetPlatformIDs, (cl_uint n, cl_platform_id* p, cl_uint* found), (n, p, found))
PASS(clGetDeviceIDs, (cl_platform_id p, cl_device_type t, cl_uint n, cl_device_id* d, cl_uint* found),
     (p, t, n, d, found))
PASS(clBuildProgram,
     (cl_program p, cl_uint n, const cl_device_id* d, const char* o, void (*f)(cl_program, void*), void* data),
     (p, n, d, o, f, data))
PASS(clSetKernelArg, (cl_kernel k, cl_uint i, size_t size, const void* value), (k, i, size, value))
PASS(clEnqueueNDRangeKernel,
     (cl_command_queue q, cl_kernel k, cl_uint dim, const size_t* offset, const size_t* global, const size_t* local,
      cl_uint n, const cl_event* wait, cl_event* event),
     (q, k, dim, offset, global, local, n, wait, event))
PASS(clEnqueueWriteBuffer,
     (cl_command_queue q, cl_mem b, cl_bool blocking, size_t offset, size_t size, const void* from, cl_uint n,
      const cl_event* wait, cl_event* event),
     (q, b, blocking, offset, size, from, n, wait, event))
PASS(clFlush, (cl_command_queue q), (q))
PASS(clWaitForEvents, (cl_uint n, const cl_event* events), (n, events))
MAKE(cl_context, clCreateContext,
     (const cl_context_properties* p, cl_uint n, const cl_device_id* d,
      void(CL_CALLBACK* f)(const char*, const void*, size_t, void*), void* data, cl_int* error),
     (p, n, d, f, data, error))
MAKE(cl_command_queue, clCreateCommandQueue,
     (cl_context c, cl_device_id d, cl_command_queue_properties p, cl_int* error), (c, d, p, error))
MAKE(cl_program, clCreateProgramWithSource,
     (cl_context c, cl_uint n, const char** text, const size_t* size, cl_int* error), (c, n, text, size, error))
MAKE(cl_kernel, clCreateKernel, (cl_program p, const char* name, cl_int* error), (p, name, error))
MAKE(void*, clEnqueueMapBuffer,
     (cl_command_queue q, cl_mem b, cl_bool blocking, cl_map_flags flags, size_t offset, size_t size, cl_uint n,
      const cl_event* wait, cl_event* event, cl_int* error),
     (q, b, blocking, flags, offset, size, n, wait, event, error))

extern "C" cl_int clEnqueueReadBuffer(cl_command_queue q, cl_mem b, cl_bool blocking, size_t offset, size_t size,
                                      void* to, cl_uint n, const cl_event* wait, cl_event* event) {
    if (const int code = failure("clEnqueueReadBuffer")) return code;
    const std::string what = size > 64 ? fate("read") : "";  // not counters
    const cl_int code =
        REAL(clEnqueueReadBuffer)(q, b, what.empty() ? blocking : CL_TRUE, offset, size, to, n, wait, event);
    auto* values = static_cast<float*>(to);
    for (size_t i = 0; !what.empty() && i < size / 4; i++) {
        if (what == "nan") values[i] = std::nanf("");
        if (what == "noise") values[i] *= i % 2 ? 1.3f : .9f;
        uint32_t word;
        std::memcpy(&word, &values[i], 4);
        word ^= what == "bit" && i % 7 == 0 && std::isnormal(values[i]) ? 1u : 0u;  // sizes of structures are none
        std::memcpy(&values[i], &word, 4);
    }
    return code;
}

extern "C" cl_mem clCreateBuffer(cl_context c, cl_mem_flags flags, size_t size, void* host, cl_int* error) {
    int code = failure("clCreateBuffer");
    const size_t limit = size_t(number("memory") + number("lies")) << 20;
    if (!code && limit > 0 && size > limit / 4) code = CL_INVALID_BUFFER_SIZE;
    if (!code && limit > 0 && given + size > limit) code = CL_MEM_OBJECT_ALLOCATION_FAILURE;
    if (code) {
        if (error) *error = code;
        return nullptr;
    }
    std::vector<char> garbage;
    if (const long fill = number("fill"); fill && !host) {
        garbage.assign(size, char(fill));
        host = garbage.data();
        flags |= CL_MEM_COPY_HOST_PTR;
    }
    const cl_mem made = REAL(clCreateBuffer)(c, flags, size, host, error);
    std::lock_guard<std::mutex> hold(lock);
    if (made) given += sizes[made] = size;
    return made;
}

extern "C" cl_int clReleaseMemObject(cl_mem object) {
    cl_uint count = 0;
    clGetMemObjectInfo(object, CL_MEM_REFERENCE_COUNT, sizeof count, &count, nullptr);
    if (count == 1) {
        std::lock_guard<std::mutex> hold(lock);
        given -= sizes[object];
        sizes.erase(object);
    }
    return REAL(clReleaseMemObject)(object);
}

extern "C" cl_int clGetDeviceInfo(cl_device_id d, cl_device_info what, size_t size, void* to, size_t* needed) {
    if (const int code = failure("clGetDeviceInfo")) return code;
    const cl_int code = REAL(clGetDeviceInfo)(d, what, size, to, needed);
    const cl_ulong limit = cl_ulong(number("memory") + 1000 * number("lies")) << 20;
    if (code || !to) return code;
    if (what == CL_DEVICE_TYPE && says("gpu")) *static_cast<cl_device_type*>(to) = CL_DEVICE_TYPE_GPU;
    if (what == CL_DEVICE_GLOBAL_MEM_SIZE && limit) *static_cast<cl_ulong*>(to) = limit;
    if (what == CL_DEVICE_MAX_MEM_ALLOC_SIZE && limit) *static_cast<cl_ulong*>(to) = limit / 4;
    if (what == CL_DRIVER_VERSION && std::getenv("OPENCL_FAULT")) {
        unsigned hash = 0;
        for (const char* at = std::getenv("OPENCL_FAULT"); *at; at++) hash = hash * 31 + unsigned(*at);
        for (size_t i = 0; i + 1 < size && hash > 0; i++, hash /= 26) static_cast<char*>(to)[i] = char('A' + hash % 26);
    }
    return code;
}

// The system shows a GPU as a file.
extern "C" int glob(const char* pattern, int flags, int (*failed)(const char*, int), glob_t* found) {
    const int code = real("glob", &glob)(pattern, flags, failed, found);
    if (std::strstr(pattern, "/dev/dri") && says("gpu") && found->gl_pathc == 0) found->gl_pathc = 1;
    return code;
}
