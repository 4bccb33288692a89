// SPDX-License-Identifier: BSD-3-Clause
// See outbox.h.
#include "live/outbox.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "base/wait.h"

namespace live {

namespace {
constexpr size_t most_waiting = size_t(64) << 20, most_at_once = 1 << 16;
constexpr int patience_ms = 100;  // between looks at the end

bool has_reader(int fd) {
    pollfd one{fd, POLLOUT, 0};
    return poll(&one, 1, 0) >= 0 && !(one.revents & POLLERR);
}
}  // namespace

Outbox::~Outbox() {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        ends_ = true;
    }
    news_.notify_all();
    thread_.join();
}

void Outbox::to(int descriptor) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (descriptor >= 0) fcntl(descriptor, F_SETFL, fcntl(descriptor, F_GETFL) | O_NONBLOCK);
    end_ = descriptor >= 0 ? std::make_shared<const End>(descriptor) : nullptr;
    if (!end_) waiting_.clear();
    news_.notify_all();
}

bool Outbox::listens(const std::string& fifo) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (end_ && !has_reader(end_->fd)) end_.reset(), waiting_.clear();
    if (end_) return true;
    const int fd = open(fifo.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
    if (fd < 0) return false;
    end_ = std::make_shared<const End>(fd);
    struct stat info = {};
    if (fstat(fd, &info) != 0 || !S_ISFIFO(info.st_mode)) end_.reset();
    return bool(end_);
}

void Outbox::put(const std::string& bytes) {
    const std::lock_guard<std::mutex> lock(mutex_);
    waiting_ += bytes;
    news_.notify_all();
}

bool Outbox::is_full() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return waiting_.size() > most_waiting;
}

void Outbox::work() {
    std::unique_lock<std::mutex> lock(mutex_);
    for (;;) {
        base::wait(news_, lock, [this] { return ends_ || (end_ && !waiting_.empty()); });
        if (ends_) return;
        const std::shared_ptr<const End> end = end_;
        const ssize_t n = write(end->fd, waiting_.data(), std::min(waiting_.size(), most_at_once));
        if (n > 0) waiting_.erase(0, size_t(n));
        else if (errno == EAGAIN) {
            lock.unlock();
            pollfd one{end->fd, POLLOUT, 0};
            poll(&one, 1, patience_ms);
            lock.lock();
        } else if (errno != EINTR) end_.reset(), waiting_.clear();
    }
}

}  // namespace live
