// SPDX-License-Identifier: BSD-3-Clause
// See child.h.
#include "device/child.h"

#include <fcntl.h>
#include <signal.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

#include "base/descriptor.h"

namespace device {
namespace {

constexpr unsigned patience_s = 60;

[[noreturn]] void answer(const std::function<std::string()>& question, int to) {
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // ends with the program that asked
#endif
    for (int s : {SIGINT, SIGTERM, SIGHUP, SIGALRM}) signal(s, SIG_DFL);
    const struct rlimit no_core = {0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    alarm(patience_s);
    if (const int null = open("/dev/null", O_WRONLY); null >= 0) dup2(null, 2);
    try {
        const std::string text = question();
        _exit(base::write_all(to, text.data(), text.size()) ? 0 : 1);
    } catch (...) {
        _exit(1);
    }
}

}  // namespace

std::optional<std::string> ask_in_child(const std::function<std::string()>& question) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) return std::nullopt;
    const pid_t child = fork();
    if (child == 0) answer(question, ends[1]);
    close(ends[1]);
    std::string text;
    char block[4096];
    ssize_t n = 0;
    while (child > 0 && (n = base::read_some(ends[0], block, sizeof block)) > 0) text.append(block, size_t(n));
    close(ends[0]);
    if (child < 0) return std::nullopt;
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {}
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return std::nullopt;
    return text;
}

}  // namespace device
