// SPDX-License-Identifier: BSD-3-Clause
// See child.h.
#include "device/child.h"

#include <fcntl.h>
#include <signal.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <sys/resource.h>
#include <unistd.h>

#include "base/child.h"
#include "base/descriptor.h"

namespace device {
namespace {

constexpr unsigned patience_s = 60;
constexpr size_t longest = 1 << 20;

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
    if (!base::make_pipe(ends)) return std::nullopt;
    const pid_t child = fork();
    if (child == 0) answer(question, ends[1]);
    close(ends[1]);
    const std::string text = child > 0 ? base::read_to_end(ends[0], longest) : "";
    close(ends[0]);
    return child > 0 && base::wait_for_child(child) == 0 ? std::optional(text) : std::nullopt;
}

}  // namespace device
