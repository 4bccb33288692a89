// SPDX-License-Identifier: BSD-3-Clause
// See child.h.
#include "base/child.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

#include "base/descriptor.h"

extern char** environ;

namespace base {

// Signals wait while a child starts, so that none falls between its start and `group`.  A child must not inherit
// SIGPIPE and the like as we have them: base::run() ignores some.
int start_child(const std::vector<std::string>& words, const ChildFiles& files, pid_t& child,
                std::atomic<pid_t>* group) {
    sigset_t all, before, ordinary;
    sigfillset(&all);
    sigemptyset(&ordinary);
    for (int s : {SIGPIPE, SIGXFSZ, SIGINT, SIGTERM}) sigaddset(&ordinary, s);
    sigprocmask(SIG_BLOCK, &all, &before);

    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(
        &attributes, short(POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK | (group ? POSIX_SPAWN_SETPGROUP : 0)));
    posix_spawnattr_setsigdefault(&attributes, &ordinary);
    posix_spawnattr_setsigmask(&attributes, &before);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    if (files.in < 0) posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    else posix_spawn_file_actions_adddup2(&actions, files.in, 0);
    posix_spawn_file_actions_adddup2(&actions, files.out, 1);
    if (files.errors < 0) posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
    else if (files.errors != 2) posix_spawn_file_actions_adddup2(&actions, files.errors, 2);

    std::vector<char*> argv;
    for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr);
    const int code = posix_spawnp(&child, argv[0], &actions, &attributes, argv.data(), environ);
    if (code == 0 && group) *group = child;
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    sigprocmask(SIG_SETMASK, &before, nullptr);
    return code;
}

int wait_for_child(pid_t child) {
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {}
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

std::string read_to_end(int fd, size_t limit) {
    std::string text;
    char block[1 << 16];
    for (ssize_t n; text.size() <= limit && (n = read_some(fd, block, sizeof block)) > 0;)
        text.append(block, size_t(n));
    return text;
}

}  // namespace base
