// SPDX-License-Identifier: BSD-3-Clause
// See design.h.
#include "live/design.h"

#include <algorithm>
#include <sstream>

#include "live/json.h"

namespace live {

namespace {
constexpr size_t most_undone = 50, most_edits = 1000, most_views = 100, most_messages = 100;

template <class LIST>
void keep_last(LIST& list, size_t most) {
    if (list.size() > most) list.erase(list.begin());
}
}  // namespace

void Design::change(size_t n, std::string text, bool goes_on) {
    Text& t = texts[n];
    if (!t.going) t.before.push_back(t.now);
    keep_last(t.before, most_undone);
    t.going = goes_on;
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
    t.going = false;
    ++t.version;
    paused = false;
    current = 0;
}

void Design::replaced(size_t n, const std::string& on_disk) {
    Text& t = texts[n];
    if (t.now && *t.now != on_disk) t.before.push_back(t.now);
    t.now.reset();
    t.going = false;
    ++t.version;
}

void Design::obey(const std::string& commands) {
    current = 0;
    std::istringstream lines(commands);
    for (std::string line, word; std::getline(lines, line);) {
        std::istringstream(line) >> word;
        if (word != "next") paused = word == "pause";
        if (word == "go")
            for (Text& t : texts) t.going = false;
    }
}

bool Design::back() {
    if (views.size() < 2) return false;
    views.pop_back();
    return true;
}

// A view changes with the number of the edit alone: late pictures of the edit before do not count.
bool Design::note(const image::Header& h) {
    const int64_t number = h.edit.value_or(0);
    if (h.edited == "preview" || (!edits.empty() && edits.back().first == number)) return false;
    edits.emplace_back(number, h.edited);
    const std::string view = h.view ? view::to_options(*h.view) : "";
    const bool before = reopened && number == 0;  // of the command line
    if (!view.empty() && !before && (views.empty() || views.back() != view)) views.push_back(view);
    keep_last(edits, most_edits);
    keep_last(views, most_views);
    current = 0;
    return true;
}

void Design::tell(std::string message) {
    messages.push_back(std::move(message));
    keep_last(messages, most_messages);
    current = std::min(current + 1, messages.size());
}

std::string Design::json() const {
    std::string out = "{\"texts\":[";
    for (const Text& t : texts)
        out += (&t == texts.data() ? "" : ",") + ("[" + std::to_string(t.version)) + (t.now ? ",true" : ",false") +
               (t.before.empty() ? ",false]" : ",true]");
    out += "],\"edits\":[";
    for (const auto& [number, words] : edits)
        out += (out.back() == '[' ? "[" : ",[") + std::to_string(number) + "," + json::text(words) + "]";
    out += "],\"places\":[";
    for (const auto& [name, view] : places) out += (out.back() == '[' ? "" : ",") + json::list({name, view});
    return out + "],\"earlier\":" + json::list(earlier) + ",\"views\":" + json::list(views) +
           ",\"messages\":" + json::list({messages.begin(), messages.end()}) +
           ",\"current\":" + std::to_string(current) + ",\"paused\":" + (paused ? "true}" : "false}");
}

}  // namespace live
