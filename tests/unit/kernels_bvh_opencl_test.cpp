// SPDX-License-Identifier: BSD-3-Clause
// The same traversal compiled as OpenCL C, on every OpenCL device: each hit must have the bits of the host's, for both
// trees. Needs a device with correctly rounded division (PoCL, NVIDIA); skips (77) without one.
#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#define CL_TARGET_OPENCL_VERSION 120
#define CL_HPP_TARGET_OPENCL_VERSION 120
#define CL_HPP_MINIMUM_OPENCL_VERSION 120
#define CL_HPP_ENABLE_EXCEPTIONS
#include <CL/opencl.hpp>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include "unit/bvh_host.h"

using kernels::as_uint_;

static std::vector<cl::Device> devices;

static std::string program_text() {
    std::string text;
    const auto add = [&](const char* file) {
        std::ifstream in(std::string(LUXPIPE_TESTS) + "/../lib/kernels/" + file);
        REQUIRE(in.good());
        for (std::string line; std::getline(in, line);)  // included files are there: no path, which may have blanks
            if (line.rfind("#include", 0) != 0) text += line + "\n";
    };
    for (const char* file : {"dialect/compat_opencl.h", "math/vec.h", "features.h", "records.h", "bvh/intersect.h",
                             "geom/shapes.h", "bvh/woop.h", "bvh/offset_ray.h"})
        add(file);
    text += "#ifdef LUX_COMPACT\n";
    add("bvh/bvh_compact.h");
    text += "#else\n";
    add("bvh/bvh8.h");
    text += R"(
#endif
// Ray: 8 floats; result: t, prim, u, v, inst, any, and a shifted origin's x.
__kernel void trace_rays(__global const float* nodes, __global const float* leaves, __global const Shape* shapes,
                         __global const float* uv, __global const Instance* instances, __global const float* rays,
                         __global uint* out, uint mask) {
    size_t i = get_global_id(0);
    SceneTables s;
    Ray ray;
    Look look;
    Hit hit;
    float3 p;
    s.nodes = nodes; s.leaves = leaves; s.shapes = shapes; s.polygon_uv = uv;
    s.instances = instances;
    ray.org = F3(rays[8 * i], rays[8 * i + 1], rays[8 * i + 2]);
    ray.tmin = rays[8 * i + 3];
    ray.dir = F3(rays[8 * i + 4], rays[8 * i + 5], rays[8 * i + 6]);
    ray.tmax = rays[8 * i + 7];
    look_along(&ray, &look);
    trace_next(&s, &ray, mask, &look);
    hit = look.hit;
    p = offset_ray(ray.org, ray.dir, ray.tmin);
    out[8 * i] = as_uint(hit.t);
    out[8 * i + 1] = hit.prim;
    out[8 * i + 2] = as_uint(hit.u);
    out[8 * i + 3] = as_uint(hit.v);
    out[8 * i + 4] = hit.inst;
    out[8 * i + 5] = (uint)trace_any(&s, &ray, mask);
    out[8 * i + 6] = as_uint(p.x);
    out[8 * i + 7] = 0u;
}
)";
    return text;
}

static cl::Buffer send(const cl::Context& context, const void* data, size_t bytes) {
    static const char nothing[64] = {};
    if (bytes == 0)
        return cl::Buffer(context, CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR, size_t(64), const_cast<char*>(nothing));
    return cl::Buffer(context, CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR, bytes, const_cast<void*>(data));
}

