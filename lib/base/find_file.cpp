// SPDX-License-Identifier: BSD-3-Clause
// Search beside the file that names another one, and along RAYPATH.
#include "base/find_file.h"
#include <algorithm>
#include <cstdlib>
#include "base/error.h"
#include "base/file_status.h"
#include "base/same_content.h"
#include "base/printable.h"
#include "base/split.h"

namespace base {

static constexpr int most_above = 4;  // folders above a scene file's that are searched

std::vector<std::string> raypath_from_environment() {
    const char* value = std::getenv("RAYPATH");
    if (!value) return {"."};
    std::vector<std::string> directories(1);
    for (const char* c = value; *c; c++)
        if (*c == between_folders) directories.emplace_back();
        else directories.back() += *c;
    return directories;
}

void search_beside(const std::vector<std::string>& files, ReadOptions& options) {
    std::vector<std::string>& folders = options.scene_folders;
    for (const std::string& file : files) {
        const size_t slash = file.rfind('/');
        if (file.empty() || slash == std::string::npos || file[0] == '!') continue;
        const std::string folder = slash == 0 ? "/" : file.substr(0, slash);
        if (std::find(folders.begin(), folders.end(), folder) == folders.end()) folders.push_back(folder);
    }
}

static bool readable(const std::string& path, const ReadOptions& options) {
    const bool good = status_of(path).is_ordinary() && may_read(path);
    if (!good) note_file_missed(*options.read, path);
    return good;
}

static std::string beside_scene(const std::string& name, const ReadOptions& options) {
    for (const std::string& start : options.scene_folders) {
        std::string folder = start;
        for (int above = 0; above <= most_above; above++) {
            const std::string path = folder + "/" + name;
            if (readable(path, options)) return path;
            const size_t slash = folder.rfind('/');
            if (name.find('/') == std::string::npos || slash == std::string::npos || ends_with(folder, "..")) break;
            folder.resize(slash);
        }
    }
    return "";
}

// Where RADIANCE's programs look.
static std::string along_raypath(const std::string& name, const ReadOptions& options) {
    if (name[0] == '~') {
        const size_t slash = name.find('/');
        const char* home = std::getenv("HOME");
        if (slash != 1 || !home) return "";
        const std::string path = home + name.substr(slash);
        return readable(path, options) ? path : "";
    }
    if (is_absolute(name) || name[0] == '.' || options.raypath.empty()) return readable(name, options) ? name : "";
    for (const std::string& directory : options.raypath) {
        const bool here = directory.empty() || directory == ".";
        const std::string path = here ? name : directory + "/" + name;
        if (readable(path, options)) return path;
    }
    return "";
}

// A place without a line is no file's.
static std::string in_folder_of(const std::string& place, const std::string& name) {
    const size_t line = place.rfind(':');
    if (line == std::string::npos || name.empty() || is_absolute(name) || name[0] == '~') return "";
    const size_t slash = place.rfind('/', line);
    return slash == std::string::npos ? name : place.substr(0, slash + 1) + name;
}

// The file beside the one that names it, if there is one, else the one that RADIANCE finds.
static const std::string& first_of(const std::string& beside, const std::string& other, const std::string& name,
                                   const std::string& place) {
    if (beside.empty() || other.empty()) return beside.empty() ? other : beside;
    if (beside != other && !same_content(beside, other))
        warn(place, "\"" + excerpt(name) + "\" is " + excerpt(beside) +
                        " beside the file that names it, which is read, and " + excerpt(other) +
                        " by RADIANCE's rules, which differs");
    return beside;
}

static std::string look_as_written(const std::string& name, const ReadOptions& options, const std::string& place) {
    if (name.empty()) return "";
    std::string near = in_folder_of(place, name);
    if (!near.empty() && !readable(near, options)) near.clear();
    const std::string path = first_of(near, along_raypath(name, options), name, place);
    return path.empty() && !is_absolute(name) && name[0] != '~' ? beside_scene(name, options) : path;
}

static std::string with_slashes(std::string name) {
    std::replace(name.begin(), name.end(), '\\', '/');
    return name;
}

std::string look_for_file(const std::string& name, const ReadOptions& options, const std::string& place) {
    const std::string path = look_as_written(name, options, place), other = with_slashes(name);
    return path.empty() && other != name ? look_as_written(other, options, place) : path;
}

std::string find_file(const std::string& name, const ReadOptions& options, const std::string& place) {
    std::string path = look_for_file(name, options, place);
    if (path.empty()) require_ordinary_file(name, place);
    if (path.empty()) fail(place, "cannot find file \"" + excerpt(name) + "\"");
    return path;
}

std::string beside(const std::string& name, const std::string& place) {
    const auto there = [](const std::string& path) { return status_of(path).kind != FileKind::none ? path : ""; };
    for (const std::string& spelt : {name, with_slashes(name)}) {
        const std::string path = first_of(there(in_folder_of(place, spelt)), there(spelt), name, place);
        if (!path.empty()) return path;
    }
    return name;
}

}  // namespace base
