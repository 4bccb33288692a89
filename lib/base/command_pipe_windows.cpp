// SPDX-License-Identifier: BSD-3-Clause
// See command_pipe.h.
#include "base/command_pipe.h"

#include <cerrno>

#include "base/error.h"

namespace base {
namespace {

[[noreturn]] void fail_without_fifo(const std::string& path) {
    errno = 0;
    fail_system(path, "is not a FIFO: Windows does not have them");
}

}  // namespace

CommandPipe::CommandPipe(const std::string& path) { fail_without_fifo(path); }
CommandPipe::~CommandPipe() {}
std::optional<std::string> CommandPipe::line() { return std::nullopt; }
std::optional<std::string> CommandPipe::bytes(size_t) { return std::nullopt; }
void CommandPipe::wait(int) const {}

void send_command(const std::string& path, const std::string&) { fail_without_fifo(path); }

}  // namespace base
