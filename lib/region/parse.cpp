// SPDX-License-Identifier: BSD-3-Clause
// The region file: one region a line, "name expression"; indented lines continue the one above; # starts a comment.
//   expression: term { (+ | -) term }     term: factor { & factor }     factor: !factor | (expression) | shape | name
// + union, - difference, & intersection, ! complement.  + and - need blanks around them (names may hold '-').
// A name stands for a region above it, so there are no cycles.
#include <cctype>
#include <iostream>
#include <iterator>
#include <fmt/format.h>
#include "base/angle.h"
#include "base/error.h"
#include "base/text_file.h"
#include "region/region.h"
#include "region/tokens.h"

namespace region {
namespace {

struct Keyword {
    const char* name;
    Kind kind;
};
const Keyword keywords[] = {
    {"polygon3d", Kind::polygon3d}, {"disc3d", Kind::disc3d},     {"box3d", Kind::box3d},
    {"sphere3d", Kind::sphere3d},   {"circle", Kind::circle},     {"rect", Kind::rect},
    {"polygon", Kind::polygon},     {"mask", Kind::mask},         {"zone", Kind::zone},
    {"surface", Kind::surface},     {"modifier", Kind::modifier},
};
const Keyword* find_keyword(const std::string& word) {
    for (const Keyword& k : keywords)
        if (word == k.name) return &k;
    return nullptr;
}
bool reserved(const std::string& word) { return find_keyword(word) || word == "within"; }

bool is_name(const std::string& word) {
    for (unsigned char c : word)
        if (!(c < 128 && (std::isalnum(c) || c == '_' || c == '-'))) return false;
    return !word.empty() && word != "-";
}

class RegionParser {
public:
    RegionParser(Regions& out, std::vector<Token> tokens) : out_(out), tokens_(std::move(tokens)) {}

    void region() {
        Token name = tokens_[at_++];
        if (!is_name(name.text))
            fail(name, fmt::format("\"{}\" is not a region name (letters, digits, _ and -)", name.text));
        if (name.text.size() > 63) fail(name, "a region name has at most 63 letters");
        if (reserved(name.text))
            fail(name, fmt::format("\"{}\" is the name of a shape; a line is: name shape ...", name.text));
        for (const Region& r : out_.regions)
            if (r.name == name.text)
                fail(name, fmt::format("region \"{}\" is defined already ({})", name.text, r.place));
        if (more() && peek("=")) ++at_;
        if (!more()) fail(name, fmt::format("region \"{}\" has no shape", name.text));
        int root = expression();
        if (more()) fail(next(), fmt::format("unexpected \"{}\"{}", next().text, hint(next().text)));
        out_.regions.push_back({name.text, place(name), root});
    }

private:
    int expression() {
        int a = term();
        while (more() && (peek("+") || peek("-"))) {
            char op = tokens_[at_++].text[0];
            a = add({op, a, term()});
        }
        return a;
    }
    int term() {
        int a = factor();
        while (more() && peek("&")) {
            ++at_;
            a = add({'&', a, factor()});
        }
        return a;
    }
    int factor() {
        if (++depth_ > 200) fail(last(), "nested too deeply");
        const int result = factor_at_depth();
        --depth_;
        return result;
    }
    int factor_at_depth() {
        Token t = take("a shape, a region name, ! or (");
        if (!t.quoted && t.text == "!") return add({'!', factor()});
        if (!t.quoted && t.text == "(") {
            int a = expression();
            if (!more() || !peek(")")) fail(more() ? next() : last(), "a parenthesis is not closed");
            ++at_;
            return a;
        }
        if (find_keyword(t.text) && !t.quoted) return add({'s', shape(t)});
        std::vector<std::string> known;
        for (const Region& r : out_.regions) {
            if (r.name == t.text) return r.root;
            known.push_back(r.name);
        }
        for (const Keyword& k : keywords) known.push_back(k.name);
        fail(t, fmt::format("\"{}\" is neither a shape nor a region defined above{}{}", t.text,
                            near_matches(t.text, known), hint(t.text)));
    }

