// SPDX-License-Identifier: BSD-3-Clause
// See commands.h.
#include "live/commands.h"

#include <algorithm>

#include "base/number.h"
#include "live/fifo.h"

namespace live {

std::string overlaying(const TextFile& f, const std::optional<std::string>& text) {
    return "overlay " + f.path + " " + (text ? std::to_string(text->size()) + "\n" + *text : "-\n");
}

namespace {

constexpr size_t longest_command = 64 * 1024, most_words = 200, most_places = 100;
constexpr auto longest_preview = std::chrono::seconds(3);

std::string one_line(std::string words) {
    for (char& c : words)
        if ((unsigned char)c < ' ') c = ' ';
    return words.substr(0, most_words);
}

// A line for ptrace: words for the edit that follows.
std::string noted(const std::string& words) { return words.empty() ? "" : "note " + one_line(words) + "\n"; }

Answer to_fifo(const Commanded& to, const std::string& bytes) {
    if (to.fifo.empty()) return plain(404, "vcview was started without -control");
    switch (write_whole(to.fifo, bytes)) {
    case Written::whole: return {204, "", ""};
    case Written::busy: return plain(503, "ptrace has not read the commands before");
    default: return plain(409, "nobody reads the FIFO");
    }
}

Answer control(const Commanded& to, const std::string& text) {
    if (text.size() > longest_command) return plain(413, "too long");
    for (const char c : text)
        if ((unsigned char)c < ' ' && c != '\n' && c != '\t') return plain(400, "control characters in a command");
    Answer answer = to_fifo(to, text.empty() || text.back() == '\n' ? text : text + "\n");
    if (answer.status == 204) to.live.change([&](Design& d) { d.obey(text); });
    return answer;
}

// A text that stands for a file of -edit until the file changes on the disk.
Answer overlay(const Commanded& to, const Arguments& asked, const std::string& text) {
    const TextFile* f = named(to.files, asked);
    if (!f || f->kind != TextFile::Kind::scene) return plain(404, "no such file");
    const size_t n = size_t(f - to.files.data()),
                 version = to.live.ask([&](const Design&d) { return d.texts[n].version; });
    if (asked("version") != std::to_string(version)) return plain(412, f->path + " has been changed in another window");
    Answer answer = to_fifo(to, noted(asked("said")) + overlaying(*f, text));
    if (answer.status != 204) return answer;
    to.live.change([&](Design& d) { d.change(n, text, !asked("going").empty()); });
    return {200, "text/plain; charset=utf-8", "", std::to_string(version + 1)};
}

Answer back(const Commanded& to) {
    const auto views = to.live.ask([](const Design& d) { return d.views; });
    if (views.size() < 2) return plain(409, "there is no earlier view");
    Answer answer = to_fifo(to, "view " + views[views.size() - 2] + "\n");
    if (answer.status == 204) to.live.change([](Design& d) { d.back(); });
    return answer;
}

Answer undo_text(const Commanded& to, size_t n) {
    const auto before = to.live.ask([&](const Design& d) { return d.texts[n].before.back(); });
    Answer answer = to_fifo(to, noted(to.files[n].path + ": undone") + overlaying(to.files[n], before));
    if (answer.status == 204) to.live.change([&](Design& d) { d.undo(n); });
    return answer;
}

Answer undo_regions(const Commanded& to, const Design::Step& step) {
    const bool done = to.files[step.file].write(step.before, step.tag).has_value();
    to.live.change([&](Design& d) { d.take_back(step.of, step.file); });
    return done ? Answer{204, "", ""} : plain(409, to.files[step.file].path + " has been changed since");
}

// The latest change of this state of the design.
Answer undo(const Commanded& to, const Arguments& asked) {
    const auto [steps, state] = to.live.ask([](const Design& d) { return std::pair(d.steps, d.step_changes); });
    if (asked("state") != std::to_string(state)) return plain(412, "the design has been changed meanwhile");
    Answer done = plain(409, "there is nothing to undo");
    using Of = Design::Step::Of;
    for (auto last = steps.rbegin(); last != steps.rend(); ++last) {
        done = last->of == Of::text   ? undo_text(to, last->file)
               : last->of == Of::view ? back(to)
                                      : undo_regions(to, *last);
        if (done.status != 204 || !last->joined) break;
    }
    done.tag = to.live.ask([](const Design& d) { return std::to_string(d.step_changes); });
    return done;
}

// The first letter, or number behind a word, that no item of a list has as its name.
template <class TAKEN>
std::string free_name(const std::string& word, TAKEN&& taken) {
    for (int k = 0;; ++k) {
        std::string name = word.empty() && k < 26 ? std::string(1, char('A' + k)) : word + " " + std::to_string(k + 1);
        if (!taken(name)) return name;
    }
}

Answer show(const Commanded& to, const Design::Variant& v) {
    const Design now = to.live.ask([](const Design& d) { return d; });
    std::string bytes = noted(v.name);
    for (size_t n = 0; n < v.texts.size(); ++n)
        if (v.texts[n] != now.texts[n].now) bytes += overlaying(to.files[n], v.texts[n]);
    if (!now.views.empty() && v.view != now.views.back()) bytes += "view" + v.view + "\n";
    Answer answer = to_fifo(to, bytes);
    if (answer.status == 204) to.live.change([&](Design& d) { d.show(v); });
    return answer;
}

Answer variant(const Commanded& to, const Arguments& asked) {
    const std::string name = one_line(asked("name")), what = asked("do"), other = one_line(asked("to"));
    Design::Variant known;
    const bool there = to.live.ask([&](const Design& d) {
        const Design::Variant* v = d.variant(name);
        if (v) known = *v;
        return v != nullptr;
    });
    if (what != "keep" && !there && !(what == "base" && name.empty()))
        return plain(404, "there is no variant \"" + name + "\"");
    if (what == "show") return show(to, known);
    to.live.change([&](Design& d) {
        if (what == "keep" && name.empty()) d.keep(free_name("", [&](const std::string& n) { return d.variant(n); }));
        else if (what == "keep") d.keep(name);
        else if (what == "base") d.base = name;
        else if (what == "drop") d.call(name, "");
        else if (what == "call" && !other.empty() && !d.variant(other)) d.call(name, other);
    });
    return {204, "", ""};
}

Answer place(const Commanded& to, const Arguments& asked) {
    const std::string name = one_line(asked("name"));
    to.live.change([&](Design& d) {
        const auto at = [&](const std::string& n) {
            return std::find_if(d.places.begin(), d.places.end(), [&](const auto& p) { return p.first == n; });
        };
        const auto taken = [&](const std::string& n) { return at(n) != d.places.end(); };
        if (taken(name)) d.places.erase(at(name));
        if (asked("do") == "keep" && !d.views.empty() && d.places.size() < most_places)
            d.places.emplace_back(name.empty() ? free_name("view", taken) : name, d.views.back());
    });
    return {204, "", ""};
}

}  // namespace

std::optional<Answer> answer_what(const Commanded& to, const Arguments& asked) {
    double x, y;
    if (!base::parse_real(asked("x"), x) || !base::parse_real(asked("y"), y)) return plain(400, "no place");
    const std::string words = asked("x") + " " + asked("y");
    if (auto seen = to.live.seen(words)) return Answer{200, "text/plain; charset=utf-8", *seen};
    if (!to.live.asks(words)) return std::nullopt;
    const Answer sent = to_fifo(to, "what " + words + "\n");
    return sent.status == 204 ? std::optional<Answer>() : sent;
}

void end_preview(const Commanded& to) {
    const auto since = to.live.ask([](const Design& d) { return d.preview; });
    if (since && std::chrono::steady_clock::now() - *since > longest_preview) control(to, "go");
}

void give_opened(const Commanded& to) {
    const std::string bytes = to.live.ask([&](const Design& d) {
        std::string all;
        if (d.given) return all;
        for (size_t n = 0; n < d.texts.size(); ++n)
            if (d.texts[n].now) all += overlaying(to.files[n], d.texts[n].now);
        if (!d.views.empty()) all += "view" + d.views.back() + "\n";
        return noted(words_of_opening) + all;
    });
    if (!bytes.empty() && to_fifo(to, bytes).status == 204) to.live.change([](Design& d) { d.given = true; });
}

Answer answer_command(const Commanded& to, const std::string& path, const Arguments& asked, const std::string& body) {
    if (path == "/control") return control(to, body);
    if (path == "/overlay") return overlay(to, asked, body);
    if (path == "/undo") return undo(to, asked);
    if (path == "/back") return back(to);
    if (path == "/variant") return variant(to, asked);
    if (path == "/place") return place(to, asked);
    return plain(404, "nothing here");
}

}  // namespace live
