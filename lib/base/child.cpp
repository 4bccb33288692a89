// SPDX-License-Identifier: BSD-3-Clause
// See child.h.
#include "base/child.h"

#include <fcntl.h>
#include <signal.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

#include "base/descriptor.h"

namespace base {

namespace {

// Runs in the process that becomes the child and shares our memory until then, so that it makes system calls alone.
// Returns if it fails.
void become(char* const* argv, const ChildFiles& files, const sigset_t& signals, bool group, pid_t parent) {
    const auto is = [](int fd, int instead, int mode) { dup2(fd < 0 ? open("/dev/null", mode) : fd, instead); };
    if (group) setpgid(0, 0);
#ifdef __linux__
    if (files.ends_with_us && prctl(PR_SET_PDEATHSIG, SIGTERM) != 0) return;
#endif
    if (files.ends_with_us && getppid() != parent) return;
    is(files.in, 0, O_RDONLY);
    is(files.out, 1, O_WRONLY);
    is(files.errors, 2, O_WRONLY);
    for (const int s : {SIGPIPE, SIGXFSZ, SIGINT, SIGTERM}) signal(s, SIG_DFL);
    sigprocmask(SIG_SETMASK, &signals, nullptr);
    execvp(argv[0], argv);
}

}  // namespace

// Signals wait while a child starts, so that none falls between its start and `group`.  A child must not inherit
// SIGPIPE and the like as we have them: base::run() ignores some.  (posix_spawn() has no PR_SET_PDEATHSIG.)
int start_child(const std::vector<std::string>& words, const ChildFiles& files, pid_t& child,
                std::atomic<pid_t>* group) {
    std::vector<char*> argv;
    for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr);
    int failed[2], code = 0;
    if (!make_pipe(failed)) return errno;
    sigset_t all, before;
    sigfillset(&all);
    sigprocmask(SIG_BLOCK, &all, &before);
    const pid_t parent = getpid(), started = vfork();
    if (started == 0) {
        become(argv.data(), files, before, group, parent);
        const int why = errno;
        const ssize_t told = write(failed[1], &why, sizeof why);
        _exit(told > 0 ? 127 : 126);
    }
    child = started;
    if (started < 0) code = errno;
    else if (group) *group = child;
    sigprocmask(SIG_SETMASK, &before, nullptr);
    close(failed[1]);
    if (started > 0 && read_some(failed[0], reinterpret_cast<char*>(&code), sizeof code) > 0) wait_for_child(child);
    close(failed[0]);
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
