// SPDX-License-Identifier: BSD-3-Clause
// See input.h.
#include "image/input.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "base/descriptor.h"
#include "base/error.h"
#include "base/file_status.h"
#include "base/open_file.h"
#include "base/shutdown.h"

namespace image {

Input::Input(const std::string& path, const base::Opener& by)
    : name_(path), own_(path != "-" || !by.place.empty()), buffer_(1 << 16) {
    if (!own_) name_ = "stdin";
    fd_ = own_ ? base::open_file(path, by) : 0;
    const base::FileKind kind = base::status_of(fd_).kind;
    if (kind == base::FileKind::folder) {
        if (own_) base::close_descriptor(fd_);
        errno = EISDIR;
        base::fail_system(name_, "cannot be read");
    }
    regular_ = kind == base::FileKind::ordinary;
    if (kind == base::FileKind::pipe) base::widen_pipe(fd_);
}

Input::~Input() {
    if (own_) base::close_descriptor(fd_);
}

size_t Input::read_some(void* data, size_t bytes) {
    if (end_) return 0;
    const ssize_t n = base::read_some(fd_, data, bytes);
    if (n < 0) base::fail_system(name_, "cannot be read");
    end_ = n == 0;
    return size_t(n);
}

bool Input::fill() {
    at_ = 0;
    have_ = read_some(buffer_.data(), buffer_.size());
    return have_ > 0;
}

bool Input::at_end() {
    if (at_ < have_) return false;
    if (!regular_ && !base::wait_for_input(fd_)) return true;
    return !fill();
}

size_t Input::read(void* data, size_t bytes) {
    auto* to = static_cast<unsigned char*>(data);
    size_t done = std::min(bytes, have_ - at_);
    std::memcpy(to, &buffer_[0] + at_, done);
    at_ += done;
    while (done < bytes) {
        if (bytes - done >= buffer_.size()) {
            const size_t n = read_some(to + done, bytes - done);
            if (!n) break;
            done += n;
        } else {
            if (!fill()) break;
            const size_t n = std::min(bytes - done, have_);
            std::memcpy(to + done, buffer_.data(), n);
            at_ = n;
            done += n;
        }
    }
    return done;
}

bool Input::look(void* data, size_t bytes) {
    while (have_ - at_ < bytes) {
        std::memmove(&buffer_[0], &buffer_[0] + at_, have_ - at_);
        have_ -= at_;
        at_ = 0;
        const size_t n = read_some(&buffer_[0] + have_, buffer_.size() - have_);
        if (!n) return false;
        have_ += n;
    }
    std::memcpy(data, &buffer_[0] + at_, bytes);
    return true;
}

std::optional<uint64_t> Input::remaining() const {
    const base::FileStatus info = base::status_of(fd_);
    if (!regular_ || !info.is_ordinary()) return std::nullopt;
    const uint64_t size = info.stamp.size, at = base::place_in(fd_);
    return (size > at ? size - at : 0) + (have_ - at_);
}

}  // namespace image
