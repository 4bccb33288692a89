// SPDX-License-Identifier: BSD-3-Clause
// See files_read.h.
#include "base/files_read.h"

#include <sys/stat.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <mutex>

#include "base/error.h"
#include "base/overlay.h"

namespace base {
namespace {

struct Files {
    std::mutex lock;
    std::vector<FileNote> all;
    uint64_t count = 0;
    std::vector<std::string> replaceable;
};

Files& files() {
    static Files f;
    return f;
}

void note(const std::string& path, bool read) {
    Files& f = files();
    const std::string plain = path.compare(0, 2, "./") == 0 ? path.substr(2) : path;
    const std::lock_guard<std::mutex> hold(f.lock);
    const auto known = std::find_if(f.all.begin(), f.all.end(), [&](const FileNote& x) { return x.path == plain; });
    if (known == f.all.end()) {
        const FileStamp stamp = stamp_of(plain);
        f.all.push_back({plain, stamp, overlay_number(stamp), read, ++f.count});
    } else {
        known->read = known->read || read;
        known->noted = ++f.count;
    }
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

// Gets the status of a regular file; false: there is none.
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

void refuse_to_overwrite(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs) {
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

void note_file_read(const std::string& path) { note(path, true); }
void note_file_missed(const std::string& path) { note(path, false); }

uint64_t files_noted_count() {
    Files& f = files();
    const std::lock_guard<std::mutex> hold(f.lock);
    return f.count;
}

std::vector<FileNote> files_noted_since(uint64_t count) {
    Files& f = files();
    const std::lock_guard<std::mutex> hold(f.lock);
    std::vector<FileNote> since;
    std::copy_if(f.all.begin(), f.all.end(), std::back_inserter(since),
                 [&](const FileNote& x) { return x.noted > count; });
    return since;
}

bool note_unchanged_files(const std::vector<FileNote>& notes) {
    const auto unchanged = [](const FileNote& x) {
        const FileStamp now = stamp_of(x.path);
        return now == x.stamp && overlay_number(now) == x.overlay;
    };
    if (!std::all_of(notes.begin(), notes.end(), unchanged)) return false;
    for (const FileNote& x : notes) note(x.path, x.read);
    return true;
}

std::vector<std::string> files_read() {
    Files& f = files();
    const std::lock_guard<std::mutex> hold(f.lock);
    std::vector<std::string> paths;
    for (const FileNote& x : f.all)
        if (x.read) paths.push_back(x.path);
    return paths;
}

std::vector<std::string> forget_files_read() {
    std::vector<std::string> paths = files_read();
    Files& f = files();
    const std::lock_guard<std::mutex> hold(f.lock);
    f.all.clear();
    return paths;
}

FilesNow files_now() {
    Files& f = files();
    std::vector<FileNote> all;
    {
        const std::lock_guard<std::mutex> hold(f.lock);
        all = f.all;
    }
    FilesNow now;
    std::string state;
    for (const FileNote& x : all) {
        const FileStamp stamp = stamp_of(x.path);
        now.changed = now.changed || !(stamp == x.stamp);
        now.gone = now.gone || (stamp.size == 0 && x.stamp.size != 0);
        state.append(reinterpret_cast<const char*>(&stamp), sizeof stamp);
    }
    now.state = std::hash<std::string>()(state);
    now.count = all.size();
    return now;
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
