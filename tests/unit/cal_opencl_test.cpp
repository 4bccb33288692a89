// SPDX-License-Identifier: BSD-3-Clause
// The register VM and the device math on every OpenCL device: the same bits as the host (CPUs), the same values (GPUs).
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#define CL_TARGET_OPENCL_VERSION 120
#include <CL/cl.h>
#include <doctest/doctest.h>
#include <cstring>
#include "unit/cal_pattern_rows.h"

namespace {

const char* const source = R"CL(
#include "kernels/dialect/compat_opencl.h"
#include "kernels/math/vec.h"
#include "kernels/math/math.h"
#include "kernels/bvh/intersect.h"
#include "kernels/cal/cal_vm.h"
// item i runs program entry[i] on its own variables
__kernel void run(__global const uint* words, __global const float* floats, __global const uint* entry,
                  __global const float* vars, __global float* result, __global int* error) {
    uint i = get_global_id(0);
    float v[CAL_VARS], out[CAL_OUTPUTS];
    SceneTables s;
    s.u = words;
    s.f = floats;
    for (int k = 0; k < CAL_VARS; k++) v[k] = vars[i * CAL_VARS + k];
    out[0] = 0.0f;
    error[i] = cal_run(&s, entry[i], v, out);
    result[i] = out[0];
}
)CL";

struct Device {
    cl_device_id id;
    std::string name;
    bool cpu;
};
std::vector<Device> devices() {
    std::vector<Device> found;
    cl_platform_id platforms[8];
    cl_uint count = 0;
    if (clGetPlatformIDs(8, platforms, &count) != CL_SUCCESS) return found;
    for (cl_uint i = 0; i < count && i < 8; i++) {
        cl_device_id ids[8];
        cl_uint n = 0;
        if (clGetDeviceIDs(platforms[i], CL_DEVICE_TYPE_ALL, 8, ids, &n) != CL_SUCCESS) continue;
        for (cl_uint k = 0; k < n && k < 8; k++) {
            char name[256] = "";
            cl_device_type type = 0;
            clGetDeviceInfo(ids[k], CL_DEVICE_NAME, sizeof name, name, nullptr);
            clGetDeviceInfo(ids[k], CL_DEVICE_TYPE, sizeof type, &type, nullptr);
            found.push_back({ids[k], name, (type & CL_DEVICE_TYPE_CPU) != 0});
        }
    }
    return found;
}

struct Result {
    std::vector<float> value;
    std::vector<int> error;
};

Result run_on(const Device& device, const cal::Code& code, const std::vector<uint32_t>& entries,
              const std::vector<float>& vars) {
    cl_int e = 0;
    cl_context context = clCreateContext(nullptr, 1, &device.id, nullptr, nullptr, &e);
    REQUIRE(e == CL_SUCCESS);
    cl_command_queue queue = clCreateCommandQueue(context, device.id, 0, &e);
    cl_program program = clCreateProgramWithSource(context, 1, const_cast<const char**>(&source), nullptr, &e);
    const std::string options = std::string("-cl-std=CL1.2 -cl-fp32-correctly-rounded-divide-sqrt -I ") +
                                LUXPIPE_TESTS "/../lib -I " + LUXPIPE_TESTS "/../lib/kernels";
    if (clBuildProgram(program, 1, &device.id, options.c_str(), nullptr, nullptr) != CL_SUCCESS) {
        char log[4000] = "";
        clGetProgramBuildInfo(program, device.id, CL_PROGRAM_BUILD_LOG, sizeof log - 1, log, nullptr);
        FAIL(log);
    }
    cl_kernel kernel = clCreateKernel(program, "run", &e);
    REQUIRE(e == CL_SUCCESS);
    const size_t n = entries.size();
    auto input = [&](const void* data, size_t bytes) {
        char none[16] = "";
        return clCreateBuffer(context, CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR, bytes ? bytes : sizeof none,
                              bytes ? const_cast<void*>(data) : none, &e);
    };
    cl_mem buffers[6] = {input(code.words.data(), code.words.size() * 4),
                         input(code.floats.data(), code.floats.size() * 4),
                         input(entries.data(), n * 4),
                         input(vars.data(), vars.size() * 4),
                         clCreateBuffer(context, CL_MEM_WRITE_ONLY, n * 4, nullptr, &e),
                         clCreateBuffer(context, CL_MEM_WRITE_ONLY, n * 4, nullptr, &e)};
    for (cl_uint i = 0; i < 6; i++) clSetKernelArg(kernel, i, sizeof(cl_mem), &buffers[i]);
    REQUIRE(clEnqueueNDRangeKernel(queue, kernel, 1, nullptr, &n, nullptr, 0, nullptr, nullptr) == CL_SUCCESS);
    Result r{std::vector<float>(n), std::vector<int>(n)};
    REQUIRE(clEnqueueReadBuffer(queue, buffers[4], CL_TRUE, 0, n * 4, r.value.data(), 0, nullptr, nullptr) ==
            CL_SUCCESS);
    REQUIRE(clEnqueueReadBuffer(queue, buffers[5], CL_TRUE, 0, n * 4, r.error.data(), 0, nullptr, nullptr) ==
            CL_SUCCESS);
    for (cl_mem m : buffers) clReleaseMemObject(m);
    clReleaseKernel(kernel);
    clReleaseProgram(program);
    clReleaseCommandQueue(queue);
    clReleaseContext(context);
    return r;
}

