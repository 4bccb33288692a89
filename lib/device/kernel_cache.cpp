// SPDX-License-Identifier: BSD-3-Clause
// See kernel_cache.h.  Tries in this order: POCL_CACHE_DIR as set, PoCL's own places (XDG_CACHE_HOME, HOME), the home
// folder of the password file; last a private folder that is removed at the end.
#include "device/kernel_cache.h"

#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "base/error.h"

namespace device {
namespace {

namespace fs = std::filesystem;

std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

std::string usual_folder() {
    if (const std::string cache = variable("XDG_CACHE_HOME"); !cache.empty()) return cache + "/pocl/kcache";
    std::string home = variable("HOME");
    if (home.empty())
        if (const struct passwd* user = getpwuid(getuid())) home = user->pw_dir;
    return home.empty() ? "" : home + "/.cache/pocl/kcache";
}

// An existing or new folder that belongs to this user alone.
bool is_ours(const std::string& folder) {
    std::error_code none;
    fs::create_directories(folder, none);
    struct stat info = {};
    return stat(folder.c_str(), &info) == 0 && S_ISDIR(info.st_mode) && info.st_uid == geteuid() &&
           !(info.st_mode & S_IWOTH) && access(folder.c_str(), W_OK | X_OK) == 0;
}

std::string private_folder;

void remove_private_folder() {
    std::error_code none;
    fs::remove_all(private_folder, none);
}

}  // namespace

std::string choose_kernel_cache() {
    if (!private_folder.empty()) return "";
    if (const std::string chosen = variable("POCL_CACHE_DIR"); !chosen.empty()) {
        errno = 0;
        std::error_code none;
        fs::create_directories(chosen, none);
        if (access(chosen.c_str(), W_OK | X_OK) != 0) base::fail_system(chosen, "POCL_CACHE_DIR cannot be written");
        return chosen;
    }
    const std::string usual = usual_folder();
    if (!usual.empty() && usual[0] == '/' && is_ours(usual)) {
        setenv("POCL_CACHE_DIR", usual.c_str(), 1);
        return usual;
    }
    std::string name = variable("TMPDIR").empty() ? "/tmp" : variable("TMPDIR");
    name += "/luxpipe-kernels-XXXXXX";
    errno = 0;
    if (!mkdtemp(name.data())) base::fail_system(name, "no folder for compiled kernels");
    private_folder = name;
    std::atexit(remove_private_folder);
    setenv("POCL_CACHE_DIR", name.c_str(), 1);
    return "";
}

}  // namespace device
