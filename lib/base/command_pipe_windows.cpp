// SPDX-License-Identifier: BSD-3-Clause
// See command_pipe.h.
#include "base/command_pipe.h"

#include <cerrno>

#include "base/error.h"

namespace base {

void send_command(const std::string& path, const std::string&) {
    errno = 0;
    fail_system(path, "is not a FIFO: Windows does not have them");
}

}  // namespace base