struct Job {
    cal::Code code;
    std::vector<uint32_t> entries;
    std::vector<float> vars;
    void add(uint32_t entry, const std::vector<float>& v) {
        entries.push_back(entry);
        vars.insert(vars.end(), v.begin(), v.end());
    }
};

// Runs the job on the host and on each device; returns the number of differing results (all are to agree on CPUs).
void compare(const Job& job) {
    const size_t n = job.entries.size();
    Result host{std::vector<float>(n), std::vector<int>(n)};
    cal::device::SceneTables tables{};
    tables.u = job.code.words.data();
    tables.f = job.code.floats.data();
    for (size_t i = 0; i < n; i++) {
        float out[CAL_OUTPUTS] = {};
        host.error[i] = cal::device::cal_run(&tables, job.entries[i], &job.vars[i * cal::device::CAL_VARS], out);
        host.value[i] = out[0];
    }
    const std::vector<Device> all = devices();
    if (all.empty()) MESSAGE("no OpenCL device: skipped");
    for (const Device& device : all) {
        const Result there = run_on(device, job.code, job.entries, job.vars);
        int bits = 0, values = 0, errors = 0;
        for (size_t i = 0; i < n; i++) {
            bits += std::memcmp(&there.value[i], &host.value[i], 4) != 0;
            values += !(std::fabs(there.value[i] - host.value[i]) <= 1e-5f * std::fabs(host.value[i]) + 1e-7f) &&
                      std::memcmp(&there.value[i], &host.value[i], 4) != 0;
            errors += there.error[i] != host.error[i];
        }
        CHECK_MESSAGE(errors == 0, device.name);
        CHECK_MESSAGE(values == 0, device.name, ": ", values, " of ", n);
        if (device.cpu) CHECK_MESSAGE(bits == 0, device.name, ": ", bits, " of ", n);
    }
}

}  // namespace

TEST_CASE("library functions have the host's values on every device") {
    cal::Library library({});
    Job job;
    for (const Row& r : golden_rows()) job.add(compile_one(library, r.text, job.code), golden_vars(r.p));
    compare(job);
}

TEST_CASE("elementary functions have the same bits on every device") {
    cal::Library library({});
    Job job;
    std::vector<uint32_t> entries;
    for (const char* text :
         {"exp(Px)",     "log(Px)",  "log10(Px)",    "sin(Px)",      "cos(Px)",  "tan(Px)", "asin(Px/40)",
          "acos(Px/40)", "atan(Px)", "atan2(Px,Py)", "Px^Py",        "sqrt(Px)", "erf(Px)", "erfc(Px)",
          "floor(Px)",   "Px/Py",    "sin(Px*1e6)",  "cos(1e15*Px)", "2^Px",     "rand(Px)"})
        entries.push_back(compile_one(library, text, job.code));
    uint32_t state = 1;
    auto uniform = [&] {
        state = state * 1664525u + 1013904223u;
        return float(state >> 8) / 16777216.0f;
    };
    for (int i = 0; i < 2000; i++) {
        const float p[3] = {80 * uniform() - 40, 6 * uniform() - 3, uniform()};
        for (uint32_t e : entries) job.add(e, golden_vars(p));
    }
    compare(job);
}

TEST_CASE("skies have the same bits on every device") {
    cal::Library library({});
    Job job;
    const uint32_t clear = compile_one(library, "skybr", job.code, "skybright.cal", {1, 100, 3, .9, .3, .4, .866});
    const uint32_t perez =
        compile_one(library, "skybright", job.code, "perezlum.cal", {1, 3, -1, -.5, 3, -4, .1, .3, .4, .866});
    uint32_t state = 9;
    auto uniform = [&] {
        state = state * 1664525u + 1013904223u;
        return 2 * float(state >> 8) / 16777216.0f - 1;
    };
    for (int i = 0; i < 20000; i++) {
        const float p[3] = {0, 0, 0};
        std::vector<float> vars = golden_vars(p);
        base::Vec3 d = base::unit({uniform(), uniform(), uniform()});
        vars[cal::device::CAL_DX] = float(d.x);
        vars[cal::device::CAL_DY] = float(d.y);
        vars[cal::device::CAL_DZ] = float(d.z);
        job.add(i & 1 ? clear : perez, vars);
    }
    compare(job);
}

TEST_CASE("data, pictures and text have the same bits on every device") {
    cal::Library library(golden_files());
    Job job;
    for (const PatternRow& r : pattern_rows("cal_patterns.tsv", false))
        job.add(cal::compile_pattern(library, r.spec, job.code).entry, r.vars);
    for (const PatternRow& r : pattern_rows("cal_skies.tsv", true))
        job.add(cal::compile_pattern(library, r.spec, job.code).entry, r.vars);
    compare(job);
}
