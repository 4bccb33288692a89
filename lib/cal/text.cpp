// SPDX-License-Identifier: BSD-3-Clause
// Polygonal fonts and the placing of characters (spec: scene language 5, text patterns).
// A file holds whole numbers; # begins a comment anywhere, also behind a number without a blank.
// Coordinates are 1/255 of a character cell; a glyph's extent starts from the middle of the cell, 128.
#include <algorithm>
#include <cmath>
#include "base/error.h"
#include "base/number.h"
#include "cal/tables.h"

namespace cal {

Font read_font(const std::string& path, const base::Opener& by) {
    const std::string &place = by.place, text = read_text(path, size_t(64) << 20, by);
    auto fail = [&](const std::string& fact) { base::fail(place, "font \"" + path + "\": " + fact); };
    size_t at = 0;
    auto blank = [&] { return static_cast<unsigned char>(text[at]) <= ' '; };
    auto next = [&](long long& v) {
        while (at < text.size() && (blank() || text[at] == '#'))
            at = text[at] == '#' ? std::min(text.find('\n', at), text.size()) : at + 1;
        const size_t from = at;
        while (at < text.size() && !blank() && text[at] != '#') at++;
        if (at == from) return false;
        if (!base::parse_integer(std::string_view(text).substr(from, at - from), v))
            fail("\"" + text.substr(from, std::min<size_t>(at - from, 40)) + "\" is not a number");
        return true;
    };
    Font font;
    font.glyphs.resize(256);
    long long code, n, v;
    int sum = 0, visible = 0;
    while (next(code)) {
        if (code < 1 || code > 255) fail("character codes are 1 to 255");
        Font::Glyph& g = font.glyphs[size_t(code)];
        if (g.defined) fail("character " + std::to_string(code) + " is defined twice");
        g.defined = true;
        if (!next(n) || n < 0 || n > 32000) fail("bad number of vertices of character " + std::to_string(code));
        for (long long i = 0; i < 2 * n; i++) {
            if (!next(v) || v < 0 || v > 255) fail("bad vertex of character " + std::to_string(code));
            g.vertices.push_back(int(v));
            if (i % 2 == 0) {
                g.left = std::min(g.left, int(v));
                g.right = std::max(g.right, int(v));
            }
        }
        if (g.right > g.left) {
            sum += g.right - g.left;
            visible++;
        }
    }
    if (visible) font.mean_width = sum / visible;
    return font;
}

namespace {

// Sections of proportional text end at a character followed by three blanks or more; in each the characters take as
// much room together as a line of even width would give them.
void even_out(const Font& font, const std::string& line, int spacing, std::vector<int>& a) {
    for (size_t from = 0; from < line.size();) {
        size_t to = from, blanks = 0;
        for (; to < line.size(); to++) {
            blanks = line[to] == ' ' ? blanks + 1 : 0;
            if (blanks >= 3 && (to + 1 == line.size() || line[to + 1] != ' ')) break;
        }
        to = std::min(to + 1, line.size());
        int room = 0;
        for (size_t i = from; i < to; i++) {
            if (font.glyphs[static_cast<unsigned char>(line[i])].defined) room += font.mean_width + spacing;
            room -= a[i + 1];
        }
        for (size_t i = from; i < to; i++) {
            const int share = room / int(to - i);
            a[i + 1] += share;
            room -= share;
        }
        from = to;
    }
}

}  // namespace

std::vector<int> text_advances(const Font& font, const std::string& line, int spacing) {
    std::vector<int> a;
    if (spacing == 0) {
        a.push_back(0);
        for (char c : line) a.push_back(font.glyphs[static_cast<unsigned char>(c)].defined ? 255 : 0);
        return a;
    }
    const int half = std::abs(spacing) / 2;
    int pending = half;
    for (char c : line) {
        const Font::Glyph& g = font.glyphs[static_cast<unsigned char>(c)];
        if (!g.defined) {
            a.push_back(0);
            continue;
        }
        if (g.right > g.left) {
            a.push_back(pending + half - g.left);
            pending = g.right + half;
        } else {
            a.push_back(pending);
            pending = font.mean_width;
        }
    }
    a.push_back(pending + half);
    if (spacing > 0) even_out(font, line, spacing, a);
    return a;
}

uint32_t text_table(const Font& font, const std::vector<std::string>& lines, int spacing, Code& code) {
    std::vector<uint32_t> glyph_at(256, 0);
    auto glyph = [&](unsigned char c) -> uint32_t {
        const Font::Glyph& g = font.glyphs[c];
        if (!g.defined || g.vertices.empty()) return 0;
        if (glyph_at[c] == 0) {
            if (code.words.empty()) code.words.push_back(0);  // index 0 means blank
            glyph_at[c] = uint32_t(code.words.size());
            code.words.push_back(uint32_t(g.vertices.size() / 2));
            for (int v : g.vertices) code.words.push_back(uint32_t(v));
        }
        return glyph_at[c];
    };
    std::vector<std::pair<uint32_t, uint32_t>> records;  // width, characters
    for (const std::string& line : lines) {
        const std::vector<int> a = text_advances(font, line, spacing);
        std::vector<uint32_t> characters;
        int start = 0;
        for (size_t i = 0; i < line.size(); i++) {
            start += a[i];
            const uint32_t g = glyph(static_cast<unsigned char>(line[i]));
            if (g) {
                characters.push_back(uint32_t(start));
                characters.push_back(g);
            }
        }
        records.emplace_back(uint32_t(start + a[line.size()]), uint32_t(code.words.size()));
        code.words.push_back(uint32_t(characters.size() / 2));
        code.words.insert(code.words.end(), characters.begin(), characters.end());
    }
    const uint32_t table = uint32_t(code.words.size());
    code.words.push_back(uint32_t(lines.size()));
    for (const auto& r : records) {
        code.words.push_back(r.first);
        code.words.push_back(r.second);
    }
    return table;
}

}  // namespace cal
