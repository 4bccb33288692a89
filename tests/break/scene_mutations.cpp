// SPDX-License-Identifier: BSD-3-Clause
// Ways to spoil text and binary files: see scene_mutations.h.
#include "scene_mutations.h"

#include <cstdlib>
#include <cstring>

#include "scene_words.h"

namespace breaking {
namespace {

std::string some_number(Dice& dice) {
    static const std::vector<std::string> special = choices(
        "0 -0 1 -1 2 3 4 7 12 .5 1e-30 1e-300 1e30 -1e30 1e300 1e400 nan inf -inf 2147483647 2147483648 "
        "4294967295 -2147483648 9223372036854775807 9223372036854775808 1000000 100000000 0x10 1e 1.2.3 "
        "--1 1e-7 .0000001 360 180 90 1.5708");
    if (dice.chance(.6)) return dice.pick(special);
    return std::to_string((dice.unit() - .5) * (dice.chance(.5) ? 4 : 400));
}

std::string some_word(const std::vector<std::string>& others, Dice& dice) {
    static const std::vector<std::string> special = choices(
        "void^alias^inherit^polygon^sphere^source^instance^mesh^mixfunc^colorpict^brighttext^BSDF^aBSDF^"
        "antimatter^mirror^prism2^mist^illum^spotlight^interface^spectrum^specfile^ring^cone^"
        "!genbox m b 1 1 1^!xform -a 9 -t 1 0 0 scene.rad^!xform -n x scene.rad^!gensky 6 21 12^"
        "!touch PWNED^!genworm m w 0 0 0 1 9^!gensurf m s u v 0 4 4^!genblinds m b .1 1 1 9 30^"
        "\n!genbox m b 1 1 1 | xform -rx 30\n^.^..^/^/dev/zero^/dev/null^~^-^scene.rad^Dx^Px^noop^$1^"
        "if(Dx,1,2)^sqrt(-1)^1/0^rand(Px)^f(x)=f(x);^{^}^(((((((((^#^%n%s^-exec^render= -exec -o PWNED^"
        "view= x -vtv -vf /dev/zero^RAYTRACE^*^-rx^-a^-i^-f^\x1b[31m^'^\"^\\^@scene.rad^$HOME",
        '^');
    if (dice.chance(.5)) return dice.pick(special);
    const std::string& from = dice.pick(others);
    const std::string part = from.substr(dice.below(from.size() + 1), 400);
    const auto words = words_of(part);
    if (words.empty()) return "void";
    const Stretch w = dice.pick(words);
    return part.substr(w.from, w.length);
}

using Change = void (*)(std::string&, const std::vector<std::string>&, Dice&);

template <class Text>
void replace_word(std::string& b, Dice& dice, Text text, bool numbers_only) {
    std::vector<Stretch> words = words_of(b);
    if (numbers_only) {
        std::vector<Stretch> numbers;
        for (const Stretch& w : words)
            if (std::strchr("0123456789.-+", b[w.from])) numbers.push_back(w);
        words = numbers;
    }
    if (words.empty()) return;
    const Stretch w = dice.pick(words);
    b.replace(w.from, w.length, text());
}

void number_to_number(std::string& b, const std::vector<std::string>&, Dice& d) {
    for (int i = d.within(1, 3); i > 0; --i)
        replace_word(
            b, d, [&] { return some_number(d); }, true);
}
void word_to_word(std::string& b, const std::vector<std::string>& o, Dice& d) {
    replace_word(
        b, d, [&] { return some_word(o, d); }, false);
}
// Mutations that leave a scene readable: so they reach what comes after the reader.
void real_to_real(std::string& b, const std::vector<std::string>&, Dice& d) {
    static const std::vector<std::string> values =
        choices("0 1 -1 -0 1e-30 1e30 -1e30 1e-7 1e7 1e300 1e-320 .5 360 180 1e18 -.0001 2 1e150 3e38 1e-45");
    for (int i = d.within(1, 4); i > 0; --i) {
        const auto all = primitives_of(b);
        if (all.empty()) return;
        const Primitive& p = d.pick(all);
        if (p.reals.empty()) continue;
        const Stretch w = d.pick(p.reals);
        b.replace(w.from, w.length, d.chance(.7) ? d.pick(values) : std::to_string((d.unit() - .5) * 20));
    }
}
void exchange_types(std::string& b, const std::vector<std::string>&, Dice& d) {
    static const std::vector<std::string> types = choices(
        "plastic metal trans plastic2 ashik2 dielectric interface glass light glow illum spotlight "
        "mirror mist sphere bubble polygon ring cone cup cylinder tube source antimatter colorfunc "
        "brightfunc mixfunc colordata spectrum");
    const auto all = primitives_of(b);
    if (all.empty()) return;
    const Stretch to = d.pick(all).type, from = d.pick(all).type;
    b.replace(to.from, to.length, d.chance(.5) ? b.substr(from.from, from.length) : d.pick(types));
}
void exchange_modifiers(std::string& b, const std::vector<std::string>&, Dice& d) {
    const auto all = primitives_of(b);
    if (all.empty()) return;
    const Primitive& to = d.pick(all);
    const Primitive& from = d.pick(all);
    const bool string = d.chance(.3) && !to.strings.empty();
    const Stretch place = string ? d.pick(to.strings) : to.modifier;
    b.replace(place.from, place.length, d.chance(.1) ? "void" : b.substr(from.name.from, from.name.length));
}

void drop_word(std::string& b, const std::vector<std::string>&, Dice& d) {
    replace_word(
        b, d, [] { return std::string(); }, false);
}
void add_word(std::string& b, const std::vector<std::string>& o, Dice& d) {
    const auto words = words_of(b);
    const size_t at = words.empty() ? 0 : d.pick(words).from;
    b.insert(at, (d.chance(.5) ? some_number(d) : some_word(o, d)) + (d.chance(.8) ? " " : ""));
}
void swap_words(std::string& b, const std::vector<std::string>&, Dice& d) {
    const auto words = words_of(b);
    if (words.size() < 2) return;
    const size_t i = d.below(words.size() - 1), j = i + 1 + d.below(words.size() - i - 1);
    const std::string first = b.substr(words[i].from, words[i].length),
                      second = b.substr(words[j].from, words[j].length);
    b.replace(words[j].from, words[j].length, first);
    b.replace(words[i].from, words[i].length, second);
}
void repeat_stretch(std::string& b, const std::vector<std::string>&, Dice& d) {
    const std::string part = b.substr(d.below(b.size() + 1), 1 + d.below(600));
    const size_t at = d.below(b.size() + 1);
    for (int i = d.chance(.1) ? d.within(2, 60) : 1; i > 0; --i) b.insert(at, part);
}
void remove_stretch(std::string& b, const std::vector<std::string>&, Dice& d) {
    b.erase(d.below(b.size() + 1), 1 + d.below(d.chance(.5) ? 8 : 400));
}
void take_stretch(std::string& b, const std::vector<std::string>& o, Dice& d) {
    const std::string& from = d.pick(o);
    b.insert(d.below(b.size() + 1), from.substr(d.below(from.size() + 1), 1 + d.below(500)));
}
void cut(std::string& b, const std::vector<std::string>&, Dice& d) { b.resize(d.below(b.size() + 1)); }
void flip_bits(std::string& b, const std::vector<std::string>&, Dice& d) {
    for (int i = d.within(1, 6); i > 0 && !b.empty(); --i) b[d.below(b.size())] ^= char(1 << d.below(8));
}
void noise(std::string& b, const std::vector<std::string>&, Dice& d) {
    for (int i = d.within(1, 12); i > 0; --i) b.insert(d.below(b.size() + 1), 1, char(d.next()));
}
void extreme_bytes(std::string& b, const std::vector<std::string>&, Dice& d) {  // counts and offsets of binary files
    static const std::vector<std::string> values{std::string(4, '\xff'),       std::string(4, '\0'), "\x7f\xff\xff\xff",
                                                 std::string("\x80\0\0\0", 4), "\xff\xff\xff\x7f",   "\xff"};
    const std::string& v = d.pick(values);
    if (b.size() >= v.size()) b.replace(d.below(b.size() - v.size() + 1), v.size(), v);
}
void long_word(std::string& b, const std::vector<std::string>&, Dice& d) {
    b.insert(d.below(b.size() + 1), std::string(size_t(d.within(1, 3000)), "x(0 -\n"[d.below(6)]));
}

struct Mutation {
    const char* name;
    Change apply;
};
// clang-format off
const std::vector<Mutation> readable{{"reals changed", real_to_real}, {"reals changed", real_to_real},
    {"type changed", exchange_types}, {"modifier changed", exchange_modifiers}};
const std::vector<Mutation> rude{
    {"numbers changed", number_to_number}, {"numbers changed", number_to_number}, {"word changed", word_to_word},
    {"word dropped", drop_word}, {"word added", add_word}, {"words swapped", swap_words}, {"long word", long_word},
    {"stretch repeated", repeat_stretch}, {"stretch removed", remove_stretch}, {"cut", cut},
    {"stretch of another file", take_stretch}, {"bits flipped", flip_bits}, {"noise", noise},
    {"extreme bytes", extreme_bytes}};
// clang-format on

}  // namespace

std::string mutate_file(std::string& bytes, const std::vector<std::string>& others, Dice& dice) {
    const Mutation& m = dice.pick(dice.chance(.5) ? readable : rude);
    m.apply(bytes, others, dice);
    return m.name;
}

std::string respace(const std::string& scene, Dice& dice) {
    static const std::vector<std::string> rooms = choices(" |\t|\n|\n\n|  \n\t|\r\n", '|');
    std::string out = "# a comment\n";
    for (size_t at = 0; at < scene.size();) {
        size_t end = scene.find('\n', at);
        if (end == std::string::npos) end = scene.size();
        const std::string line = scene.substr(at, end - at);
        at = end + 1;
        const bool kept = line.find_first_of("!#'\"") != std::string::npos || line.find('\\') != std::string::npos;
        if (kept) {
            out += "\n" + line + "\n";
            continue;
        }
        for (const Stretch& w : words_of(line)) out += line.substr(w.from, w.length) + dice.pick(rooms);
    }
    return out + "\n# the end";
}

}  // namespace breaking
