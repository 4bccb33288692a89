// SPDX-License-Identifier: BSD-3-Clause
// See files_read.h.
#include "base/files_read.h"

#include <algorithm>
#include <mutex>

namespace base {
namespace {

struct Files {
    std::mutex lock;
    std::vector<std::string> paths;
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

}  // namespace

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
