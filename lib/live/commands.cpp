// SPDX-License-Identifier: BSD-3-Clause
// See commands.h.
#include "live/commands.h"

#include "live/fifo.h"

namespace live {

namespace {

constexpr size_t longest_command = 64 * 1024, most_words = 200;

// A line for ptrace: words for the edit that follows.
std::string noted(std::string words) {
    for (char& c : words)
        if ((unsigned char)c < ' ') c = ' ';
    return words.empty() ? "" : "note " + words.substr(0, most_words) + "\n";
}

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

// A line and, behind it, the text that stands for a file; nothing: the one on the disk.
std::string overlaying(const TextFile& f, const std::optional<std::string>& text) {
    return "overlay " + f.path + " " + (text ? std::to_string(text->size()) + "\n" + *text : "-\n");
}

// A text that stands for a file of -edit until the file changes on the disk; nothing: the last change is undone.
Answer overlay(const Commanded& to, const Arguments& asked, std::optional<std::string> text) {
    const TextFile* f = named(to.files, asked);
    if (!f || f->kind != TextFile::Kind::scene) return plain(404, "no such file");
    const size_t n = size_t(f - to.files.data());
    const Design::Text was = to.live.ask([&](const Design& d) { return d.texts[n]; });
    if (asked("version") != std::to_string(was.version))
        return plain(412, f->path + " has been changed in another window");
    const bool undoes = !text;
    if (undoes && was.before.empty()) return plain(409, "there is nothing to undo");
    if (undoes) text = was.before.back();
    Answer answer = to_fifo(to, noted(undoes ? f->path + ": undone" : asked("said")) + overlaying(*f, text));
    if (answer.status != 204) return answer;
    to.live.change([&](Design& d) {
        if (undoes) d.undo(n);
        else d.change(n, std::move(*text), !asked("going").empty());
    });
    return {200, "text/plain; charset=utf-8", "", std::to_string(was.version + 1)};
}

Answer back(const Commanded& to) {
    const auto views = to.live.ask([](const Design& d) { return d.views; });
    if (views.size() < 2) return plain(409, "there is no earlier view");
    Answer answer = to_fifo(to, "view " + views[views.size() - 2] + "\n");
    if (answer.status == 204) to.live.change([](Design& d) { d.back(); });
    return answer;
}

}  // namespace

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
    if (path == "/undo") return overlay(to, asked, std::nullopt);
    if (path == "/back") return back(to);
    return plain(404, "nothing here");
}

}  // namespace live
