// SPDX-License-Identifier: BSD-3-Clause
// See live.h.
#include "live/live.h"

#include <algorithm>

namespace live {

namespace {
constexpr std::chrono::seconds patience{3};  // for an answer of ptrace
constexpr size_t most_questions = 1000;
}  // namespace

void Live::put_picture(image::Picture picture) {
    put([&] {
        if (!picture_ || picture.header.edit != picture_->header.edit) questions_.clear();
        const bool is_news = design_.note(picture.header);
        picture_ = std::make_shared<const image::Picture>(std::move(picture));
        if (design_.pictured(picture_) || is_news) ++designs_;
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

void Live::put_seen(const std::string& line) {
    put([&] {
        const size_t words = line.find("what ") + 5, end = std::min(line.find('\t'), line.size() - 1);
        questions_[line.substr(words, end - words)].answer = line.substr(end + 1);
    });
}

std::optional<std::string> Live::seen(const std::string& words) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = questions_.find(words);
    if (found == questions_.end() || !picture_) return std::nullopt;
    const std::string edit = std::to_string(picture_->header.edit.value_or(0)) + "\t", &answer = found->second.answer;
    if (answer.compare(0, edit.size(), edit) != 0) return std::nullopt;
    return answer.substr(edit.size());
}

bool Live::asks(const std::string& words) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto now = std::chrono::steady_clock::now();
    if (questions_.size() > most_questions) questions_.clear();
    Question& q = questions_[words];
    if (now - q.asked < patience) return false;
    q.asked = now;
    return true;
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
