// SPDX-License-Identifier: BSD-3-Clause
// See design_file.h.
#include "live/design_file.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "base/error.h"
#include "base/split.h"
#include "image/stream.h"
#include "live/steps.h"

namespace live {

namespace {

const char* const no_end = "(the last line has no end)";

// A line that says what follows, and the text, each line behind a tab.
void block(std::string& out, const std::string& head, const std::string& text) {
    out += "\n" + head + "\n";
    for (size_t at = 0, end; at < text.size(); at = end) {
        end = std::min(text.find('\n', at), text.size() - 1) + 1;
        out += "\t" + text.substr(at, end - at);
    }
    if (!text.empty() && text.back() != '\n') out += std::string("\n") + no_end + "\n";
}

// The words of an edit as the page has them.
std::string shown_words(const std::string& words) {
    return base::begins_with(words, "overlay ") ? words.substr(8) : words;
}

struct Block {
    std::string head, text;
    size_t line;  // of the head
};

std::vector<Block> blocks_in(const std::string& text, const std::string& place) {
    std::vector<Block> all;
    std::istringstream lines(text);
    std::string line, empty;
    for (size_t n = 1; std::getline(lines, line); ++n) {
        if (line.empty()) {
            empty += '\n';  // of a text whose tabs an editor has removed, if more of it follows
        } else if (line[0] == '\t') {
            if (all.empty()) base::fail(place, "line 1 names nothing that its text could be of");
            all.back().text += empty + line.substr(1) + "\n";
            empty.clear();
        } else if (line == no_end) {
            if (!all.empty() && !all.back().text.empty()) all.back().text.pop_back();
        } else {
            empty.clear();
            if (line[0] != '#') all.push_back({line, "", n});
        }
    }
    return all;
}

std::string without_end(std::string text) {
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text;
}

size_t scene_file(const std::string& name, const State& s, const std::string& where) {
    for (size_t n = 0; n < s.files.size(); ++n)
        if (s.files[n].path == name && s.files[n].kind == TextFile::Kind::scene) return n;
    base::fail(where, name + " is not among the files that the page changes (-edit)");
}

}  // namespace

std::string design_text(const State& s) {
    const Model& d = s.now;
    if (d.views.empty() && s.changes == 0) return "";
    std::string out =
        "# A design of luxpipe-live: what has been changed, as a text for -design FILE.\n"
        "# Lines behind a tab belong to the line before them.\n";
    std::string edits;
    for (const std::string& words : s.earlier) edits += words + "\n";
    for (const auto& [number, words] : s.edits)
        if (number > 0 && !base::ends_with(words, words_of_opening)) edits += shown_words(words) + "\n";
    block(out, "edits", edits);
    for (const auto& [name, view] : d.places) block(out, "view " + name, view + "\n");
    if (!d.views.empty()) out += "\nVIEW=" + d.view() + "\n";  // ptrace -vf takes it from here
    for (size_t n = 0; n < d.texts.size(); ++n)
        if (d.texts[n] && s.files[n].kind == TextFile::Kind::scene) block(out, "text " + s.files[n].path, *d.texts[n]);
    const auto regions = regions_file(s);
    if (regions && !(*text_of(s, d.texts, *regions)).empty()) block(out, "regions", *text_of(s, d.texts, *regions));
    if (!d.base.empty()) out += "\nbase " + d.base + "\n";
    for (const Variant& v : d.variants) {
        const Result* known = result_of(s, v.look);
        std::string numbers;
        for (const std::string& line : known ? known->numbers : std::vector<std::string>()) numbers += line + "\n";
        block(out, "variant " + v.name, numbers);
        if (!v.look.view.empty()) block(out, "its view", v.look.view + "\n");
        for (size_t n = 0; n < v.look.texts.size(); ++n)
            if (v.look.texts[n]) block(out, "its text " + s.files[n].path, *v.look.texts[n]);
    }
    return out;
}

State with_design(State s, const std::string& text, const std::string& place, std::string& regions) {
    Model d = s.now;
    std::vector<std::vector<std::string>> numbers;  // of the variants
    for (const Block& b : blocks_in(text, place)) {
        const std::string where = place + ": line " + std::to_string(b.line);
        const size_t blank = b.head.find(' ');
        const std::string kind = b.head.substr(0, blank), name = blank == b.head.npos ? "" : b.head.substr(blank + 1);
        if (b.head == "edits") {
            s.earlier = base::split_list(b.text, '\n');
        } else if (b.head == "regions") {
            regions = b.text;
        } else if (kind == "VIEW=") {
            d.views.push_back(" " + name);
        } else if (kind == "view") {
            d.places.emplace_back(name, without_end(b.text));
        } else if (kind == "base") {
            d.base = name;
        } else if (kind == "variant") {
            d.variants.push_back({name, {Texts(s.files.size()), ""}});
            numbers.push_back(base::split_list(b.text, '\n'));
        } else if (b.head == "its view" && !d.variants.empty()) {
            d.variants.back().look.view = without_end(b.text);
        } else if (base::begins_with(b.head, "its text ") && !d.variants.empty()) {
            d.variants.back().look.texts[scene_file(b.head.substr(9), s, where)] = Text(b.text);
        } else if (kind == "text") {
            d.texts[scene_file(name, s, where)] = Text(b.text);
        } else {
            base::fail(where, "\"" + b.head + "\" is no part of a design");
        }
    }
    for (size_t k = 0; k < numbers.size(); ++k)
        s.results.push_back({look_of(s, d.variants[k].look.texts, d.variants[k].look.view), -1, nullptr, numbers[k]});
    const bool changes = d.texts != s.now.texts;
    if (changes) s.undo.push_back({words_of_opening, d});  // Undo brings back the texts on the disk
    if (changes) s.undo.back().model.texts = s.now.texts;
    for (size_t n = 0; n < d.texts.size(); ++n) s.files[n].version += d.texts[n] != s.now.texts[n];
    s.now = d;
    return s;
}

State with_views(State s, const std::vector<std::string>& files) {
    for (const std::string& file : files) {
        const std::string view = view::to_options(view::read_view_file(file, "-view"));
        const std::string name = std::filesystem::path(file).stem().string();
        const auto known = [&](const auto& place) { return place.first == name; };
        if (std::none_of(s.now.places.begin(), s.now.places.end(), known)) s.now.places.emplace_back(name, view);
    }
    return s;
}

DesignFile::DesignFile(std::string path, Live& live) : path_(std::move(path)), live_(live) {
    if (path_.empty()) return;
    const FileNow now = TextFile(path_, TextFile::Kind::scene, true).read();
    if (!now.trouble.empty()) base::fail(path_, now.trouble);
    if (now.tag == "none" || now.text.empty()) return;
    std::string regions;
    live.begin([&](State& s) { s = with_design(std::move(s), now.text, path_, regions); });
    written_ = now.text;
    const auto n = regions_file(live.state());
    if (!n || regions.empty() || !live.files()[*n].writable || !live.files()[*n].read().text.empty()) return;
    live.files()[*n].write(regions, live.files()[*n].read().tag);
    const FileNow is = live.files()[*n].read();
    live.begin([&](State& s) {
        s.now.texts[*n] = s.files[*n].text = Text(is.text);
        s.files[*n].tag = is.tag;
        for (Change& c : s.undo) c.model.texts[*n] = Text(is.text);
    });
}

void DesignFile::look(bool last) {
    if (path_.empty()) return;
    const Live::Numbers now = live_.numbers();
    if (!last && now.design == seen_.design && now.files == seen_.files) return;
    seen_ = now;
    const State state = live_.state();
    const std::string text = design_text(state);
    if (text.empty() || text == written_) return;
    std::string wrong;
    try {
        image::write_bytes(path_, text);
        written_ = text;
    } catch (const base::Error& e) {
        wrong = "vcview: " + e.text + ": the design is not saved there";
    }
    if (wrong != trouble_) live_.put(Saved{wrong});
    if (!wrong.empty()) seen_.files = size_t(-1);  // tried again at the next look
    trouble_ = wrong;
}

}  // namespace live
