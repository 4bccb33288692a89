// SPDX-License-Identifier: BSD-3-Clause
// See shell.h.
#include "base/shell.h"

#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>

#include "base/child.h"
#include "base/descriptor.h"
#include "base/error.h"
#include "base/printable.h"

namespace base {
namespace {

std::atomic<pid_t> group{0};  // of the command that runs, 0: none

}  // namespace

void end_shell() {
    if (const pid_t pid = group) kill(-pid, SIGTERM);
}

ShellOutput run_shell(const std::string& command, size_t limit, const std::string& place) {
    const std::string what = "cannot run \"" + excerpt(command) + "\"";
    int ends[2];
    if (!make_pipe(ends)) fail_system(place, what);
    pid_t child = 0;
    ChildFiles files;
    files.out = ends[1];
    const int code = start_child({"/bin/sh", "-c", command}, files, child, &group);
    close(ends[1]);
    ShellOutput out;
    if (code == 0) out.text = read_to_end(ends[0], limit);
    close(ends[0]);
    errno = code;
    if (code != 0) fail_system(place, what);
    out.too_long = out.text.size() > limit;
    if (out.too_long) end_shell();
    out.status = wait_for_child(child);
    group = 0;
    return out;
}

}  // namespace base
