// SPDX-License-Identifier: BSD-3-Clause
// Header lines of RADIANCE pictures and the lines of our streams (man/luxpipe-stream.5).
// Keys are case sensitive and begin their line; a line that begins with a tab is history of an input.
#include "image/header.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>

#include "base/error.h"
#include "base/number.h"
#include "base/split.h"

namespace image {
namespace {

constexpr int64_t most_hours = 366 * 1440;  // lines of a weather file
constexpr int most_action_bands = 1000;
constexpr size_t longest_kept = 2040;  // RADIANCE reads lines of at most 2047 characters

// A line whose key is known: what follows the key, and where it goes.
struct Field {
    const std::string &line, text, &where;
    Header& h;
    Encoding& e;
};
using F = const Field&;

[[noreturn]] void fail(F f, const std::string& fact) { base::fail(f.where, "header line \"" + f.line + "\"" + fact); }

// What stands behind the key.
std::string value_of(const std::string& line, size_t key) {
    const size_t from = line.find_first_not_of(' ', key);
    return from == std::string::npos ? "" : line.substr(from, line.find_last_not_of(" \t\r") + 1 - from);
}

// Reads exactly the numbers asked for; anything else is an error of the line.
template <size_t n>
std::array<double, n> numbers(F f) {
    std::array<double, n> all{};
    const std::vector<std::string> words = base::split_words(f.text);
    bool good = words.size() == n;
    for (size_t i = 0; good && i < n; ++i) good = base::parse_real(words[i], all[i]);
    if (!good) fail(f, " is malformed");
    return all;
}

// Times what such lines before it have given.  A product that no float could hold would leave only 0 and infinity.
void multiply(double& product, double factor, F f) {
    if (!(factor > 0)) fail(f, " is not above 0");
    product *= factor;
    if (!(product >= 1e-30 && product <= 1e30)) fail(f, fmt::format(": {:g} is not within 1e-30 to 1e30", product));
}

// Integers may exceed a double's 53 bits (seeds).
template <class Int>
Int integer(F f, const std::string& text) {
    Int value{};
    const char *first = text.data(), *const last = first + text.size();
    while (first < last && (*first == ' ' || *first == '\t')) ++first;
    if (first < last && *first == '+') ++first;
    const auto [end, error] = std::from_chars(first, last, value);
    if (first == last || *first == '-' || error != std::errc() || end != last) fail(f, " is not a whole number from 0");
    return value;
}
int64_t count(F f) { return integer<int64_t>(f, f.text); }

// Frames are counted in 32 bits (man/luxpipe-stream.5); sums of them fit 64 then.
int64_t frame_number(F f, const std::string& text) {
    const auto value = integer<int64_t>(f, text);
    if (value > 0xfffffffe) fail(f, ": frames end at 4294967294");
    return value;
}

int side(F f) {
    const int64_t value = count(f);
    if (value < 1 || value > 1 << 20) fail(f, " is out of range");
    return int(value);
}

void read_range(F f) {
    const size_t colon = f.text.find(':');
    if (colon == std::string::npos) fail(f, " is not RANGE=first:last");
    const int64_t first = frame_number(f, f.text.substr(0, colon)), last = frame_number(f, f.text.substr(colon + 1));
    if (last < first) fail(f, " ends before it begins");
    Ranges& ranges = f.h.other_seeds.empty() ? f.h.ranges : f.h.other_seeds.back().second;
    for (const auto& r : ranges)
        if (r.first <= last && first <= r.second)
            fail(f, fmt::format(": RANGE={}:{} before it holds such frames, too", r.first, r.second));
    ranges.emplace_back(first, last);
}

void read_seed(F f) {
    const auto seed = integer<uint64_t>(f, f.text);
    bool known = f.h.seed == seed;
    for (const auto& other : f.h.other_seeds) known = known || other.first == seed;
    if (known) fail(f, " comes twice");
    if (f.h.seed) f.h.other_seeds.push_back({seed, {}});
    else f.h.seed = seed;
}

void read_format(F f) {
    f.e.spectra = f.text == "Radiance_spectra";
    if (f.e.spectra) return;
    if (f.text == "32-bit_rle_rgbe") f.e.format = Format::rgbe;
    else if (f.text == "32-bit_rle_xyze") f.e.format = Format::xyze;
    else if (f.text == "float") f.e.format = Format::flt;
    else fail(f, ": this pixel format is not read (32-bit_rle_rgbe, 32-bit_rle_xyze and float are)");
}

void read_primaries(F f) {
    f.e.primaries = numbers<8>(f);
    if (*f.e.primaries == Primaries{}) f.e.primaries.reset();
    else if (!are_primaries(*f.e.primaries)) fail(f, " is not a set of chromaticities");
}

void read_edit(F f) {
    const size_t end = f.text.find(' ');
    f.h.edit = frame_number(f, f.text.substr(0, end));
    if (end != std::string::npos) f.h.edited = f.text.substr(end + 1);
}

void read_action(F f) {
    const std::vector<std::string> words = base::split_words(f.text);
    if (words.size() != 3 || (words[2] != "lx" && words[2] != "W/m2")) fail(f, " is not ACTION=name bands lx or W/m2");
    const int64_t bands = integer<int64_t>(f, words[1]);
    if (bands < 1 || bands > most_action_bands) fail(f, fmt::format(": bands are 1 to {}", most_action_bands));
    f.h.action = Action{plain_name(words[0], f.where), int(bands), words[2]};
}

void read_hour(F f) {
    const size_t slash = f.text.find('/');
    if (slash == std::string::npos) fail(f, " is not HOUR=k/n");
    const auto k = integer<int64_t>(f, f.text.substr(0, slash)), n = integer<int64_t>(f, f.text.substr(slash + 1));
    if ((k < 1 && n > 0) || k > n || n > most_hours) fail(f, " is no number of an hour");
    f.h.hour = {k, n};
}

void read_grid(F f) {
    const Grid grid = parse_grid(f.text, f.where);
    if (grid.first != count_of(f.h.grids)) fail(f, fmt::format(": {} points are before it", count_of(f.h.grids)));
    f.h.grids.push_back(grid);
}

// Would a reader take more from this line than history?
bool means_something(const std::string& line) {
    Header header;
    Encoding encoding;
    try {
        parse_header_line(line, header, encoding, "");
    } catch (const base::Error&) {
        return true;
    }
    return header.lines.empty() || header.view || encoding.splits;
}

std::string one_line(std::string text) {
    for (char& c : text)
        if (c == '\n' || c == '\r') c = ' ';
    if (text.size() > longest_kept) text = text.substr(0, longest_kept - 4) + " ...";
    return text;
}

struct Key {
    std::string_view key;
    void (*read)(F);
};
constexpr Key keys[] = {
    {"EXPOSURE=", [](F f) { multiply(f.h.exposure, numbers<1>(f)[0], f); }},
    {"COLORCORR=",
     [](F f) {
         for (size_t c = 0; c < 3; ++c) multiply(f.e.colorcorr[c], numbers<3>(f)[c], f);
     }},
    {"PIXASPECT=", [](F f) { multiply(f.h.pixel_aspect, numbers<1>(f)[0], f); }},
    {"PRIMARIES=", read_primaries},
    {"FORMAT=", read_format},
    {"NCOMP=", [](F f) { f.e.channels = side(f); }},
    {"LAYERS=", [](F f) { f.e.moments_follow = f.text == "moments"; }},
    {"LAYER=", [](F f) { f.e.moments = f.text == "moments"; }},
    {"WAVELENGTH_SPLITS=", [](F f) { f.e.splits = numbers<4>(f), f.h.lines.push_back(f.line); }},
    {"NROWS=", [](F f) { f.e.rows = side(f); }},
    {"NCOLS=", [](F f) { f.e.columns = side(f); }},
    {"BigEndian=", [](F f) { f.e.big_endian = integer<int>(f, f.text) != 0; }},
    {"SEED=", read_seed},
    {"RANGE=", read_range},
    {"FRAME=", [](F f) { f.h.frame = frame_number(f, f.text); }},
    {"FRAMES=", [](F f) { f.h.frames = count(f); }},
    {"LASTFRAME=", [](F f) { f.h.last_frame = count(f); }},
    {"FRAME0=", [](F f) { f.h.direct_frames = frame_number(f, f.text); }},
    {"EDIT=", read_edit},
    {"FINGERPRINT=", [](F f) { f.h.fingerprint = f.text; }},
    {"VIEWNAME=", [](F f) { f.h.view_name = plain_name(f.text, f.where); }},
    {"SKYNAME=", [](F f) { f.h.sky_name = plain_name(f.text, f.where); }},
    {"STATE=", [](F f) { f.h.state = state_name(f.text, f.where); }},
    {"ACTION=", read_action},
    {"SHARED_PATHS=", [](F f) { f.h.shared_paths = plain_name(f.text, f.where); }},
    {"HOUR=", read_hour},
    {"UNKNOWN=", [](F f) { f.h.unknown = one_line(f.text); }},
    {"GRID=", read_grid},
};

}  // namespace

void parse_header_line(const std::string& line, Header& h, Encoding& e, const std::string& where) {
    if (line.find('\t') != std::string::npos && line.find("EXPOSURE=") != std::string::npos) h.tabbed_exposure = true;
    if (line.compare(0, 2, "#?") == 0) return;
    if (!view::is_view_line(line)) {
        const auto key = std::find_if(std::begin(keys), std::end(keys),
                                      [&](const Key& k) { return base::begins_with(line, k.key); });
        if (key == std::end(keys)) h.lines.push_back(line);
        else key->read({line, value_of(line, key->key.size()), where, h, e});
        return;
    }
    view::View v = h.view.value_or(view::View());
    const bool command = line.compare(0, 5, "VIEW=") != 0;  // whose words mean many things
    std::string wrong;
    if (view::parse_line(v, line, &wrong)) h.view = v;
    if (command) h.lines.push_back(line);  // is history, too
    else if (!wrong.empty()) base::fail(where, "header line \"" + line + "\": " + wrong);
}

std::vector<std::string> header_lines(const Header& h) {
    std::vector<std::string> out{"#?RADIANCE"};
    const std::string software = "SOFTWARE=luxpipe " LUXPIPE_VERSION;
    for (const std::string& line : h.lines)
        if (!line.empty() && line != software) out.push_back(one_line(line));  // an empty line would end the header
    out.push_back(software);                                                   // once, after the command lines
    if (h.view) out.push_back("VIEW=" + view::to_options(*h.view));
    if (!h.view_name.empty()) out.push_back("VIEWNAME=" + h.view_name);
    if (!h.sky_name.empty()) out.push_back("SKYNAME=" + h.sky_name);
    if (!h.state.empty()) out.push_back("STATE=" + h.state);
    if (h.action) out.push_back(fmt::format("ACTION={} {} {}", h.action->name, h.action->bands, h.action->unit));
    if (!h.shared_paths.empty()) out.push_back("SHARED_PATHS=" + h.shared_paths);
    if (h.hour) out.push_back(fmt::format("HOUR={}/{}", h.hour->first, h.hour->second));
    if (!h.unknown.empty()) out.push_back("UNKNOWN=" + one_line(h.unknown));
    for (const Grid& grid : h.grids) out.push_back("GRID=" + to_text(grid));
    if (h.pixel_aspect != 1) out.push_back(fmt::format("PIXASPECT={}", h.pixel_aspect));
    if (h.edit) out.push_back(one_line(fmt::format("EDIT={} {}", *h.edit, h.edited)));
    if (!h.fingerprint.empty()) out.push_back(one_line("FINGERPRINT=" + h.fingerprint));
    if (h.direct_frames) out.push_back(fmt::format("FRAME0={}", *h.direct_frames));
    if (h.last_frame) out.push_back(fmt::format("LASTFRAME={}", *h.last_frame));
    if (h.seed) out.push_back(fmt::format("SEED={}", *h.seed));
    if (h.frame) out.push_back(fmt::format("FRAME={}", *h.frame));
    if (h.frames) out.push_back(fmt::format("FRAMES={}", *h.frames));
    for (const auto& r : h.ranges) out.push_back(fmt::format("RANGE={}:{}", r.first, r.second));
    for (const auto& [seed, ranges] : h.other_seeds) {
        out.push_back(fmt::format("SEED={}", seed));
        for (const auto& r : ranges) out.push_back(fmt::format("RANGE={}:{}", r.first, r.second));
    }
    return out;
}

// Names are free: one such as "EXPOSURE=2.exr" at the start of a line must not become a field of the header.
void add_history(Header& header, const std::string& text) {
    header.lines.push_back(one_line(means_something(text) ? "(" + text + ")" : text));
}

// Nor may it stand behind a tab: pictures with a tabbed EXPOSURE= are refused (tabbed_exposure).
void add_input_history(Header& header, const std::string& name, const Header& input) {
    add_history(header, name + ":");
    for (std::string line : header_lines(input)) {
        for (size_t at = 0; (at = line.find("EXPOSURE=", at)) != std::string::npos;) line[at + 8] = ':';
        header.lines.push_back(one_line("\t" + line));
    }
}

void require_complete(const Picture& picture, const std::string& where) {
    const Header& h = picture.header;
    if (h.frame && !h.frames && *h.frame > 0)
        base::fail(
            where,
            fmt::format("is single frame {}, not a picture of the scene: sum the frames with ptaccum first", *h.frame));
    if (lacks_frame0(h))
        base::fail(where, fmt::format("is a partial sum without frame 0 (RANGE={}): merge it with ptaccum first",
                                      to_text(h.ranges)));
}

}  // namespace image
