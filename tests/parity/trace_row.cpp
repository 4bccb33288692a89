// SPDX-License-Identifier: BSD-3-Clause
// See trace_row.h.
#include "parity/trace_row.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "options.h"
#include "base/tempfile.h"
#include "scene/object.h"
#include "flatten/flatten.h"
#include "unit/trace_ray.h"

namespace parity {
namespace {

// What rtrace takes when an option is not given.
const char* rtrace_defaults = "-ab 0 -dj 0 -ds .25 -dr 2 -ss 1 -st .15 -lr -10 -lw 1e-4 -w-";

Options read_arguments(const Row& row) {
    std::vector<std::string> words = {"ptrace"};
    std::istringstream in(rtrace_defaults + (" " + row.arguments));
    for (std::string word; in >> word;) {
        if (word == "-I+") word = "-i+";
        if (word.rfind("-o", 0) != 0) words.push_back(word);
    }
    for (const char* word : {"-frames", "1", "-o", "unused.hdr"}) words.push_back(word);
    words.push_back(row.file);
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    Options opt;
    parse_options(int(argv.size()), argv.data(), opt);
    opt.files.raypath = {"."};
    return opt;
}

bool asks(const Row& row, const char* option) { return row.arguments.find(option) != std::string::npos; }

// -I: a point and its normal instead of a ray.  A small white disc where rtrace would put its own surface, seen from
// just above it; -i+ then gives its irradiance.
constexpr double lift = 1.1e-4;

std::string disc_at(const std::vector<double>& point) {
    std::ostringstream text;
    text.precision(12);
    text << "void plastic patch 0 0 5 1 1 1 0 0\npatch ring patch_here 0 0 8";
    for (int i = 0; i < 3; ++i) text << ' ' << point[size_t(i)] + lift * point[size_t(i) + 3];
    for (int i = 3; i < 6; ++i) text << ' ' << point[size_t(i)];
    text << " 0 " << lift / 10 << "\n";
    return text.str();
}

}  // namespace

Value RowTracer::geometry(const Row& row) {
    const Options opt = read_arguments(row);
    flatten::Options geometry = opt.render;
    const flatten::FlatScene flat =
        flatten::flatten(scene::read_scene(opt.scene_files, opt.files), geometry, opt.files);
    const flatten::HostTracer tracer(flat);
    const base::Vec3 origin = {row.input[0], row.input[1], row.input[2]};
    const base::Vec3 dir = base::unit({row.input[3], row.input[4], row.input[5]});
    const auto found = tracer.closest(origin, dir, 0, 1e30, flatten::HostTracer::all);
    Value value;
    value.samples = 1;
    if (found.t < 0) value.mean = {0, 0, 0, 1e10};
    else value.mean = {found.normal.x, found.normal.y, found.normal.z, found.t};
    return value;
}

Value RowTracer::trace(const Row& row) {
    if (asks(row, "-oN")) return geometry(row);
    std::vector<double> ray = row.input;
    const bool at_point = asks(row, "-I+");
    const std::string key = row.file + '\n' + row.arguments + (at_point ? row.id : "");
    if (key != key_ || !renderer_) {
        renderer_.reset();
        Options opt = read_arguments(row);
        opt.render.least_lobe_prob = least_;
        base::TempFile patch((std::filesystem::temp_directory_path() / "vectors_test.rad").string());
        if (at_point) {
            std::ofstream(patch.path()) << disc_at(ray);
            opt.scene_files.push_back(patch.path());
        }
        const scene::Scene scene = scene::read_scene(opt.scene_files, opt.files);
        renderer_ = std::make_unique<render::Renderer>(scene, view::View(), 1, 1, opt.render, device_, opt.files);
        key_ = key;
    }
    if (at_point)
        for (size_t i = 0; i < 3; ++i) {
            ray[i] += 2 * lift * ray[i + 3];
            ray[i + 3] = -ray[i + 3];
        }
    Value value;
    for (long n = std::min(fewest_, most_);; n = std::min(4 * n, most_)) {
        const render::RayValue v = trace_ray(*renderer_, ray.data(), ray.data() + 3, n);
        value.mean.assign(v.mean, v.mean + 3);
        std::copy(v.error, v.error + 3, value.error);
        value.samples = n;
        const double worst = std::max({v.error[0], v.error[1], v.error[2]});
        if (worst <= 2e-4 * std::max({v.mean[0], v.mean[1], v.mean[2], 1e-9}) || n >= most_) return value;
    }
}

}  // namespace parity
