// SPDX-License-Identifier: BSD-3-Clause
// See shell.h.
#include "base/shell.h"

#include <cerrno>

#include "base/error.h"
#include "base/printable.h"

namespace base {

ShellOutput run_shell(const std::string& command, size_t, const std::string& place) {
    errno = 0;
    fail_system(place, "cannot run \"" + excerpt(command) + "\": Windows has no /bin/sh");
}

}  // namespace base
