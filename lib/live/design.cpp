// SPDX-License-Identifier: BSD-3-Clause
// See design.h.
#include "live/design.h"

#include <algorithm>
#include <sstream>

#include "base/split.h"
#include "live/json.h"

namespace live {

namespace {
constexpr size_t most_undone = 50, most_edits = 1000, most_views = 100, most_messages = 100, most_variants = 26;

template <class LIST>
void keep_last(LIST& list, size_t most) {
    if (list.size() > most) list.erase(list.begin());
}

std::string short_number(const std::string& text) {
    char out[40];
    std::snprintf(out, sizeof out, "%.4g", std::strtod(text.c_str(), nullptr));
    return out;
}
}  // namespace

void Design::change(size_t n, std::string text, bool goes_on) {
    Text& t = texts[n];
    if (!t.going) t.before.push_back(t.now), step({Step::Of::text, n});
    keep_last(t.before, most_undone);
    t.going = goes_on;
    if (preview) preview = std::chrono::steady_clock::now();
    t.now = std::move(text);
    ++t.version;
    paused = false;
    current = 0;
}

void Design::undo(size_t n) {
    Text& t = texts[n];
    if (t.before.empty()) return;
    t.now = t.before.back();
    t.before.pop_back();
    take_back(Step::Of::text, n);
    t.going = false;
    ++t.version;
    paused = false;
    current = 0;
}

void Design::replaced(size_t n, const std::string& on_disk) {
    Text& t = texts[n];
    if (t.now && *t.now != on_disk) t.before.push_back(t.now), step({Step::Of::text, n});
    t.now.reset();
    t.going = false;
    ++t.version;
}

void Design::obey(const std::string& commands) {
    current = 0;
    std::istringstream lines(commands);
    for (std::string line, word; std::getline(lines, line);) {
        std::istringstream(line) >> word;
        if (word == "what") continue;
        if (word != "next") paused = word == "pause";
        if (word == "preview") preview = std::chrono::steady_clock::now();
        else if (word != "pause") preview.reset();
        if (word == "go")
            for (Text& t : texts) t.going = false;
    }
}

bool Design::back() {
    if (views.size() < 2) return false;
    views.pop_back();
    take_back(Step::Of::view, 0);
    return true;
}

void Design::wrote(size_t n, std::string before, std::string tag) {
    step({Step::Of::regions, n, std::move(before), std::move(tag)});
}

void Design::step(Step step) {
    steps.push_back(std::move(step));
    keep_last(steps, most_undone);
    ++step_changes;
}

void Design::take_back(Step::Of of, size_t n) {
    const auto last =
        std::find_if(steps.rbegin(), steps.rend(), [&](const Step& s) { return s.of == of && s.file == n; });
    if (last != steps.rend()) steps.erase(std::next(last).base());
    ++step_changes;
}

// A view changes with the number of the edit alone: late pictures of the edit before do not count.  Messages stay
// current until the files that they may be about are rendered.
bool Design::note(const image::Header& h) {
    const int64_t number = h.edit.value_or(0);
    if (h.edited == "preview" || (!edits.empty() && edits.back().first == number)) return false;
    edits.emplace_back(number, h.edited);
    const std::string view = h.view ? view::to_options(*h.view) : "";
    const bool before = reopened && number == 0;  // of the command line
    if (!view.empty() && !before && (views.empty() || views.back() != view)) {
        if (!views.empty()) {
            const bool joined = shown_ == std::pair(step_changes, view);
            step({Step::Of::view}), steps.back().joined = joined;
        }
        views.push_back(view);
    }
    keep_last(edits, most_edits);
    keep_last(views, most_views);
    const std::string why = h.edited.substr(0, h.edited.find(' '));
    if (why == "start" || why == "scene" || why == "overlay") current = 0;
    if (current == 0) {  // else the texts may be broken, and a view that changed shows those before
        rendered_.clear();
        for (const Text& t : texts) rendered_.push_back(t.now);
    }
    for (Variant& v : variants)
        if (v.edit < 0 && shows(v)) v.edit = number;
    return true;
}

// ---- variants

const Design::Variant* Design::variant(const std::string& name) const {
    for (const Variant& v : variants)
        if (v.name == name) return &v;
    return nullptr;
}

void Design::call(const std::string& name, const std::string& other) {
    for (Variant& v : variants)
        if (v.name == name) v.name = other;
    if (base == name) base = other;
    variants.erase(std::remove_if(variants.begin(), variants.end(), [](const Variant& v) { return v.name.empty(); }),
                   variants.end());
}

bool Design::shows(const Variant& v) const {
    for (size_t n = 0; n < texts.size(); ++n)
        if (v.texts[n] != texts[n].now) return false;
    return !views.empty() && v.view == views.back();
}

void Design::keep(const std::string& name) {
    Variant v{name, views.empty() ? "" : views.back(), {}, {}};
    for (const Text& t : texts) v.texts.push_back(t.now);
    if (!edits.empty() && v.texts == rendered_) v.edit = edits.back().first, v.picture = newest_;
    const auto same = std::find_if(variants.begin(), variants.end(), [&](const Variant& o) { return o.name == name; });
    if (same != variants.end()) *same = v;
    else if (variants.size() < most_variants) variants.push_back(v);
    if (base.empty()) base = name;
}

void Design::show(const Variant& v) {
    const size_t before = step_changes;
    for (size_t n = 0; n < texts.size(); ++n) {
        if (v.texts[n] == texts[n].now) continue;
        const bool first = step_changes == before;
        texts[n].going = false;
        change(n, "", false);
        texts[n].now = v.texts[n];
        steps.back().joined = !first;
    }
    if (step_changes != before) shown_ = {step_changes, v.view};
    paused = false;
}

bool Design::pictured(const std::shared_ptr<const image::Picture>& picture) {
    if (picture->header.edited == "preview") return false;
    if (newest_ && newest_->header.edit != picture->header.edit) before = newest_;
    newest_ = picture;
    const int64_t edit = picture->header.edit.value_or(0);
    const auto frames = [](const auto& p) { return p ? p->header.frames.value_or(0) : -1; };
    bool is_news = false;
    for (Variant& v : variants) {
        const bool again = shows(v) && v.texts == rendered_ && edit == edits.back().first && edit != v.edit;
        if (again && frames(picture) > frames(v.picture)) v.edit = edit, is_news = true;  // the one with more frames
        if (v.edit == edit) v.picture = picture;
    }
    return is_news;
}

// NAME value (low to high) of each column that has an interval.
void Design::measured(const std::string& line) {
    const std::vector<std::string> cells = base::split_list(line, '\t');
    const auto at = [&](const std::string& name) {
        return size_t(std::find(columns_.begin(), columns_.end(), name) - columns_.begin());
    };
    if (std::find(cells.begin(), cells.end(), "frame") != cells.end()) columns_ = cells;
    if (columns_ == cells || cells.size() != columns_.size() || at("edit") == cells.size()) return;
    for (Variant& v : variants) {
        if (std::to_string(v.edit) != cells[at("edit")]) continue;
        v.numbers.clear();
        for (size_t c = 0; c < cells.size(); ++c) {
            const size_t low = at(columns_[c] + ".lo"), high = at(columns_[c] + ".hi");
            if (high < cells.size() && cells[c] != "nan")
                v.numbers += columns_[c] + " " + short_number(cells[c]) + " (" + short_number(cells[low]) + " to " +
                             short_number(cells[high]) + ")\n";
        }
    }
}

void Design::tell(std::string message) {
    messages.push_back(std::move(message));
    keep_last(messages, most_messages);
    current = std::min(current + 1, messages.size());
}

std::string Design::json() const {
    std::string out = "{\"texts\":[";
    for (const Text& t : texts)
        out += (&t == texts.data() ? "" : ",") + ("[" + std::to_string(t.version)) + (t.now ? ",true]" : ",false]");
    out += "],\"edits\":[";
    for (const auto& [number, words] : edits)
        out += (out.back() == '[' ? "[" : ",[") + std::to_string(number) + "," + json::text(words) + "]";
    out += "],\"places\":[";
    for (const auto& [name, view] : places) out += (out.back() == '[' ? "" : ",") + json::list({name, view});
    out += "],\"variants\":[";
    for (const Variant& v : variants)
        out += (&v == variants.data() ? "" : ",") + ("{\"name\":" + json::text(v.name)) +
               ",\"edit\":" + std::to_string(v.edit) + ",\"shown\":" + (shows(v) ? "true" : "false") +
               ",\"numbers\":" + json::list(base::split_list(v.numbers, '\n')) + "}";
    out += "],\"steps\":[" + std::to_string(step_changes) + "," + std::to_string(steps.size());
    out += "],\"before\":" + std::to_string(before ? before->header.edit.value_or(0) : -1) + ",\"day\":" + day +
           ",\"plan\":" + plan;
    return out + ",\"base\":" + json::text(base) + ",\"earlier\":" + json::list(earlier) +
           ",\"views\":" + json::list(views) + ",\"messages\":" + json::list({messages.begin(), messages.end()}) +
           ",\"current\":" + std::to_string(current) + ",\"paused\":" + (paused ? "true}" : "false}");
}

}  // namespace live
