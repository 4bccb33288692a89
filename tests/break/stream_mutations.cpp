// SPDX-License-Identifier: BSD-3-Clause
// Ways to spoil a stream: whole pictures, lines of headers, numbers, pixels, bytes.
#include "stream_mutations.h"

#include <cstring>
#include <functional>

#include "stream_model.h"

namespace breaking {
namespace {

using Piece = Pieces::Piece;
using Others = std::vector<std::string>;

struct Mutation {
    const char* name;
    std::function<void(Pieces&, const Others&, Dice&)> apply;
};

Piece& some(Pieces& p, Dice& dice) { return p.all[dice.below(p.all.size())]; }

// --- pictures

void drop(Pieces& p, const Others&, Dice& dice) { p.all.erase(p.all.begin() + long(dice.below(p.all.size()))); }

void twice(Pieces& p, const Others&, Dice& dice) {
    const Piece again = some(p, dice);
    p.all.insert(p.all.begin() + long(dice.below(p.all.size() + 1)), again);
}

void swap_two(Pieces& p, const Others&, Dice& dice) { std::swap(some(p, dice), some(p, dice)); }

void reverse(Pieces& p, const Others&, Dice&) { p.all.assign(p.all.rbegin(), p.all.rend()); }

void end_early(Pieces& p, const Others&, Dice& dice) { p.all.resize(dice.below(p.all.size())); }

void begin_late(Pieces& p, const Others&, Dice& dice) {
    p.all.erase(p.all.begin(), p.all.begin() + long(dice.below(p.all.size())));
}

void splice(Pieces& p, const Others& others, Dice& dice) {
    Pieces from = cut_into_pictures(dice.pick(others));
    Piece& place = some(p, dice);
    place = some(from, dice);
}

void append(Pieces& p, const Others& others, Dice& dice) {
    for (const Piece& piece : cut_into_pictures(dice.pick(others)).all) p.all.push_back(piece);
}

// --- headers

std::vector<std::string> lines_of(const Piece& piece) {
    std::vector<std::string> lines;
    size_t at = 0;
    for (size_t end; at < piece.pixels && (end = piece.bytes.find('\n', at)) != std::string::npos; at = end + 1)
        lines.push_back(piece.bytes.substr(at, end - at));
    return lines;
}

void set_lines(Piece& piece, const std::vector<std::string>& lines) {
    std::string header;
    for (const std::string& line : lines) header += line + "\n";
    piece.bytes.replace(0, piece.pixels, header);
    piece.pixels = header.size();
}

std::string some_line(Dice& dice) {
    static const std::vector<std::string> known = choices(
        "EXPOSURE=2|EXPOSURE=1e308|EXPOSURE=1e-300|EXPOSURE=0|EXPOSURE=nan|COLORCORR=1 2 .5|"
        "COLORCORR=1e200 1 1|PIXASPECT=2|PIXASPECT=1e-300|NCOMP=1|NCOMP=4|NCOMP=1000000|BigEndian=1|"
        "FORMAT=32-bit_rle_rgbe|FORMAT=32-bit_rle_xyze|FORMAT=float|FORMAT=double|NROWS=8|NCOLS=100000|"
        "PRIMARIES=.7 .3 .2 .7 .1 .1 .33 .33|PRIMARIES=0 0 0 0 0 0 0 0|SEED=1|SEED=18446744073709551615|"
        "FRAME=0|FRAME=1|FRAME=9223372036854775807|FRAMES=0|FRAMES=3|FRAMES=9223372036854775807|"
        "RANGE=0:3|RANGE=0:9223372036854775807|RANGE=1:1|VIEW= -vtv -vh 40|VIEW= -vta -vd 0 0 0|"
        "\tVIEW= -vtl|rpict -vp 1 2 3|\tEXPOSURE=4|WAVELENGTH_SPLITS= 380 480 588 780|\x1b[31m red|",
        '|');
    if (dice.chance(.05)) return std::string(size_t(dice.within(1, 70000)), 'x');
    return dice.pick(known);
}

void add_line(Pieces& p, const Others&, Dice& dice) {
    Piece& piece = some(p, dice);
    auto lines = lines_of(piece);
    lines.insert(lines.begin() + long(dice.below(lines.size() + 1)), some_line(dice));
    set_lines(piece, lines);
}

void remove_line(Pieces& p, const Others&, Dice& dice) {
    Piece& piece = some(p, dice);
    auto lines = lines_of(piece);
    if (!lines.empty()) lines.erase(lines.begin() + long(dice.below(lines.size())));
    set_lines(piece, lines);
}

void repeat_line(Pieces& p, const Others&, Dice& dice) {
    Piece& piece = some(p, dice);
    auto lines = lines_of(piece);
    if (lines.empty()) return;
    const std::string line = dice.pick(lines);
    lines.insert(lines.begin() + long(dice.below(lines.size())), line);
    set_lines(piece, lines);
}

void same_line_everywhere(Pieces& p, const Others&, Dice& dice) {
    const std::string line = some_line(dice);
    for (Piece& piece : p.all) {
        auto lines = lines_of(piece);
        if (!lines.empty()) lines.insert(lines.begin() + 1, line);
        set_lines(piece, lines);
    }
}

// A number of a header becomes another one.
void change_number(Pieces& p, const Others&, Dice& dice) {
    static const std::vector<std::string> numbers = choices(
        "0 1 -1 2 3 4 5 17 32768 32769 2147483648 9223372036854775807 9223372036854775808 "
        "18446744073709551616 1e30 1e-30 1e400 nan inf -0 0x10 ");
    Piece& piece = some(p, dice);
    std::vector<std::pair<size_t, size_t>> found;
    for (size_t i = 0; i < piece.pixels; ++i) {
        const size_t begin = i;
        while (i < piece.pixels && std::strchr("0123456789.", piece.bytes[i]) && piece.bytes[i]) ++i;
        if (i > begin) found.push_back({begin, i - begin});
    }
    if (found.empty()) return;
    const auto [from, length] = dice.pick(found);
    const std::string number = dice.pick(numbers);
    piece.bytes.replace(from, length, number);
    piece.pixels += number.size() - length;
}

// --- pixels and bytes

void flip_pixels(Pieces& p, const Others&, Dice& dice) {
    Piece& piece = some(p, dice);
    for (int i = dice.within(1, 8); i > 0 && piece.pixels < piece.bytes.size(); --i)
        piece.bytes[piece.pixels + dice.below(piece.bytes.size() - piece.pixels)] ^= char(1 << dice.below(8));
}

void special_pixel(Pieces& p, const Others&, Dice& dice) {
    static const std::vector<uint32_t> values{0x7f800000, 0xff800000, 0x7fc00000, 0xffffffff, 0x7f7fffff,
                                              0xff7fffff, 0x80000000, 0x00000001, 0x7f000000, 0x501502f9};
    Piece& piece = some(p, dice);
    const size_t pixels = (piece.bytes.size() - piece.pixels) / 4;
    for (int i = dice.within(1, 4); i > 0 && pixels; --i) {
        const uint32_t value = dice.pick(values);
        std::memcpy(&piece.bytes[piece.pixels + 4 * dice.below(pixels)], &value, 4);
    }
}

void flip_header(Pieces& p, const Others&, Dice& dice) {
    Piece& piece = some(p, dice);
    if (piece.pixels) piece.bytes[dice.below(piece.pixels)] ^= char(1 << dice.below(8));
}

void on_bytes(Pieces& p, const std::function<void(std::string&)>& change) {
    std::string bytes = p.joined();
    change(bytes);
    p = cut_into_pictures(bytes);
}

void cut(Pieces& p, const Others&, Dice& dice) {
    on_bytes(p, [&](std::string& b) { b.resize(dice.below(b.size() + 1)); });
}

void cut_begin(Pieces& p, const Others&, Dice& dice) {
    on_bytes(p, [&](std::string& b) { b.erase(0, dice.below(b.size() + 1)); });
}

void remove_bytes(Pieces& p, const Others&, Dice& dice) {
    on_bytes(p, [&](std::string& b) { b.erase(dice.below(b.size() + 1), 1 + dice.below(dice.chance(.5) ? 8 : 4000)); });
}

void repeat_bytes(Pieces& p, const Others&, Dice& dice) {
    on_bytes(p, [&](std::string& b) {
        const std::string part = b.substr(dice.below(b.size() + 1), 1 + dice.below(4000));
        b.insert(dice.below(b.size() + 1), part);
    });
}

void insert_noise(Pieces& p, const Others&, Dice& dice) {
    on_bytes(p, [&](std::string& b) {
        std::string noise;
        for (int i = dice.within(1, 20); i > 0; --i) noise += char(dice.next());
        b.insert(dice.chance(.3) ? b.size() : dice.below(b.size() + 1), noise);
    });
}

void flip_anywhere(Pieces& p, const Others&, Dice& dice) {
    on_bytes(p, [&](std::string& b) {
        for (int i = dice.within(1, 30); i > 0 && !b.empty(); --i) b[dice.below(b.size())] ^= char(1 << dice.below(8));
    });
}

// clang-format off
const std::vector<Mutation> mutations{
    {"picture dropped", drop}, {"picture twice", twice}, {"pictures swapped", swap_two}, {"order reversed", reverse},
    {"ends early", end_early}, {"begins late", begin_late}, {"picture of another stream", splice},
    {"another stream appended", append}, {"header line added", add_line}, {"header line removed", remove_line},
    {"header line repeated", repeat_line}, {"same line in all headers", same_line_everywhere},
    {"header number changed", change_number}, {"pixels flipped", flip_pixels}, {"special pixels", special_pixel},
    {"header bit flipped", flip_header}, {"cut", cut}, {"begin cut off", cut_begin}, {"bytes removed", remove_bytes},
    {"bytes repeated", repeat_bytes}, {"noise inserted", insert_noise}, {"bits flipped anywhere", flip_anywhere}};
// clang-format on

}  // namespace

std::string Pieces::joined() const {
    std::string bytes;
    for (const Piece& piece : all) bytes += piece.bytes;
    return bytes;
}

// Pictures begin with "#?RADIANCE"; pixels after the line that follows the empty one.
Pieces cut_into_pictures(const std::string& stream) {
    Pieces p;
    for (size_t at = 0; at < stream.size();) {
        size_t end = stream.find("#?RADIANCE\n", at + 1);
        if (end == std::string::npos) end = stream.size();
        Piece piece{stream.substr(at, end - at), 0};
        const size_t empty = piece.bytes.find("\n\n");
        const size_t size_end = empty == std::string::npos ? empty : piece.bytes.find('\n', empty + 2);
        piece.pixels = size_end == std::string::npos ? piece.bytes.size() : size_end + 1;
        p.all.push_back(std::move(piece));
        at = end;
    }
    if (p.all.empty()) p.all.push_back({});
    return p;
}

std::string mutate_stream(std::string& stream, const Others& others, Dice& dice) {
    Pieces pieces = cut_into_pictures(stream);
    const Mutation& m = dice.pick(mutations);
    m.apply(pieces, others, dice);
    stream = pieces.joined();
    return m.name;
}

}  // namespace breaking
