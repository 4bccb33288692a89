// SPDX-License-Identifier: BSD-3-Clause
// See tempfile.h.  The names are kept in a fixed table, too, where a signal handler may read them.
#include "base/tempfile.h"

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "base/descriptor.h"
#include "base/error.h"
#include "base/file_status.h"
#include "base/new_file.h"

namespace base {
namespace {

constexpr int slots = 16, longest = 4096;
char temp_names[slots][longest];
std::atomic<int> temp_state[slots];  // 0 free, 1 being written, 2 in use

// Short, so that a target's name may be as long as the file system has it.
std::string random_name() {
    char text[64];
    std::snprintf(text, sizeof text, ".luxpipe-%016llx%08llx.tmp", (unsigned long long)random_bits(),
                  (unsigned long long)random_bits() & 0xffffffffu);
    return text;
}

}  // namespace

void remove_temp_files() {
    for (int i = 0; i < slots; ++i)
        if (temp_state[i] == 2) remove_file(temp_names[i]);
}

TempFile::TempFile(const std::string& target) : target_(target) {
    errno = 0;
    const FileKind old = status_of(target).kind;
    direct_ = old != FileKind::none && old != FileKind::ordinary;
    if (direct_) {
        path_ = target;
        fd_ = open_to_write(target);
        if (fd_ < 0) fail_system(target, "cannot be written");
        return;
    }
    target_ = end_of_links(target);  // keep a symbolic link, replace what it names
    create(old == FileKind::none ? 0666 : 0600);
    if (old == FileKind::ordinary) take_permissions(fd_, target_);
}

void TempFile::create(unsigned permissions) {
    const size_t slash = target_.rfind('/');
    const std::string folder = slash == std::string::npos ? "" : target_.substr(0, slash + 1);
    for (int attempt = 0; fd_ < 0; ++attempt) {
        path_ = folder + random_name();
        remember();
        fd_ = make_new(path_, permissions);
        if (fd_ >= 0 || (errno == EEXIST && attempt < 100)) continue;
        if (slot_ >= 0) temp_state[slot_] = 0;
        fail_system(target_, "cannot be written");
    }
}

void TempFile::remember() {
    if (slot_ >= 0) temp_state[slot_] = 0;
    slot_ = -1;
    for (int i = 0; i < slots && slot_ < 0 && path_.size() < longest; ++i) {
        int free = 0;
        if (!temp_state[i].compare_exchange_strong(free, 1)) continue;
        std::strcpy(temp_names[i], path_.c_str());
        temp_state[i] = 2;
        slot_ = i;
    }
}

TempFile::~TempFile() {
    if (fd_ >= 0) close_descriptor(fd_);
    if (!kept_ && !direct_) remove_file(path_.c_str());
    if (slot_ >= 0) temp_state[slot_] = 0;
}

void TempFile::write(const void* data, size_t bytes) {
    if (!write_all(fd_, data, bytes)) fail_system(target_, "cannot be written");
}

void TempFile::keep() {
    errno = 0;
    const int fd = fd_;
    fd_ = -1;
    if (!close_written(fd) || (!direct_ && !replace_file(path_, target_))) fail_system(target_, "cannot be written");
    kept_ = true;
}

}  // namespace base
