// SPDX-License-Identifier: BSD-3-Clause
// Search along RAYPATH.
#include "base/find_file.h"
#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
#include <cstdlib>
#include "base/error.h"
#include "base/files_read.h"
#include "base/open_file.h"
#include "base/printable.h"

namespace base {

std::vector<std::string> raypath_from_environment() {
    const char* value = std::getenv("RAYPATH");
    if (!value) return {"."};
    std::vector<std::string> directories(1);
    for (const char* c = value; *c; c++)
        if (*c == ':') directories.emplace_back();
        else directories.back() += *c;
    return directories;
}

void search_beside(const std::vector<std::string>& files, ReadOptions& options) {
    if (options.raypath.empty()) options.raypath = {"."};
    for (const std::string& file : files) {
        const size_t slash = file.rfind('/');
        if (file.empty() || slash == std::string::npos || file[0] == '!') continue;
        const std::string folder = slash == 0 ? "/" : file.substr(0, slash);
        if (std::find(options.raypath.begin(), options.raypath.end(), folder) == options.raypath.end())
            options.raypath.push_back(folder);
    }
}

static bool readable(const std::string& path) {
    struct stat s;
    const bool good = stat(path.c_str(), &s) == 0 && S_ISREG(s.st_mode) && access(path.c_str(), R_OK) == 0;
    if (!good) note_file_missed(path);
    return good;
}

std::string look_for_file(const std::string& name, const ReadOptions& options) {
    if (name.empty()) return "";
    if (name[0] == '~') {
        const size_t slash = name.find('/');
        const char* home = std::getenv("HOME");
        if (slash != 1 || !home) return "";
        const std::string path = home + name.substr(slash);
        return readable(path) ? path : "";
    }
    if (name[0] == '/' || name[0] == '.') return readable(name) ? name : "";
    if (options.raypath.empty()) return readable(name) ? name : "";
    for (const std::string& directory : options.raypath) {
        const bool here = directory.empty() || directory == ".";
        const std::string path = here ? name : directory + "/" + name;
        if (readable(path)) return path;
    }
    return "";
}

std::string find_file(const std::string& name, const ReadOptions& options, const std::string& who) {
    std::string path = look_for_file(name, options);
    if (path.empty()) require_ordinary_file(name, who);
    if (path.empty()) fail(who, "cannot find file \"" + excerpt(name) + "\"");
    return path;
}

std::string beside(const std::string& name, const std::string& asker) {
    const size_t slash = asker.rfind('/');
    if (name.empty() || name[0] == '/' || slash == std::string::npos || access(name.c_str(), F_OK) == 0) return name;
    const std::string path = asker.substr(0, slash + 1) + name;
    return access(path.c_str(), F_OK) == 0 ? path : name;
}

}  // namespace base
