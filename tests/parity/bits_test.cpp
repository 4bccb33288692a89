// SPDX-License-Identifier: BSD-3-Clause
// bits_test DEVICE [-record] [ID ...] - do frames keep their bits?  tests/golden/bits.tsv holds frames 0 to 6 and
// 32 to 34 (m is 32), or the means of single rays, as hashes: one row a scene, tab separated: id, folder below the
// source tree, ptrace's arguments (empty: the rays of golden/vectors that name this scene), hash.  A change that only
// moves code moves no bit, on no device; one that moves numbers on purpose writes the rows anew (-record, on the CPU),
// raises render::estimator (lib/render/fingerprint.h) and says so in CHANGELOG.
#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>

#include "base/error.h"
#include "base/run.h"
#include "parity/options_of.h"
#include "parity/trace_row.h"
#include "parity/vectors.h"
#include "device/device.h"

namespace {

constexpr int size = 40;
constexpr long samples = 64;  // of each single ray
const std::string vectors = LUXPIPE_TESTS "/golden/vectors";

// Fowler, Noll and Vo's hash, 64 bits, over the bytes of values.
class Hash {
public:
    template <class T>
    void add(const std::vector<T>& values) {
        const auto* bytes = reinterpret_cast<const unsigned char*>(values.data());
        for (size_t i = 0; i < values.size() * sizeof(T); ++i) hash_ = (hash_ ^ bytes[i]) * 0x100000001b3u;
    }
    std::string text() const { return fmt::format("{:016x}", hash_); }

private:
    uint64_t hash_ = 0xcbf29ce484222325u;
};

std::string hash_of_frames(const std::string& arguments, const std::string& device) {
    Options opt = parity::options_of(arguments, size);
    const scene::Scene scene = scene::read_scene(opt.scene_files, opt.files);
    const render::RenderView& v = opt.views.at(0).render_view;
    render::Renderer renderer(scene, v, opt.render, device, opt.files);
    Hash hash;
    const auto add = [&](int64_t, const std::vector<float>& rgb, const image::Moments&) {
        hash.add(rgb);
        return true;
    };
    renderer.frames(0, 7, add);
    renderer.frames(32, 3, add);
    return hash.text();
}

std::string hash_of_rays(const std::vector<parity::Row>& rows, const std::string& file, const std::string& device) {
    parity::RowTracer tracer(device, samples);
    Hash hash;
    for (const parity::Row& row : rows) {
        if (row.file != file) continue;
        try {
            hash.add(tracer.trace(row).mean);
        } catch (const base::Error& e) {
            hash.add(std::vector<char>{'e'});
        }
    }
    return hash.text();
}

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, '\t');) cells.push_back(cell);
    cells.resize(4);
    return cells;
}

}  // namespace

int main(int argc, char** argv) {
    return base::run("bits_test", [&] {
        if (argc < 2) base::fail("", "usage: bits_test device [-record] [id ...]");
        const std::string device = argv[1], table = LUXPIPE_TESTS "/golden/bits.tsv", top = LUXPIPE_TESTS "/..";
        std::vector<std::string> ids(argv + 2, argv + argc);
        const bool record = !ids.empty() && ids[0] == "-record";
        if (record) ids.erase(ids.begin());
        const bool opencl = device.rfind("opencl", 0) == 0, variant = device.rfind("cpu:", 0) == 0;
        if ((opencl && device::opencl_devices().empty()) || (variant && !device::has_cpu_variant(device.substr(4)))) {
            fmt::print("skipped: no {} here\n", device);
            return 77;
        }
        auto rays = parity::read_rays(vectors + "/vectors.tsv");
        for (const auto& row : parity::read_rays(vectors + "/found.tsv")) rays.push_back(row);
        std::ifstream in(table);
        std::string out;
        int rows = 0, moved = 0;
        for (std::string line; std::getline(in, line);) {
            std::vector<std::string> cells = cells_of(line);
            const bool asked = ids.empty() || std::find(ids.begin(), ids.end(), cells[0]) != ids.end();
            if (line.empty() || line[0] == '#' || !asked) {
                out += line + "\n";
                continue;
            }
            if (chdir((top + "/" + cells[1]).c_str()) != 0) base::fail_system(cells[1], "no such folder");
            const std::string now =
                cells[2].empty() ? hash_of_rays(rays, cells[0], device) : hash_of_frames(cells[2], device);
            rows++;
            if (now != cells[3]) {
                moved++;
                fmt::print("{}\tmoved: {}, was {}\n", cells[0], now, cells[3]);
            }
            out += fmt::format("{}\t{}\t{}\t{}\n", cells[0], cells[1], cells[2], now);
        }
        in.close();
        if (record) std::ofstream(table) << out;
        fmt::print("{} rows on {}, {} moved\n", rows, device, moved);
        return moved && !record ? 1 : 0;
    });
}
