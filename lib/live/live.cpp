// SPDX-License-Identifier: BSD-3-Clause
// See live.h.
#include "live/live.h"

#include <algorithm>

namespace live {

void Live::put_picture(image::Picture picture) {
    put([&] {
        if (design_.note(picture.header)) ++designs_;
        picture_ = std::make_shared<const image::Picture>(std::move(picture));
        design_.pictured(picture_);
        ++pictures_;
    });
}

void Live::put_line(std::string line) {
    put([&] {
        design_.measured(line);
        lines_.push_back(std::move(line));
    });
}

void Live::put_end(int status) {
    put([&] { ended_ = status; });
}

void Live::put_file_change() {
    put([&] { ++file_changes_; });
}

std::optional<Live::News> Live::since(Numbers known, bool knows_end) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    const size_t line = std::min(known.line, lines_.size());
    if (known.picture >= pictures_ && line >= lines_.size() && known.files >= file_changes_ &&
        known.design >= designs_ && (knows_end || !ended_))
        return std::nullopt;
    News news;
    static_cast<Numbers&>(news) = {pictures_, lines_.size(), file_changes_, designs_};
    if (known.picture < pictures_) news.shown = picture_;
    news.lines.assign(lines_.begin() + std::ptrdiff_t(line), lines_.end());
    if (known.design < designs_) news.state = design_.json();
    news.ended = ended_;
    return news;
}

Live::Numbers Live::numbers() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return {pictures_, lines_.size(), file_changes_, designs_};
}

std::shared_ptr<const image::Picture> Live::picture() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return picture_;
}

}  // namespace live
