// SPDX-License-Identifier: BSD-3-Clause
// See shell.h.
#include "base/shell.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>

#include "base/descriptor.h"
#include "base/error.h"
#include "base/printable.h"

namespace base {
namespace {

std::atomic<pid_t> group{0};  // of the command that runs, 0: none

// Signals a child must not inherit as we have them: base::run() ignores some.
const int ordinary[] = {SIGPIPE, SIGXFSZ, SIGINT, SIGTERM};

// The child's process id, or an errno.  Signals wait meanwhile, so that none falls between the start and `group`.
int start(const std::string& command, int out, pid_t& child) {
    sigset_t all, before, defaults;
    sigfillset(&all);
    sigemptyset(&defaults);
    for (int s : ordinary) sigaddset(&defaults, s);
    sigprocmask(SIG_BLOCK, &all, &before);

    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
    posix_spawnattr_setsigdefault(&attributes, &defaults);
    posix_spawnattr_setsigmask(&attributes, &before);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&files, out, 1);

    const char* words[] = {"sh", "-c", command.c_str(), nullptr};
    const int code = posix_spawn(&child, "/bin/sh", &files, &attributes, const_cast<char**>(words), environ);
    if (code == 0) group = child;
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&attributes);
    sigprocmask(SIG_SETMASK, &before, nullptr);
    return code;
}

}  // namespace

void end_shell() {
    if (const pid_t pid = group) kill(-pid, SIGTERM);
}

ShellOutput run_shell(const std::string& command, size_t limit, const std::string& place) {
    const std::string what = "cannot run \"" + excerpt(command) + "\"";
    int pipe_ends[2];
    if (pipe2(pipe_ends, O_CLOEXEC) != 0) fail_system(place, what);
    pid_t child = 0;
    const int code = start(command, pipe_ends[1], child);
    close(pipe_ends[1]);
    ShellOutput out;
    char buffer[1 << 16];
    ssize_t n = 0;
    while (code == 0 && !out.too_long && (n = read_some(pipe_ends[0], buffer, sizeof buffer)) > 0) {
        out.text.append(buffer, size_t(n));
        out.too_long = out.text.size() > limit;
    }
    close(pipe_ends[0]);
    errno = code;
    if (code != 0) fail_system(place, what);
    if (out.too_long) end_shell();
    while (waitpid(child, &out.status, 0) < 0 && errno == EINTR) {}
    group = 0;
    out.status = WIFEXITED(out.status) ? WEXITSTATUS(out.status) : 128 + WTERMSIG(out.status);
    return out;
}

}  // namespace base