    int shape(const Token& word) {
        Shape s{find_keyword(word.text)->kind, Frame::pixel, {}, "", "", place(word)};
        switch (s.kind) {
        case Kind::polygon3d: numbers(word, s, 9, -1, 3); break;
        case Kind::disc3d:
            numbers(word, s, 7, 7);
            check(word, s.numbers[6] > 0, "the radius must be positive");
            break;
        case Kind::sphere3d:
            numbers(word, s, 4, 4);
            check(word, s.numbers[3] > 0, "the radius must be positive");
            break;
        case Kind::box3d: numbers(word, s, 6, 6); break;
        case Kind::circle: circle(word, s); break;
        case Kind::rect:
            frame(s, false);
            numbers(word, s, 4, 4);
            break;
        case Kind::polygon:
            frame(s, true);
            if (s.frame == Frame::direction) {
                s.kind = Kind::polygon_direction;
                numbers(word, s, 9, -1, 3);
            } else {
                numbers(word, s, 6, -1, 2);
            }
            break;
        case Kind::mask: mask(s); break;
        case Kind::zone: zone(word, s); break;
        case Kind::surface:
        case Kind::modifier: query(word, s); break;
        case Kind::polygon_direction: break;  // written "polygon direction"
        }
        if (s.kind == Kind::disc3d)
            check(word, s.numbers[3] != 0 || s.numbers[4] != 0 || s.numbers[5] != 0, "the normal is zero");
        out_.shapes.push_back(s);
        return int(out_.shapes.size()) - 1;
    }

    // circle [direction x y z | point x y z | pixel x y | fraction x y | view] full-angle; bare numbers: 3 + 1 a
    // direction, 2 + 1 a pixel
    void circle(const Token& word, Shape& s) {
        bool named = true;
        if (optional("direction")) s.frame = Frame::direction;
        else if (optional("point")) s.frame = Frame::point;
        else if (optional("pixel")) s.frame = Frame::pixel;
        else if (optional("fraction")) s.frame = Frame::fraction;
        else if (optional("view")) s.frame = Frame::view;
        else named = false;
        numbers(word, s, -1, -1, 1, true);
        if (!named) s.frame = s.numbers.size() == 4 ? Frame::direction : Frame::pixel;
        size_t want = s.frame == Frame::view ? 1 : s.frame == Frame::direction || s.frame == Frame::point ? 4 : 3;
        if (s.numbers.size() != want)
            fail(word,
                 named
                     ? fmt::format("circle needs {} numbers here, not {}", want, s.numbers.size())
                     : fmt::format(
                           "circle needs a direction (x y z) or a pixel (x y), then its full angle; it has {} numbers",
                           s.numbers.size()));
        double angle = s.numbers.back();
        check(word, angle > 0 && angle <= 360, "the angle must be above 0 and at most 360 degrees");
        if (s.frame == Frame::direction)
            check(word, s.numbers[0] != 0 || s.numbers[1] != 0 || s.numbers[2] != 0, "the direction is zero");
    }
    void mask(Shape& s) {
        s.text = take("the name of a picture").text;
        if (s.text.size() > 0 && s.text[0] != '/') {
            size_t slash = out_.file.rfind('/');
            if (slash != std::string::npos) s.text = out_.file.substr(0, slash + 1) + s.text;
        }
        if (optional("channel")) s.channel = take("a channel name").text;
    }
    void zone(const Token& word, Shape& s) {
        Token t = take("central, ergorama, panorama, total, binocular or position");
        s.text = t.text;
        if (s.text == "central") {
            numbers(word, s, -1, -1, 1, true);
            if (s.numbers.empty()) s.numbers = {30};
            check(word, s.numbers.size() == 1, "zone central takes one angle");
            check(word, s.numbers[0] > 0 && s.numbers[0] <= 360, "the angle must be above 0 and at most 360 degrees");
        } else if (s.text == "position") {
            numbers(word, s, 2, 2);
            check(word, s.numbers[0] < s.numbers[1], "zone position needs two position indices, the lower one first");
        } else if (s.text == "ergorama" || s.text == "panorama" || s.text == "total" || s.text == "binocular") {
        } else {
            fail(t, fmt::format(
                        "there is no zone \"{}\"{}", t.text,
                        near_matches(t.text, {"central", "ergorama", "panorama", "total", "binocular", "position"})));
        }
    }
    void query(const Token& word, Shape& s) {
        s.text = take(fmt::format("the name of a {}", word.text)).text;
        if (!optional("within")) return;
        Token t = take("box3d or sphere3d");
        const Keyword* k = find_keyword(t.text);
        if (!k || (k->kind != Kind::box3d && k->kind != Kind::sphere3d))
            fail(t, fmt::format("within takes box3d or sphere3d, not \"{}\"", t.text));
        s.within = shape(t);
    }
    void frame(Shape& s, bool directions) {
        if (optional("fraction")) s.frame = Frame::fraction;
        else if (directions && optional("direction")) s.frame = Frame::direction;
        else optional("pixel");
    }

