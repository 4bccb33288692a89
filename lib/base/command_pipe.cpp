// SPDX-License-Identifier: BSD-3-Clause
// See command_pipe.h.
#include "base/command_pipe.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "base/error.h"

namespace base {
namespace {

constexpr size_t longest_line = 1 << 16;

int open_fifo(const std::string& path, int mode) {
    struct stat info = {};
    errno = 0;
    if (stat(path.c_str(), &info) != 0) fail_system(path, "cannot be opened");
    errno = 0;
    if (!S_ISFIFO(info.st_mode)) fail_system(path, "is not a FIFO (mkfifo makes one)");
    const int fd = open(path.c_str(), mode | O_NONBLOCK | O_CLOEXEC);
    if (fd < 0 && errno == ENXIO) errno = 0, fail_system(path, "has no reader");
    if (fd < 0) fail_system(path, "cannot be opened");
    return fd;
}

}  // namespace

CommandPipe::CommandPipe(const std::string& path) : path_(path), fd_(open_fifo(path, O_RDWR)) {}
CommandPipe::~CommandPipe() { close(fd_); }

bool CommandPipe::read_more() {
    char block[1 << 14];
    const ssize_t n = read(fd_, block, sizeof block);
    if (n > 0) waiting_.append(block, size_t(n));
    return n > 0;
}

std::optional<std::string> CommandPipe::line() {
    size_t end;
    while ((end = waiting_.find('\n')) == std::string::npos) {
        if (waiting_.size() > longest_line) too_long_ = true, waiting_.clear();
        if (!read_more()) return std::nullopt;
    }
    std::string found = waiting_.substr(0, end);
    waiting_.erase(0, end + 1);
    if (std::exchange(too_long_, false) || found.size() > longest_line)
        fail(path_, "a line is longer than 65536 bytes");
    return found;
}

std::optional<std::string> CommandPipe::bytes(size_t count) {
    while (waiting_.size() < count)
        if (!read_more()) return std::nullopt;
    std::string found = waiting_.substr(0, count);
    waiting_.erase(0, count);
    return found;
}

void CommandPipe::wait(int ms) const {
    struct pollfd at = {fd_, POLLIN, 0};
    poll(&at, 1, ms);
}

void send_command(const std::string& path, const std::string& line) {
    const int fd = open_fifo(path, O_WRONLY);
    const std::string text = line + "\n";
    errno = 0;
    const bool sent = write(fd, text.data(), text.size()) == ssize_t(text.size());
    const int code = errno;
    close(fd);
    errno = code;
    if (!sent) fail_system(path, "cannot be written");
}

}  // namespace base
