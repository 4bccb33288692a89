// SPDX-License-Identifier: BSD-3-Clause
// Trials of break_files with region files: an expression drawn at random, the same set written in another way (A + B is
// B + A, A - B is A & !B, De Morgan's laws, blanks, comments, continuation lines), and a spoiled file.  The areas of
// one set are the same however it is written; of a spoiled file nothing is expected but an end in time and areas that a
// picture can have.
#include <cmath>
#include <cstdio>
#include <memory>
#include <sstream>

#include "file_trials.h"

namespace breaking {
namespace {

constexpr int side = 24;

struct Expression {
    char op = 's';  // s + - & !
    std::string shape;
    std::shared_ptr<Expression> a, b;
};
using Node = std::shared_ptr<Expression>;

Node make(char op, Node a, Node b = nullptr) { return std::make_shared<Expression>(Expression{op, "", a, b}); }

std::string number(Dice& dice, double from, double to) {
    char text[32];
    std::snprintf(text, sizeof text, dice.chance(.2) ? "%.0f" : "%.3f", from + (to - from) * dice.unit());
    return text;
}

std::string numbers(Dice& dice, int count, double from, double to) {
    std::string text;
    for (int i = 0; i < count; ++i) text += " " + number(dice, from, to);
    return text;
}

std::string a_shape(Dice& dice) {
    const int corners = dice.within(3, 6);
    switch (dice.below(16)) {
    case 0: return "circle view " + number(dice, 5, 150);
    case 1: return "circle" + numbers(dice, 3, -1, 1) + " " + number(dice, 5, 120);
    case 2: return "circle fraction" + numbers(dice, 2, .1, .9) + " " + number(dice, 5, 90);
    case 3: return "circle pixel" + numbers(dice, 2, 2, side - 2) + " " + number(dice, .1, 1.5) + "rad";
    case 4: return "circle point" + numbers(dice, 3, -3, 3) + " " + number(dice, 5, 90);
    case 5: return "rect fraction" + numbers(dice, 4, 0, 1);
    case 6: return "rect" + numbers(dice, 4, -3, side + 3);
    case 7: return "polygon fraction" + numbers(dice, 2 * corners, 0, 1);
    case 8: return "polygon" + numbers(dice, 2 * corners, -3, side + 3);
    case 9: return "zone " + dice.pick(choices("central ergorama panorama binocular total"));
    case 10: return "zone position 1 " + number(dice, 1.5, 12);
    case 11: return "sphere3d" + numbers(dice, 3, -3, 3) + " " + number(dice, .2, 2);
    case 12: return "disc3d" + numbers(dice, 6, -3, 3) + " " + number(dice, .5, 4);
    case 13: return "box3d" + numbers(dice, 6, -4, 4);
    case 14: return dice.chance(.5) ? "mask m.hdr" : "mask wide.hdr";
    default: return "polygon direction 1 1 0  -1 1 " + number(dice, -.5, .5) + "  0 1 1";
    }
}

Node an_expression(Dice& dice, int depth) {
    if (depth == 0 || dice.chance(.2)) return std::make_shared<Expression>(Expression{'s', a_shape(dice), {}, {}});
    const char op = "+-&!"[dice.below(4)];
    const Node a = an_expression(dice, depth - 1);
    return make(op, a, op == '!' ? nullptr : an_expression(dice, depth - 1));
}

// The same set by other words.
Node rewritten(const Node& e, Dice& dice) {
    if (e->op == 's') return dice.chance(.2) ? make('+', e, e) : dice.chance(.2) ? make('&', e, e) : e;
    const Node a = rewritten(e->a, dice), b = e->b ? rewritten(e->b, dice) : nullptr;
    const bool other = dice.chance(.6);
    if (e->op == '!' && a->op == '+' && other) return make('&', make('!', a->a), make('!', a->b));
    if (e->op == '!') return make('!', a);
    if (e->op == '-') return other ? make('&', a, make('!', b)) : make('-', a, b);
    return other ? make(e->op, b, a) : make(e->op, a, b);
}

std::string gap(Dice& dice) {
    static const std::vector<std::string> gaps = {" ", "  ", "\t", " # a comment - ( & 1e9\n ", "\n  ", "\r\n\t"};
    return dice.chance(.8) ? " " : dice.pick(gaps);
}

std::string written(const Node& e, Dice& dice) {
    if (e->op == 's') return e->shape;
    if (e->op == '!') return "!(" + gap(dice) + written(e->a, dice) + ")";
    return "(" + written(e->a, dice) + gap(dice) + e->op + gap(dice) + written(e->b, dice) + gap(dice) + ")";
}

std::string mask(Dice& dice, int width, int height) {
    std::string bytes =
        "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) + " +X " + std::to_string(width) + "\n";
    for (int i = 0; i < width * height; ++i)
        bytes += dice.chance(.5) ? std::string("\xff\xff\xff\x80", 4) : std::string(4, '\0');
    return bytes;
}

void spoil(std::string& text, Dice& dice) {
    static const std::vector<std::string> words = choices(
        "( ) & + - ! nan inf -1 0 1e999 1e30 -1e30 1,5 0x7 mask zone circle within surface r a all .. / \" ' \\ = # "
        "\n \t \x01 \x7f \xff channel pixel fraction point view 999999999 1rad radrad 2147483648 disc3d polygon3d");
    for (int i = dice.within(1, 3); i > 0; --i) {
        const size_t at = dice.below(text.size() + 1);
        switch (dice.below(4)) {
        case 0: text.insert(at, " " + dice.pick(words) + " "); break;
        case 1: text.erase(at, 1 + dice.below(12)); break;
        case 2: text.insert(at, text.substr(dice.below(text.size() + 1), dice.below(60))); break;
        default:
            if (at < text.size()) text.replace(at, 1, dice.pick(words));
        }
    }
}

// name -> pixels of a table of vcregion -list
std::vector<double> pixels_in(const std::string& table) {
    std::vector<double> all;
    std::istringstream in(table);
    std::string line, name;
    std::getline(in, line);
    while (std::getline(in, line)) {
        std::istringstream words(line);
        double pixels = NAN;
        words >> name >> pixels;
        all.push_back(pixels);
    }
    return all;
}

}  // namespace

Verdict try_regions(const Settings& s, Dice& dice, const std::string& folder) {
    write_file(folder + "/m.hdr", mask(dice, side, side));
    write_file(folder + "/wide.hdr", mask(dice, dice.within(1, 40), dice.within(1, 40)));
    const Node e = an_expression(dice, dice.within(1, 3)), f = rewritten(e, dice);
    std::string first = "r (" + written(e, dice) + ") & " + "!rect -1 -1 0 0\n";
    std::string second = "r (" + written(f, dice) + ") & " + "!rect -1 -1 0 0\n";
    const bool spoils = dice.chance(.5);
    if (spoils) spoil(second, dice);
    write_file(folder + "/first.txt", first);
    write_file(folder + "/second.txt", second);
    const std::vector<std::string> views = {"-vta -vh 180 -vv 180", "-vtv -vh 80 -vv 80",  "-vth -vh 180 -vv 180",
                                            "-vtl -vh 4 -vv 4",     "-vtc -vh 360 -vv 90", "-vta -vh 360 -vv 360"};
    std::vector<std::string> words = choices(dice.pick(views) + " -vp 0 -4 0 -vd 0 1 0 -x 24 -y 24 -pa 0 -list");
    if (dice.chance(.3)) words.push_back("-centre");
    std::vector<std::string> again = words;
    words.push_back("first.txt");
    again.push_back("second.txt");
    const Result a = run_tool(s, folder, "vcregion", words), b = run_tool(s, folder, "vcregion", again);
    Verdict v;
    for (const std::string& word : words) v.story += word + " ";
    v.story += "\n" + first + a.describe() + a.out + second + b.describe() + b.out;
    const int status = a.stages[0].status, other = b.stages[0].status;
    v.outcome = std::string(spoils ? "regions, spoiled" : "regions") + ": status " + std::to_string(other);
    v.find = complaint(a);
    if (v.find.empty()) v.find = complaint(b);
    if (!v.find.empty()) return v;
    for (const Result* r : {&a, &b})
        for (double pixels : pixels_in(r->out))
            if (!(pixels >= 0 && pixels <= side * side + .01)) v.find = "more or less pixels than a picture can have";
    if (!v.find.empty() || spoils) return v;
    if (status != other) v.find = "one way to write a set is refused, another is not";
    const std::vector<double> p = pixels_in(a.out), q = pixels_in(b.out);
    if (p.size() != q.size()) v.find = "tables of other lengths";
    for (size_t k = 0; v.find.empty() && k < p.size(); ++k)
        if (std::fabs(p[k] - q[k]) > .02) v.find = "one set has two areas";
    return v;
}

}  // namespace breaking
