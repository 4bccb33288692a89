// SPDX-License-Identifier: BSD-3-Clause
// See live.h.
#include "live/live.h"

#include <algorithm>

namespace live {

void Live::put_picture(image::Picture picture) {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        picture_ = std::make_shared<const image::Picture>(std::move(picture));
        ++pictures_;
    }
    if (changed_) changed_();
}

void Live::put_line(std::string line) {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        lines_.push_back(std::move(line));
    }
    if (changed_) changed_();
}

void Live::put_end(int status) {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        ended_ = status;
    }
    if (changed_) changed_();
}

void Live::put_file_change() {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        ++file_changes_;
    }
    if (changed_) changed_();
}

std::optional<Live::News> Live::since(Numbers known, bool knows_end) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    const size_t line = std::min(known.line, lines_.size());
    if (known.picture >= pictures_ && line >= lines_.size() && known.files >= file_changes_ && (knows_end || !ended_))
        return std::nullopt;
    News news;
    news.picture = pictures_;
    news.line = lines_.size();
    news.files = file_changes_;
    if (known.picture < pictures_) news.shown = picture_;
    news.lines.assign(lines_.begin() + std::ptrdiff_t(line), lines_.end());
    news.ended = ended_;
    return news;
}

std::shared_ptr<const image::Picture> Live::picture() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return picture_;
}

}  // namespace live
