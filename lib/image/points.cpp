// SPDX-License-Identifier: BSD-3-Clause
// See points.h.
#include "image/points.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <set>

#include "base/error.h"
#include "base/files_read.h"
#include "base/hash.h"
#include "base/number.h"
#include "base/split.h"
#include "base/text_file.h"
#include "base/text_reader.h"
#include "image/header.h"

namespace image {
namespace {

constexpr size_t longest_point = 4096;  // characters

namespace fs = std::filesystem;

// path: from the folder of grids.
std::string name_of(const fs::path& path) {
    std::string name = path == "-" ? "points" : (path.parent_path() / path.stem()).generic_string();
    for (char& c : name)
        if (static_cast<unsigned char>(c) <= ' ' || c == 0x7f || c == '/') c = '_';
    return name;
}

bool is_point_file(const fs::path& path) {
    std::string ending = path.extension().string();
    for (char& c : ending) c = char(std::tolower(static_cast<unsigned char>(c)));
    return ending == ".pts";
}

// Hidden files and folders are left out.
std::vector<PointFile> files_in(const std::string& folder, base::FilesRead& looked_at) {
    std::set<std::string> inside;
    std::error_code unreadable;
    base::note_file_missed(looked_at, folder);  // as are the .pts files that may come to be in it
    for (auto at = fs::recursive_directory_iterator(folder, unreadable);
         !unreadable && at != fs::recursive_directory_iterator(); at.increment(unreadable)) {
        const bool hidden = at->path().filename().string()[0] == '.', deeper = at->is_directory(unreadable);
        if (hidden && deeper) at.disable_recursion_pending();
        else if (deeper) base::note_file_missed(looked_at, at->path().generic_string());
        else if (!hidden && is_point_file(at->path())) inside.insert(at->path().generic_string());
    }
    if (unreadable || inside.empty()) base::fail(folder, "is a folder without .pts files");
    std::vector<PointFile> files;
    for (const std::string& path : inside) files.push_back({path, name_of(fs::path(path).lexically_relative(folder))});
    return files;
}

Point point_of(const std::vector<std::string>& words, const std::string& place) {
    std::array<double, 6> v{};
    const auto has_comma = [](const std::string& word) { return word.find_first_of(",;") != std::string::npos; };
    if (std::any_of(words.begin(), words.end(), has_comma))
        base::fail(place, "a point is x y z dx dy dz with blanks between the six numbers, not commas");
    if (words.size() != v.size())
        base::fail(place, fmt::format("a point is x y z dx dy dz, six numbers, not {}", words.size()));
    for (size_t i = 0; i < v.size(); ++i)
        if (!base::parse_real(words[i], v[i]) || std::fabs(v[i]) > 1e30)
            base::fail(place, fmt::format("\"{}\" is not a number", words[i]));
    const base::Vec3 dir{v[3], v[4], v[5]};
    if (!(base::length(dir) > 0)) base::fail(place, "the direction has no length");
    return {{v[0], v[1], v[2]}, base::unit(dir)};
}

}  // namespace

bool operator==(const Grid& a, const Grid& b) {
    return a.name == b.name && a.first == b.first && a.count == b.count && a.sensors == b.sensors && a.hash == b.hash;
}

GridFile read_points(const PointFile& of, const base::Opener& by) {
    GridFile file{of.path == "-" ? "stdin" : of.path, plain_name(of.name, of.path), {}, {}};
    base::TextReader in = base::TextReader::from_file(of.path, by);
    base::Hash hash;
    uint32_t number = 0;
    for (std::string line; in.line(line, longest_point);) {
        if (++number == 1 && base::begins_with(line, base::byte_order_mark))
            line.erase(0, base::byte_order_mark.size());
        const std::vector<std::string> words = base::split_words(line.substr(0, line.find('#')));
        if (words.empty()) continue;
        Point point = point_of(words, fmt::format("{}:{}", file.path, number));
        point.line = number;
        if (file.points.size() == most_points)
            base::fail(file.path, fmt::format("holds more than {} points", most_points));
        const base::Vec3 &p = point.p, &d = point.dir;
        hash.add_all(std::array<double, 6>{p.x, p.y, p.z, d.x, d.y, d.z});
        file.points.push_back(point);
    }
    if (file.points.empty()) base::fail(file.path, "holds no point");
    file.hash = hash.text();
    return file;
}

std::vector<PointFile> point_files(const std::vector<std::string>& paths, base::FilesRead* looked_at) {
    base::FilesRead unasked;
    std::vector<PointFile> out;
    for (const std::string& path : paths) {
        std::error_code unreadable;
        if (!fs::is_directory(path, unreadable)) {
            out.push_back({path, name_of(fs::path(path).filename())});
            continue;
        }
        const std::vector<PointFile> inside = files_in(path, looked_at ? *looked_at : unasked);
        out.insert(out.end(), inside.begin(), inside.end());
    }
    return out;
}

std::vector<Grid> grids_of(const GridFiles& files, bool sensors) {
    std::vector<Grid> grids;
    std::set<std::string> names;
    for (const GridFile& file : files) {
        if (!names.insert(file.name).second) base::fail(file.path, "two grids are called \"" + file.name + "\"");
        grids.push_back({file.name, count_of(grids), file.points.size(), sensors, file.hash});
        if (count_of(grids) > most_points)
            base::fail(file.path, fmt::format("makes more than {} points in all", most_points));
    }
    return grids;
}

size_t count_of(const std::vector<Grid>& grids) { return grids.empty() ? 0 : grids.back().first + grids.back().count; }

void size_for(size_t points, int& width, int& height) {
    width = std::max(1, int(std::ceil(std::sqrt(double(points)))));
    height = std::max(1, int((points + size_t(width) - 1) / size_t(width)));
}

std::string to_text(const Grid& g) {
    return fmt::format("{} {} {} {} {}", g.name, g.first, g.count, g.sensors ? "irradiance" : "radiance", g.hash);
}

Grid parse_grid(const std::string& text, const std::string& where) {
    const std::vector<std::string> words = base::split_words(text);
    const bool good = words.size() == 5 && (words[3] == "irradiance" || words[3] == "radiance");
    long long first = 0, count = 0;
    if (!good || !base::parse_integer(words[1], first) || !base::parse_integer(words[2], count) || first < 0 ||
        count < 1 || size_t(first) + size_t(count) > most_points)
        base::fail(where, "header line \"GRID=" + text + "\" is not name, first, count, irradiance or radiance, hash");
    return {plain_name(words[0], where), size_t(first), size_t(count), words[3] == "irradiance", words[4]};
}

}  // namespace image
