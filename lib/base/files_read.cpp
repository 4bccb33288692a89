// SPDX-License-Identifier: BSD-3-Clause
// See files_read.h.
#include "base/files_read.h"

#include <sys/stat.h>

#include <algorithm>
#include <mutex>

#include "base/error.h"

namespace base {
namespace {

struct Files {
    std::mutex lock;
    std::vector<std::string> paths, replaceable;
};

Files& files() {
    static Files f;
    return f;
}

// make's quoting: blanks and # by a backslash, $ by itself.
std::string quoted(const std::string& path) {
    std::string out;
    for (const char c : path) {
        if (c == ' ' || c == '\t' || c == '#' || c == ':') out += '\\';
        if (c == '$') out += '$';
        out += c;
    }
    return out;
}

// Of a regular file.
bool find(const std::string& path, struct stat& info) {
    return (path == "-" ? fstat(0, &info) : stat(path.c_str(), &info)) == 0 && S_ISREG(info.st_mode);
}

bool any_is(const std::vector<std::string>& paths, const struct stat& file) {
    return std::any_of(paths.begin(), paths.end(), [&](const std::string& path) {
        struct stat info;
        return find(path, info) && info.st_dev == file.st_dev && info.st_ino == file.st_ino;
    });
}

std::vector<std::string> replaceable_files() {
    Files& f = files();
    const std::lock_guard<std::mutex> hold(f.lock);
    return f.replaceable;
}

}  // namespace

void keep_inputs(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs) {
    for (const std::string& output : outputs) {
        struct stat there;
        if (!find(output, there) || !any_is(inputs, there) || any_is(replaceable_files(), there)) continue;
        fail(output, "is an input as well, which would be replaced: write to another file");
    }
}

void may_replace(const std::string& path) {
    Files& f = files();
    const std::lock_guard<std::mutex> hold(f.lock);
    f.replaceable.push_back(path);
}

void note_file_read(const std::string& path) {
    Files& f = files();
    const std::lock_guard<std::mutex> hold(f.lock);
    const std::string plain = path.compare(0, 2, "./") == 0 ? path.substr(2) : path;
    if (std::find(f.paths.begin(), f.paths.end(), plain) == f.paths.end()) f.paths.push_back(plain);
}

std::vector<std::string> files_read() {
    Files& f = files();
    const std::lock_guard<std::mutex> hold(f.lock);
    return f.paths;
}

std::string make_rule(const std::string& target, const std::vector<std::string>& paths) {
    std::string rule = quoted(target) + ":", empty;
    for (const std::string& path : paths) {
        rule += " \\\n  " + quoted(path);
        empty += quoted(path) + ":\n";
    }
    return rule + "\n\n" + empty;
}

}  // namespace base