    // Reads numbers up to the next word; at least `low` (-1: any), at most `high`, a multiple of `group`.
    void numbers(const Token& word, Shape& s, int low, int high, int group = 1, bool angle_last = false) {
        double value;
        std::string unit;
        while (more() && !next().quoted && is_number(next().text, value, &unit)) {
            if (angle_last && unit == "rad") value *= 180 / base::pi;
            else if (!(unit.empty() || (angle_last && unit == "deg"))) break;
            s.numbers.push_back(value);
            ++at_;
            if (!unit.empty()) break;  // an angle is the last number
        }
        int n = int(s.numbers.size());
        if (low == high && low >= 0 && n != low) {
            bool text = more() && n < low && !peek("+") && !peek("-") && !peek("&") && !peek(")");
            fail(text ? next() : word,
                 text ? fmt::format("{} needs {} numbers; number {} is \"{}\"", word.text, low, n + 1, next().text)
                      : fmt::format("{} needs {} numbers, not {}", word.text, low, n));
        }
        if (n < low)
            fail(word, fmt::format("{} needs at least {} points; it has {} numbers", word.text, low / group, n));
        if (n % group) fail(word, fmt::format("{} has {} numbers, which is not a multiple of {}", word.text, n, group));
    }

    int add(Node n) {  // the tree that is walked for every pixel stays finite, however often names are used
        int64_t size = 1;
        if (n.op != 's') size += out_.nodes[size_t(n.a)].size + (n.b >= 0 ? out_.nodes[size_t(n.b)].size : 0);
        if (size > 10000) fail(tokens_[at_ > 0 ? at_ - 1 : 0], "the region is made of more than 10000 parts");
        n.size = int(size);
        out_.nodes.push_back(n);
        return int(out_.nodes.size()) - 1;
    }
    bool more() const { return at_ < tokens_.size(); }
    const Token& next() const { return tokens_[at_]; }
    const Token& last() const { return tokens_.back(); }
    bool peek(const char* word) const { return !next().quoted && next().text == word; }
    bool optional(const char* word) {
        if (!more() || !peek(word)) return false;
        ++at_;
        return true;
    }
    Token take(const std::string& what) {
        if (!more()) fail(last(), fmt::format("the line ends where {} should be", what));
        return tokens_[at_++];
    }
    void check(const Token& t, bool good, const char* fact) const {
        if (!good) fail(t, fact);
    }
    static std::string hint(const std::string& word) {
        return word.find_first_of("+-") != std::string::npos && word.size() > 1 ? "; + and - need blanks around them"
                                                                                : "";
    }
    std::string place(const Token& t) const { return fmt::format("{}:{}", out_.file, t.line); }
    [[noreturn]] void fail(const Token& t, const std::string& fact) const { base::fail(place(t), fact); }

    Regions& out_;
    std::vector<Token> tokens_;
    size_t at_ = 0;
    int depth_ = 0;
};

}  // namespace

Regions parse(const std::string& text, const std::string& file, bool may_be_empty) {
    Regions out;
    out.file = file;
    size_t nul = text.find('\0');
    if (nul != std::string::npos) base::fail(file, "is not a text file");
    for (auto& tokens : split_regions(text, file)) RegionParser(out, std::move(tokens)).region();
    if (out.regions.empty() && !may_be_empty) base::fail(file, "holds no region");
    return out;
}

std::vector<std::string> mask_files(const Regions& regions) {
    std::vector<std::string> files;
    for (const Shape& s : regions.shapes)
        if (s.kind == Kind::mask) files.push_back(s.text);
    return files;
}

Regions read(const std::string& path, bool may_be_empty) {
    if (path == "-") return parse(std::string(std::istreambuf_iterator<char>(std::cin), {}), "stdin", may_be_empty);
    constexpr size_t limit = 64u << 20;  // a text of regions, not a picture given by mistake
    return parse(base::read_text_file(path, limit), path, may_be_empty);
}

}  // namespace region
