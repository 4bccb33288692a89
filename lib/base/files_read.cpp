// SPDX-License-Identifier: BSD-3-Clause
// See files_read.h.
#include "base/files_read.h"

#include <algorithm>
#include <functional>

#include "base/error.h"

namespace base {
namespace {

FileNote* find(FilesRead& files, const std::string& path) {
    const auto known = std::find_if(files.begin(), files.end(), [&](const FileNote& x) { return x.path == path; });
    return known == files.end() ? nullptr : &*known;
}

void note(FilesRead& files, const std::string& path, bool read, const Overlays& overlays) {
    const std::string plain = path.compare(0, 2, "./") == 0 ? path.substr(2) : path;
    if (FileNote* known = find(files, plain)) {
        known->read = known->read || read;
    } else {
        const FileStamp stamp = stamp_of(plain);
        files.push_back({plain, stamp, overlay_of(overlays, stamp), read});
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

FileStatus status_of_input(const std::string& path) { return path == "-" ? status_of(0) : status_of(path); }

bool any_is(const std::vector<std::string>& paths, const FileStatus& file) {
    return std::any_of(paths.begin(), paths.end(), [&](const std::string& path) {
        const FileStatus status = status_of_input(path);
        return status.is_ordinary() && status.is_same_file(file);
    });
}

}  // namespace

void refuse_to_overwrite(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs) {
    for (const std::string& output : outputs) {
        const FileStatus there = status_of_input(output);
        if (there.is_ordinary() && any_is(inputs, there))
            fail(output, "is an input as well, which would be replaced: write to another file");
    }
}

void note_file_read(FilesRead& files, const std::string& path, const Overlays& overlays) {
    note(files, path, true, overlays);
}
void note_file_missed(FilesRead& files, const std::string& path) { note(files, path, false, {}); }

void note_files(FilesRead& files, const FilesRead& more) {
    for (const FileNote& x : more) {
        if (FileNote* known = find(files, x.path)) known->read = known->read || x.read;
        else files.push_back(x);
    }
}

FilesRead noted_now(const FilesRead& files) {
    FilesRead now;
    for (const FileNote& x : files) note(now, x.path, x.read, {});
    return now;
}

bool are_unchanged(const FilesRead& files, const Overlays& overlays) {
    return std::all_of(files.begin(), files.end(), [&](const FileNote& x) {
        const FileStamp now = stamp_of(x.path);
        const auto text = overlay_of(overlays, now);
        return now == x.stamp && (text == x.text || (text && x.text && *text == *x.text));
    });
}

std::vector<std::string> paths_of(const FilesRead& files) {
    std::vector<std::string> paths;
    for (const FileNote& x : files)
        if (x.read) paths.push_back(x.path);
    return paths;
}

FilesNow files_now(const FilesRead& files) {
    FilesNow now;
    std::string state;
    for (const FileNote& x : files) {
        const FileStamp stamp = stamp_of(x.path);
        now.changed = now.changed || !(stamp == x.stamp);
        now.gone = now.gone || (stamp.size == 0 && x.stamp.size != 0);
        state.append(reinterpret_cast<const char*>(&stamp), sizeof stamp);
    }
    now.state = std::hash<std::string>()(state);
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
