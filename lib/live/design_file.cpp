// SPDX-License-Identifier: BSD-3-Clause
// See design_file.h.
#include "live/design_file.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "base/error.h"
#include "base/split.h"
#include "image/stream.h"

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

const TextFile* regions_among(const Files& files) {
    for (const TextFile& f : files)
        if (f.kind == TextFile::Kind::regions) return &f;
    return nullptr;
}

std::string regions_in(const Files& files) {
    const TextFile* f = regions_among(files);
    return f ? f->read().text : "";
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

size_t scene_file(const std::string& name, const Files& files, const std::string& where) {
    for (size_t n = 0; n < files.size(); ++n)
        if (files[n].path == name && files[n].kind == TextFile::Kind::scene) return n;
    base::fail(where, name + " is not among the files that the page changes (-edit)");
}

}  // namespace

std::string design_text(const Design& d, const Files& files, const std::string& regions) {
    std::string out =
        "# A design of luxpipe-live: what has been changed, as a text for -design FILE.\n"
        "# Lines behind a tab belong to the line before them.\n";
    std::string edits;
    for (const std::string& words : d.earlier) edits += words + "\n";
    for (const auto& [number, words] : d.edits)
        if (number > 0 && !base::ends_with(words, words_of_opening)) edits += shown_words(words) + "\n";
    block(out, "edits", edits);
    for (const auto& [name, view] : d.places) block(out, "view " + name, view + "\n");
    if (!d.views.empty()) out += "\nVIEW=" + d.views.back() + "\n";  // ptrace -vf takes it from here
    for (size_t n = 0; n < d.texts.size(); ++n)
        if (d.texts[n].now) block(out, "text " + files[n].path, *d.texts[n].now);
    if (!regions.empty()) block(out, "regions", regions);
    if (!d.base.empty()) out += "\nbase " + d.base + "\n";
    for (const Design::Variant& v : d.variants) {
        block(out, "variant " + v.name, v.numbers);
        if (!v.view.empty()) block(out, "its view", v.view + "\n");
        for (size_t n = 0; n < v.texts.size(); ++n)
            if (v.texts[n]) block(out, "its text " + files[n].path, *v.texts[n]);
    }
    return out;
}

Design read_design(const std::string& text, const std::string& place, const Files& files, std::string& regions) {
    Design d;
    d.texts.resize(files.size());
    for (const Block& b : blocks_in(text, place)) {
        const std::string where = place + ": line " + std::to_string(b.line);
        const size_t blank = b.head.find(' ');
        const std::string kind = b.head.substr(0, blank), name = blank == b.head.npos ? "" : b.head.substr(blank + 1);
        if (b.head == "edits") {
            std::istringstream lines(b.text);
            for (std::string line; std::getline(lines, line);) d.earlier.push_back(line);
        } else if (b.head == "regions") {
            regions = b.text;
        } else if (kind == "VIEW=") {
            d.views.push_back(" " + name);
        } else if (kind == "view") {
            d.places.emplace_back(name, without_end(b.text));
        } else if (kind == "base") {
            d.base = name;
        } else if (kind == "variant") {
            d.variants.push_back({name, "", b.text, std::vector<std::optional<std::string>>(files.size())});
        } else if (b.head == "its view" && !d.variants.empty()) {
            d.variants.back().view = without_end(b.text);
        } else if (base::begins_with(b.head, "its text ") && !d.variants.empty()) {
            d.variants.back().texts[scene_file(b.head.substr(9), files, where)] = b.text;
        } else if (kind == "text") {
            const size_t n = scene_file(name, files, where);
            d.texts[n].now = b.text;
            d.texts[n].version = 1;
            d.texts[n].before.resize(1);  // Undo brings back the text on the disk
            d.step({Design::Step::Of::text, n});
        } else {
            base::fail(where, "\"" + b.head + "\" is no part of a design");
        }
    }
    return d;
}

void offer_views(const std::vector<std::string>& files, Live& live) {
    for (const std::string& file : files) {
        const std::string view = view::to_options(view::read_view_file(file, "-view"));
        const std::string name = std::filesystem::path(file).stem().string();
        live.change([&](Design& d) {
            const auto known = [&](const auto& place) { return place.first == name; };
            if (std::none_of(d.places.begin(), d.places.end(), known)) d.places.emplace_back(name, view);
        });
    }
}

DesignFile::DesignFile(std::string path, const Files& files, Live& live)
    : path_(std::move(path)), files_(files), live_(live) {
    if (path_.empty()) return;
    const FileNow now = TextFile(path_, TextFile::Kind::scene, true).read();
    if (!now.trouble.empty()) base::fail(path_, now.trouble);
    if (now.tag == "none" || now.text.empty()) return;
    std::string regions;
    Design design = read_design(now.text, path_, files, regions);
    if (const TextFile* f = regions_among(files); f && f->writable && !regions.empty() && f->read().text.empty())
        f->write(regions, f->read().tag);
    design.reopened = !design.views.empty();
    design.given = false;
    live.change([&](Design& d) { d = std::move(design); });
    written_ = now.text;
}

void DesignFile::look(bool last) {
    if (path_.empty()) return;
    const Live::Numbers now = live_.numbers();
    if (!last && now.design == seen_.design && now.files == seen_.files) return;
    seen_ = now;
    const std::string regions = regions_in(files_);
    const std::string text =
        live_.ask([&](const Design& d) { return d.views.empty() ? "" : design_text(d, files_, regions); });
    if (text.empty() || text == written_) return;
    std::string wrong;
    try {
        image::write_bytes(path_, text);
        written_ = text;
    } catch (const base::Error& e) {
        wrong = "vcview: " + e.text + ": the design is not saved there";
        seen_.files = size_t(-1);  // tried again at the next look
    }
    if (!wrong.empty() && wrong != trouble_) live_.change([&](Design& d) { d.tell(wrong); });
    trouble_ = wrong;
}

}  // namespace live
