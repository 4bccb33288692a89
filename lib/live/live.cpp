// SPDX-License-Identifier: BSD-3-Clause
// See live.h.
#include "live/live.h"

#include <algorithm>
#include <fstream>

#include "base/run.h"

namespace live {

Live::Live(Files files) : files_(std::move(files)) {
    for (const TextFile& f : files_) state_.files.push_back({f.path, f.kind, f.writable});
    state_.now.texts.resize(files_.size());
    for (size_t n = 0; n < files_.size(); ++n) files_[n].changed(), look_at(n);
}

double Live::now() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - since_).count(); }

// Where a file cannot be written nothing has happened.
std::optional<Answer> Live::happen(const Event& event) {
    auto [next, effects] = step(state_, event);
    std::optional<Answer> answer;
    for (const Effect& e : effects) {
        if (const auto* a = std::get_if<Answer>(&e)) answer = *a;
        const auto* w = std::get_if<Write>(&e);
        if (!w || w->to != Write::To::file) continue;
        try {
            if (!files_[w->n].write(w->text, w->tag)) return plain(412, files_[w->n].path + " has been changed since");
        } catch (const base::Error& error) {
            return plain(error.kind == base::Kind::input ? 400 : 500, error.text);
        }
    }
    state_ = std::move(next);
    for (const Effect& e : effects) {
        const auto* w = std::get_if<Write>(&e);
        if (w && w->to == Write::To::against && !against_.empty()) std::ofstream(against_) << w->text;
        else if (!w && !std::holds_alternative<Answer>(e) && carry_) carry_(e);
    }
    if (std::string shown = json_of(state_, false); shown != shown_) shown_ = std::move(shown), ++designs_;
    return answer;
}

void Live::look_at(size_t n) { happen({now(), FileIs{n, files_[n].read()}}); }

bool Live::look_at_files() {
    bool changed = false;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        for (size_t n = 0; n < files_.size(); ++n)
            if (files_[n].changed()) look_at(n), changed = true;
        file_changes_ += changed;
    }
    if (changed && changed_) changed_();
    return changed;
}

Answer Live::ask(const Request& request) {
    look_at_files();
    std::optional<Answer> answer;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        for (size_t n = 0; n < files_.size() && request.put; ++n) look_at(n);  // also what a stamp does not tell
        answer = happen({now(), request});
    }
    if (changed_) changed_();
    return answer.value_or(plain(500, "no answer"));
}

void Live::put(decltype(Event::what) what) {
    bool is_news = !std::holds_alternative<Tick>(what) && !std::holds_alternative<Listens>(what);
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        const size_t before = designs_, told = state_.told;
        const bool ended = std::holds_alternative<Ended>(what);
        happen({now(), std::move(what)});
        is_news = is_news || designs_ != before;
        if (ended && state_.told != told) base::say(state_.messages.back().text);
    }
    if (is_news && changed_) changed_();
}

// A program that has read a file shows it only after we have looked, too.
void Live::put_picture(Which which, image::Picture picture) {
    look_at_files();
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (picture.header.edit) *picture.header.edit += state_.pipe(which).first_edit;
        happen({now(), Came{which, std::make_shared<const image::Picture>(std::move(picture))}});
        pictures_ += which == Which::picture;
    }
    if (changed_) changed_();
}

std::string Live::put_line(Which which, std::string line) {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        std::vector<std::string>& names = names_[size_t(which)];
        std::optional<Row> row = read_row(names, line);
        if (const int64_t first = state_.pipe(which).first_edit; row && first > 0) {
            line = with_edit(names, line, row->edit() + first);
            row = read_row(names, line);
        }
        if (row) happen({now(), Measured{which, *row}});
        if (which == Which::picture) lines_.push_back(line);
    }
    if (changed_) changed_();
    return line;
}

void Live::put_said(Which which, const std::string& line) {
    bool is_news = false;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        const size_t before = state_.told;
        happen({now(), Said{which, line}});
        is_news = state_.told != before;
    }
    if (is_news) base::say(line);
    if (changed_) changed_();
}

void Live::put_end(int status) { put(Ended{Which::picture, "", status}); }

std::optional<Live::News> Live::since(Numbers known, bool knows_end) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    const size_t line = std::min(known.line, lines_.size());
    if (known.picture >= pictures_ && line >= lines_.size() && known.files >= file_changes_ &&
        known.design >= designs_ && (knows_end || !state_.ended))
        return std::nullopt;
    News news;
    static_cast<Numbers&>(news) = {pictures_, lines_.size(), file_changes_, designs_};
    if (known.picture < pictures_) news.shown = state_.picture;
    news.lines.assign(lines_.begin() + std::ptrdiff_t(line), lines_.end());
    if (known.design < designs_) news.state = json_of(state_);
    news.ended = state_.ended;
    return news;
}

Live::Numbers Live::numbers() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return {pictures_, lines_.size(), file_changes_, designs_};
}

State Live::state() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return state_;
}

}  // namespace live
