// SPDX-License-Identifier: BSD-3-Clause
// Header lines of RADIANCE pictures and the lines of our streams (man/luxpipe-stream.5).
// Keys are case sensitive and begin their line; a line that begins with a tab is history of an input.
#include "image/header.h"

#include <fmt/format.h>

#include <charconv>

#include "base/error.h"
#include "base/number.h"
#include "base/split.h"

namespace image {
namespace {

constexpr size_t longest_line = 2040;  // RADIANCE reads lines of at most 2047 characters

template <size_t size>
std::optional<std::string> value_of(const std::string& line, const char (&key)[size]) {
    constexpr size_t n = size - 1;
    if (!base::begins_with(line, {key, n})) return std::nullopt;
    const size_t from = line.find_first_not_of(' ', n);
    if (from == std::string::npos) return std::string();
    return line.substr(from, line.find_last_not_of(" \t\r") + 1 - from);
}

// Reads exactly the numbers asked for; anything else is an error of the line.
template <size_t n>
std::array<double, n> numbers(const std::string& line, const std::string& text, const std::string& where) {
    std::array<double, n> all{};
    const std::vector<std::string> words = base::split_words(text);
    bool good = words.size() == n;
    for (size_t i = 0; good && i < n; ++i) good = base::parse_real(words[i], all[i]);
    if (!good) base::fail(where, "header line \"" + line + "\" is malformed");
    return all;
}

// Times what such lines before it have given.  A product that no float could hold would leave only 0 and infinity.
void multiply(double& product, double factor, const std::string& line, const std::string& where) {
    if (!(factor > 0)) base::fail(where, "header line \"" + line + "\" is not above 0");
    product *= factor;
    if (!(product >= 1e-30 && product <= 1e30))
        base::fail(where, fmt::format("header line \"{}\": {:g} is not within 1e-30 to 1e30", line, product));
}

bool overlap(const std::pair<int64_t, int64_t>& a, const std::pair<int64_t, int64_t>& b) {
    return a.first <= b.second && b.first <= a.second;
}

void add_range(Ranges& ranges, const std::pair<int64_t, int64_t>& more, const std::string& line,
               const std::string& where) {
    for (const auto& r : ranges)
        if (overlap(r, more))
            base::fail(where, fmt::format("header line \"{}\": RANGE={}:{} before it holds such frames, too", line,
                                          r.first, r.second));
    ranges.push_back(more);
}

// Integers may exceed a double's 53 bits (seeds).
template <class Int>
Int integer(const std::string& line, const std::string& text, const std::string& where) {
    Int value{};
    const char *first = text.data(), *const last = first + text.size();
    while (first < last && (*first == ' ' || *first == '\t')) ++first;
    if (first < last && *first == '+') ++first;
    const auto [end, error] = std::from_chars(first, last, value);
    if (first == last || *first == '-' || error != std::errc() || end != last)
        base::fail(where, "header line \"" + line + "\" is not a whole number from 0");
    return value;
}

// Frames are counted in 32 bits (man/luxpipe-stream.5); sums of them fit 64 then.
int64_t frame_number(const std::string& line, const std::string& text, const std::string& where) {
    const auto value = integer<int64_t>(line, text, where);
    if (value > 0xfffffffe) base::fail(where, "header line \"" + line + "\": frames end at 4294967294");
    return value;
}

int side(const std::string& line, const std::string& text, const std::string& where) {
    const int64_t value = integer<int64_t>(line, text, where);
    if (value < 1 || value > 1 << 20) base::fail(where, "header line \"" + line + "\" is out of range");
    return int(value);
}

std::pair<int64_t, int64_t> range(const std::string& line, const std::string& text, const std::string& where) {
    const size_t colon = text.find(':');
    if (colon == std::string::npos) base::fail(where, "header line \"" + line + "\" is not RANGE=first:last");
    const int64_t first = frame_number(line, text.substr(0, colon), where);
    const int64_t last = frame_number(line, text.substr(colon + 1), where);
    if (last < first) base::fail(where, "header line \"" + line + "\" ends before it begins");
    return {first, last};
}

Format format(const std::string& line, const std::string& text, const std::string& where) {
    if (text == "32-bit_rle_rgbe") return Format::rgbe;
    if (text == "32-bit_rle_xyze") return Format::xyze;
    if (text == "float") return Format::flt;
    base::fail(where, "header line \"" + line +
                          "\": this pixel format is not read (32-bit_rle_rgbe, 32-bit_rle_xyze and float are)");
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
    if (text.size() > longest_line) text = text.substr(0, longest_line - 4) + " ...";
    return text;
}

void add_seed(uint64_t seed, const std::string& line, const std::string& where, Header& h) {
    bool told = h.seed == seed;
    for (const auto& other : h.other_seeds) told = told || other.first == seed;
    if (told) base::fail(where, "header line \"" + line + "\" comes twice");
    if (h.seed) h.other_seeds.push_back({seed, {}});
    else h.seed = seed;
}

}  // namespace

void parse_header_line(const std::string& line, Header& h, Encoding& e, const std::string& where) {
    if (line.find('\t') != std::string::npos && line.find("EXPOSURE=") != std::string::npos) h.tabbed_exposure = true;
    if (line.compare(0, 2, "#?") == 0) return;
    std::optional<std::string> t;
    if (view::is_view_line(line)) {
        view::View v = h.view.value_or(view::View());
        const bool command = line.compare(0, 5, "VIEW=") != 0;  // whose words mean many things
        std::string wrong;
        if (view::parse_line(v, line, &wrong)) h.view = v;
        if (command) h.lines.push_back(line);  // is history, too
        else if (!wrong.empty()) base::fail(where, "header line \"" + line + "\": " + wrong);
    } else if ((t = value_of(line, "EXPOSURE="))) {
        multiply(h.exposure, numbers<1>(line, *t, where)[0], line, where);
    } else if ((t = value_of(line, "COLORCORR="))) {
        const auto c = numbers<3>(line, *t, where);
        for (int i = 0; i < 3; ++i) multiply(e.colorcorr[i], c[i], line, where);
    } else if ((t = value_of(line, "PIXASPECT="))) {
        multiply(h.pixel_aspect, numbers<1>(line, *t, where)[0], line, where);
    } else if ((t = value_of(line, "PRIMARIES="))) {
        e.primaries = numbers<8>(line, *t, where);
        if (*e.primaries == Primaries{}) e.primaries.reset();
        else if (!are_primaries(*e.primaries))
            base::fail(where, "header line \"" + line + "\" is not a set of chromaticities");
    } else if ((t = value_of(line, "FORMAT="))) {
        e.spectra = *t == "Radiance_spectra";
        if (!e.spectra) e.format = format(line, *t, where);
    } else if ((t = value_of(line, "NCOMP="))) {
        e.channels = side(line, *t, where);
    } else if ((t = value_of(line, "LAYERS="))) {
        e.moments_follow = *t == "moments";
    } else if ((t = value_of(line, "LAYER="))) {
        e.moments = *t == "moments";
    } else if ((t = value_of(line, "WAVELENGTH_SPLITS="))) {
        e.splits = numbers<4>(line, *t, where);
        h.lines.push_back(line);
    } else if ((t = value_of(line, "NROWS="))) {
        e.rows = side(line, *t, where);
    } else if ((t = value_of(line, "NCOLS="))) {
        e.columns = side(line, *t, where);
    } else if ((t = value_of(line, "BigEndian="))) {
        e.big_endian = integer<int>(line, *t, where) != 0;
    } else if ((t = value_of(line, "SEED="))) {
        add_seed(integer<uint64_t>(line, *t, where), line, where, h);
    } else if ((t = value_of(line, "FRAME="))) {
        h.frame = frame_number(line, *t, where);
    } else if ((t = value_of(line, "FRAMES="))) {
        h.frames = integer<int64_t>(line, *t, where);
    } else if ((t = value_of(line, "LASTFRAME="))) {
        h.last_frame = integer<int64_t>(line, *t, where);
    } else if ((t = value_of(line, "FRAME0="))) {
        h.direct_frames = frame_number(line, *t, where);
    } else if ((t = value_of(line, "EDIT="))) {
        const size_t end = t->find(' ');
        h.edit = frame_number(line, t->substr(0, end), where);
        if (end != std::string::npos) h.edited = t->substr(end + 1);
    } else if ((t = value_of(line, "FINGERPRINT="))) {
        h.fingerprint = *t;
    } else if ((t = value_of(line, "VIEWNAME="))) {
        h.view_name = plain_name(*t, where);
    } else if ((t = value_of(line, "SKYNAME="))) {
        h.sky_name = plain_name(*t, where);
    } else if ((t = value_of(line, "SHARED_PATHS="))) {
        h.shared_paths = plain_name(*t, where);
    } else if ((t = value_of(line, "UNKNOWN="))) {
        h.unknown = one_line(*t);
    } else if ((t = value_of(line, "GRID="))) {
        const Grid grid = parse_grid(*t, where);
        if (grid.first != count_of(h.grids))
            base::fail(where, fmt::format("header line \"{}\": {} points are before it", line, count_of(h.grids)));
        h.grids.push_back(grid);
    } else if ((t = value_of(line, "RANGE="))) {
        Ranges& ranges = h.other_seeds.empty() ? h.ranges : h.other_seeds.back().second;
        add_range(ranges, range(line, *t, where), line, where);
    } else {
        h.lines.push_back(line);
    }
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
    if (!h.shared_paths.empty()) out.push_back("SHARED_PATHS=" + h.shared_paths);
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
