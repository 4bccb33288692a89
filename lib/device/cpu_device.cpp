// SPDX-License-Identifier: BSD-3-Clause
// The native device: tiles of paths over all cores, with the widest instruction set of the machine.
#include <algorithm>
#include <atomic>
#include <iterator>

#include <fmt/core.h>

#include "base/error.h"
#include "base/processors.h"
#include "base/shutdown.h"
#include "base/threads.h"
#include "device/cpu_kernels.h"
#include "device/layout.h"
#include "device/scene_tables.h"

namespace device {
namespace {

// Paths of one tile: their state (kernels/integrator/state.h, 220 bytes each) stays in the second-level cache; that of
// path reuse, 384 bytes more, is touched only after their ends.
constexpr uint32_t TILE = 4096;
constexpr uint32_t HOURS_TILE = 1024;  // of many hours, whose paths take long: it ends soon after a signal
static_assert(TILE % REUSE_SQUARE == 0 && HOURS_TILE % REUSE_SQUARE == 0, "groups lie in one tile");

// A build of the kernels by its name in -device cpu:NAME.
struct Variant {
    const char* name;
    const CpuKernels* kernels;
    bool (*runs)();     // does this machine have the instructions?
    const char* needs;  // their name
};

bool always() { return true; }

// The fastest first (docs/decisions/0026-lanes.md).
const Variant variants[] = {
#ifdef LUXPIPE_LANES16
    {"lanes16", &cpu_lanes16, base::has_avx512, "AVX-512"},  // paths side by side
#endif
#ifdef LUXPIPE_LANES8
    {"lanes8", &cpu_lanes8, base::has_avx2, "AVX2"},
#endif
    {"avx2", &cpu_avx2, base::has_avx2, "AVX2"},  // one path at a time
    {"baseline", &cpu_baseline, always, ""},
};

// name: "" for the best.
const CpuKernels& choose_kernels(const std::string& name) {
    std::string names;
    for (const Variant& v : variants) {
        if (name == v.name && !v.runs()) base::fail("-device", fmt::format("this machine has no {}", v.needs));
        if (name.empty() ? v.runs() : name == v.name) return *v.kernels;
        names += (names.empty() ? "" : ", ") + std::string(v.name);
    }
    base::fail("-device", fmt::format("\"{}\" is not a CPU variant ({})", name, names));
}

class CpuDevice : public Device {
public:
    explicit CpuDevice(const std::string& variant) : kernels_(choose_kernels(variant)), threads_(base::processors()) {
        require_same_layout("-device", [&](RecordSizes& sizes) { kernels_.layout(sizes.data()); });
    }

    std::string name() const override { return fmt::format("cpu ({}, {} threads)", kernels_.name, threads_); }

    void upload(std::shared_ptr<const flatten::FlatScene> scene) override { scene_ = std::move(scene); }

    void run(const Params& par, std::vector<float>& rgb) override {
        rgb.resize(size_t(kernels::film_places(&par)) * 3);
        const kernels::SceneTables tables = tables_of(*scene_, par);
        tiles(par.path_count, TILE, [&](uint32_t first, uint32_t count, char* scratch) {
            float* film = par.reuse_path_count != 0 ? rgb.data() : &rgb[size_t(first) * 3];
            kernels_.run(tables, par, par.first + first, count, scratch, film);
        });
    }
    void run_hours(const Params& par, HourPaths& out) override {
        out = {};
        out.rest.resize(size_t(kernels::film_places(&par)) * 3);
        const kernels::SceneTables tables = tables_of(*scene_, par);
        std::vector<HourPaths> parts((par.path_count + REUSE_SQUARE - 1) / REUSE_SQUARE);
        tiles(par.path_count, HOURS_TILE, [&](uint32_t first, uint32_t count, char* scratch) {
            if (base::shutdown_requested()) throw Cancelled{};
            float* film = par.reuse_path_count != 0 ? out.rest.data() : &out.rest[size_t(first) * 3];
            kernels_.run_hours(tables, par, par.first + first, count, scratch, film, parts[first / REUSE_SQUARE]);
        });
        for (HourPaths& part : parts) out.append(std::move(part));
    }
    void splat(const Params& par, const std::vector<SplatRay>& rays, std::vector<float>& rgb) override {
        rgb.resize(rays.size() * 3);
        const kernels::SceneTables tables = tables_of(*scene_, par);
        tiles(uint32_t(rays.size()), TILE, [&](uint32_t first, uint32_t count, char* scratch) {
            kernels_.splat(tables, par, rays.data(), first, count, scratch, rgb.data());
        });
    }
    void pilot(const Params& par, const std::vector<PilotRay>& rays, std::vector<PilotEnd>& ends) override {
        ends.resize(rays.size());
        const kernels::SceneTables tables = tables_of(*scene_, par);
        tiles(uint32_t(rays.size()), TILE, [&](uint32_t first, uint32_t count, char* scratch) {
            kernels_.pilot(tables, par, rays.data(), first, count, scratch, ends.data());
        });
    }
    uint32_t preferred_batch_size() const override { return 64 * TILE; }

private:
    // Smaller tiles for few paths, so that no thread idles.
    uint32_t tile_of(uint32_t count, uint32_t most) const {
        const uint32_t each = count / (2 * threads_) / REUSE_SQUARE * REUSE_SQUARE;
        return std::clamp(each, REUSE_SQUARE, most);
    }
    template <class F>
    void tiles(uint32_t count, uint32_t most, F&& work) {
        const uint32_t tile = tile_of(count, most);
        std::atomic<uint32_t> next{0};
        base::on_threads(std::min(threads_, (count + tile - 1) / tile), [&] {
            const std::unique_ptr<char[]> scratch(new char[kernels_.scratch_bytes(tile)]);
            for (uint32_t first; (first = next.fetch_add(tile)) < count;) {
                heed_wish();
                work(first, std::min(tile, count - first), scratch.get());
            }
        });
    }

    const CpuKernels& kernels_;
    unsigned threads_;
    std::shared_ptr<const flatten::FlatScene> scene_;
};

}  // namespace

bool has_cpu_variant(const std::string& name) {
    return std::any_of(std::begin(variants), std::end(variants),
                       [&](const Variant& v) { return name == v.name && v.runs(); });
}

std::unique_ptr<Device> make_cpu_device(const std::string& name) {
    const size_t colon = name.find(':');
    const std::string variant = colon == std::string::npos ? "" : name.substr(colon + 1);
    return std::make_unique<CpuDevice>(variant);
}

}  // namespace device