TEST_CASE("OpenCL devices find the host's hits, bit for bit") {
    const auto scene = bvh_scenes::random_scene(29, 300, true);
    const auto in = scene.input();
    const auto rays = bvh_scenes::random_rays(31, 8192);
    static_assert(sizeof rays[0] == 32, "as the kernel reads it");
    for (const auto& device : devices) {
        CAPTURE(device.getInfo<CL_DEVICE_NAME>());
        cl::Context context(device);
        cl::CommandQueue queue(context, device);
        const bool gpu = device.getInfo<CL_DEVICE_TYPE>() & CL_DEVICE_TYPE_GPU;
        for (bool compact : {true, false}) {
            if (gpu && !compact) continue;  // bvh8.h is not meant for GPUs
            CAPTURE(compact);
            const auto bvh = compact ? bvh::build_compact(in.data(), in.size()) : bvh::build8(in.data(), in.size());
            cl::Program program(context, program_text());
            try {
                const std::string options = "-cl-std=CL1.2";
                program.build(
                    (options + (compact ? " -DLUX_COMPACT" : "") + " -cl-fp32-correctly-rounded-divide-sqrt").c_str());
            } catch (const cl::Error&) {
                FAIL(program.getBuildInfo<CL_PROGRAM_BUILD_LOG>(device));
            }
            cl::Kernel kernel(program, "trace_rays");
            const auto nodes = send(context, bvh.nodes.data(), 4 * bvh.nodes.size());
            const auto leaves = send(context, bvh.leaves.data(), 4 * bvh.leaves.size());
            const auto shapes = send(context, scene.shapes.data(), sizeof scene.shapes[0] * scene.shapes.size());
            const auto uv = send(context, scene.polygon_uv.data(), 4 * scene.polygon_uv.size());
            const auto instances =
                send(context, scene.instances.data(), sizeof scene.instances[0] * scene.instances.size());
            const auto ray_buffer = send(context, rays.data(), 32 * rays.size());
            cl::Buffer out(context, CL_MEM_WRITE_ONLY, 32 * rays.size());
            const auto tables = kernels::tables(scene, bvh);
            for (cl_uint mask : {RAY_OPAQUE, RAY_TRANSPARENT, RAY_ALL}) {
                unsigned a = 0;
                for (const auto& b : {nodes, leaves, shapes, uv, instances, ray_buffer, out}) kernel.setArg(a++, b);
                kernel.setArg(a, mask);
                queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(rays.size()), cl::NDRange(64));
                std::vector<uint> got(8 * rays.size());
                queue.enqueueReadBuffer(out, CL_TRUE, 0, 4 * got.size(), got.data());
                int wrong = 0, any = 0, offset = 0, hits = 0;
                for (size_t i = 0; i < rays.size(); i++) {
                    const kernels::Ray ray = kernels::ray_of(rays[i]);
                    kernels::Hit h;
                    if (compact) kernels::compact::trace_first(&tables, &ray, mask, &h);
                    else kernels::wide::trace_first(&tables, &ray, mask, &h);
                    const uint* g = &got[8 * i];
                    hits += h.prim != NO_HIT;
                    wrong += g[0] != as_uint_(h.t) || g[1] != h.prim || g[2] != as_uint_(h.u) ||
                             g[3] != as_uint_(h.v) || g[4] != h.inst;
                    any += (g[5] != 0) != (h.prim != NO_HIT);
                    offset += g[6] != as_uint_(kernels::offset_ray(ray.org, ray.dir, ray.tmin).x);
                }
                CAPTURE(mask);
                CHECK(hits > 500);
                CHECK(wrong == 0);
                CHECK(any == 0);
                CHECK(offset == 0);
            }
        }
    }
}

int main(int argc, char** argv) {
    std::string cache = (std::filesystem::temp_directory_path() / "luxpipe_bvh_XXXXXX").string();
    if (!mkdtemp(cache.data())) return 2;
    setenv("POCL_CACHE_DIR", cache.c_str(), 1);
    std::vector<cl::Platform> platforms;
    try {
        cl::Platform::get(&platforms);
    } catch (const cl::Error&) {}
    for (const auto& p : platforms) {
        std::vector<cl::Device> found;
        try {
            p.getDevices(CL_DEVICE_TYPE_ALL, &found);
        } catch (const cl::Error&) {}
        for (const auto& d : found)
            if (d.getInfo<CL_DEVICE_SINGLE_FP_CONFIG>() & CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT) devices.push_back(d);
    }
    int status = 77;
    if (devices.empty()) {
        std::puts("skipped: no OpenCL device with correctly rounded division");
    } else {
        doctest::Context context(argc, argv);
        status = context.run();
    }
    devices.clear();
    std::error_code ignored;
    std::filesystem::remove_all(cache, ignored);
    return status;
}
