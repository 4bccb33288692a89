// SPDX-License-Identifier: BSD-3-Clause
// See tempfile.h.  The names are kept in a fixed table, too, where a signal handler may read them.
#include "base/tempfile.h"

#include <fcntl.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "base/descriptor.h"
#include "base/error.h"

namespace base {
namespace {

constexpr int slots = 16, longest = 4096;
char temp_names[slots][longest];
std::atomic<int> temp_state[slots];  // 0 free, 1 being written, 2 in use

// Short, so that a target's name may be as long as the file system has it.
std::string random_name() {
    uint64_t bits[2];
    if (getentropy(bits, sizeof bits) != 0) fail_system("", "no random numbers from the system");
    char text[64];
    std::snprintf(text, sizeof text, ".luxpipe-%016llx%08llx.tmp", (unsigned long long)bits[0],
                  (unsigned long long)bits[1] & 0xffffffffu);
    return text;
}

// Where a symbolic link leads, also if nothing is there yet.
std::string end_of_links(std::string path) {
    char to[longest];
    for (int links = 0;; ++links) {
        const ssize_t n = readlink(path.c_str(), to, sizeof to);
        if (n <= 0 || n == ssize_t(sizeof to)) return path;
        errno = ELOOP;
        if (links == 40) fail_system(path, "cannot be written");
        const size_t folder = to[0] == '/' ? 0 : path.rfind('/') + 1;  // 0 where there is no slash
        path = path.substr(0, folder) + std::string(to, size_t(n));
    }
}

}  // namespace

void remove_temp_files() {
    for (int i = 0; i < slots; ++i)
        if (temp_state[i] == 2) unlink(temp_names[i]);
}

TempFile::TempFile(const std::string& target) : target_(target) {
    struct stat old = {};
    errno = 0;
    if (stat(target.c_str(), &old) != 0) {
        target_ = end_of_links(target);
        create(0666);
        return;
    }
    if (!S_ISREG(old.st_mode)) {
        path_ = target;
        direct_ = true;
        fd_ = open(target.c_str(), O_WRONLY | O_CLOEXEC);
        if (fd_ < 0) fail_system(target, "cannot be written");
        return;
    }
    if (char* real = realpath(target.c_str(), nullptr)) {  // keep a symbolic link, replace what it names
        target_ = real;
        free(real);
    }
    create(0600);
    // Owner first, where we may give files away (root): the permissions are meant for the old owner.
    if (fchown(fd_, old.st_uid, old.st_gid) != 0) errno = 0;
    fchmod(fd_, old.st_mode & 0777);
}

void TempFile::create(unsigned permissions) {
    const size_t slash = target_.rfind('/');
    const std::string folder = slash == std::string::npos ? "" : target_.substr(0, slash + 1);
    for (int attempt = 0; fd_ < 0; ++attempt) {
        path_ = folder + random_name();
        remember();
        fd_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, permissions);
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
    if (fd_ >= 0) close(fd_);
    if (!kept_ && !direct_) unlink(path_.c_str());
    if (slot_ >= 0) temp_state[slot_] = 0;
}

void TempFile::write(const void* data, size_t bytes) {
    if (!write_all(fd_, data, bytes)) fail_system(target_, "cannot be written");
}

void TempFile::keep() {
    errno = 0;
    const int fd = fd_;
    fd_ = -1;
    if (close(fd) != 0 || (!direct_ && std::rename(path_.c_str(), target_.c_str()) != 0))
        fail_system(target_, "cannot be written");
    kept_ = true;
}

}  // namespace base
