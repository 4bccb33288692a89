// SPDX-License-Identifier: BSD-3-Clause
// The faults: see fault_list.h.
#include "fault_list.h"

#include <fcntl.h>
#include <grp.h>
#include <sched.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdlib>
#include <vector>

#include "child.h"

namespace breaking {
namespace {

constexpr unsigned nobody = 65534;

bool limit(int what, size_t value) {
    const struct rlimit r = {value, value};
    return setrlimit(__rlimit_resource(what), &r) == 0;
}

// Root is above most limits and all permissions; where we are nobody special already, nothing is to be done.
bool become_nobody() {
    if (geteuid() != 0) return true;
    return setgroups(0, nullptr) == 0 && setgid(nobody) == 0 && setuid(nobody) == 0;
}

bool replace_descriptor(int which, const char* path, int how) {
    const int fd = open(path, how);
    return fd >= 0 && dup2(fd, which) == which && (fd == which || close(fd) == 0);
}

// An empty file system over a folder that programs rely on, in the child's own namespace.
bool hide(const char* folder) { return unshare(CLONE_NEWNS) == 0 && mount("none", folder, "tmpfs", 0, "size=4k") == 0; }

}  // namespace

Fault some_fault(Dice& dice) {
    const auto sized = [](const char* name, size_t size, const char* unit, std::function<bool()> before) {
        return Fault{std::string(name) + " " + std::to_string(size) + unit, std::move(before)};
    };
    switch (dice.below(15)) {
    case 0:
    case 1: {
        const size_t mb = size_t(dice.within(20, dice.chance(.5) ? 200 : 2000));
        return sized("memory", mb, " MB", [=] { return bears_little_memory && limit(RLIMIT_AS, mb << 20); });
    }
    case 2:
    case 3: {
        const size_t bytes = dice.chance(.3) ? dice.below(200) : dice.below(60000);
        return sized("files of at most", bytes, " bytes", [=] { return limit(RLIMIT_FSIZE, bytes); });
    }
    case 4: {
        const size_t n = size_t(dice.within(3, 24));
        return sized("descriptors below", n, "", [=] { return limit(RLIMIT_NOFILE, n); });
    }
    case 5: {
        const size_t n = size_t(dice.within(1, 6));
        return sized("processes and threads at most", n, "", [=] { return limit(RLIMIT_NPROC, n) && become_nobody(); });
    }
    case 6: {
        const size_t kb = size_t(dice.within(160, 1000));
        return sized("stack", kb, " KB", [=] { return limit(RLIMIT_STACK, kb << 10); });
    }
    case 7: return {"a folder that is not ours", become_nobody, false, true};
    case 8:
        return {"stdout on a full disk", [] { return replace_descriptor(1, "/dev/full", O_WRONLY); }, false, false,
                true};
    case 9: return {"stdout closed", [] { return close(1) == 0; }, false, false, true};
    case 10: return {"stdin closed", [] { return close(0) == 0; }};
    case 11: return {"stderr closed", [] { return close(2) == 0; }};
    case 12:
        return {"all three closed", [] { return close(0) == 0 && close(1) == 0 && close(2) == 0; }, false, false, true};
    case 13: return {"no /sys", [] { return hide("/sys"); }};
    default: return {"a small disk", {}, true};
    }
}

bool enter_namespace() {
    if (unshare(CLONE_NEWNS) != 0 && unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) return false;
    return mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0;
}

bool mount_small_disk(const std::string& folder, size_t kilobytes) {
    const std::string size = "size=" + std::to_string(kilobytes) + "k,mode=0777";
    return mount("none", folder.c_str(), "tmpfs", 0, size.c_str()) == 0;
}

void unmount_disk(const std::string& folder) { umount2(folder.c_str(), MNT_DETACH); }

}  // namespace breaking
