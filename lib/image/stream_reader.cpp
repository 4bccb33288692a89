// SPDX-License-Identifier: BSD-3-Clause
// Pictures from files and pipes.  Float pixels are read straight into place; memory grows with the data that
// really arrive, so that a header that lies about the size costs nothing.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "base/error.h"
#include "base/failed_before.h"
#include "base/shutdown.h"
#include "image/file_format.h"
#include "image/header.h"
#include "image/input.h"
#include "image/rgbe.h"
#include "image/stream.h"
#include "image/stream_parts.h"

namespace image {
namespace {

constexpr size_t most_header = 1 << 20, longest_line = 1 << 16;
constexpr int most_side = 32768;
constexpr size_t grow_floats = 1 << 24;  // 64 MiB at a time

std::string read_line(Input& in, const std::string& place) {
    std::string line;
    for (int c; (c = in.get()) != '\n';) {
        if (c < 0) base::fail(place, "input ends inside the header");
        if (line.size() >= longest_line) base::fail(place, "a header line is longer than 65536 characters");
        line += char(c);
    }
    if (!line.empty() && line.back() == '\r') line.pop_back();
    return line;
}

Layout parse_resolution(const std::string& line, const std::string& place) {
    char axis[2], sign[2];
    long size[2];
    const char* at = line.c_str();
    const auto wrong = [&] {
        base::fail(place, "\"" + line.substr(0, 60) + "\" is not a resolution line such as -Y 512 +X 512");
    };
    for (int i = 0; i < 2; ++i) {
        while (*at == ' ') ++at;
        sign[i] = *at ? *at++ : 0;
        axis[i] = *at ? *at++ : 0;
        if ((sign[i] != '-' && sign[i] != '+') || (axis[i] != 'X' && axis[i] != 'Y')) wrong();
        char* end = nullptr;
        size[i] = std::strtol(at, &end, 10);
        if (end == at) wrong();
        at = end;
    }
    while (*at == ' ') ++at;
    if (*at || axis[0] == axis[1]) wrong();
    for (const long side : size)
        if (side < 1 || side > most_side)
            base::fail(place,
                       "picture size " + std::to_string(side) + " is not within 1.." + std::to_string(most_side));
    Layout l;
    l.x_major = axis[0] == 'X';
    const int x = l.x_major ? 0 : 1;
    l.width = int(size[x]);
    l.height = int(size[1 - x]);
    l.x_down = sign[x] == '-';
    l.y_up = sign[1 - x] == '+';
    return l;
}

void swap_bytes(float* data, size_t n) {
    for (size_t i = 0; i < n; ++i) {
        uint32_t v;
        std::memcpy(&v, data + i, 4);
        v = v >> 24 | (v >> 8 & 0xff00) | (v << 8 & 0xff0000) | v << 24;
        std::memcpy(data + i, &v, 4);
    }
}

void read_floats(Input& in, const Encoding& e, const Layout& l, std::vector<float>& rgb, const std::string& place) {
    const size_t pixels = size_t(l.width) * l.height, total = pixels * e.channels;
    if (const auto left = in.remaining())
        if (*left < total * 4)
            base::fail(place, "input ends inside the picture (" + std::to_string(*left) + " of " +
                                  std::to_string(total * 4) + " bytes)");
    size_t done = 0;
    if (total <= grow_floats) rgb.resize(total);
    while (done < total) {
        const size_t n = std::min(total - done, grow_floats);
        if (rgb.size() < done + n) rgb.resize(done + n);
        const size_t got = in.read(rgb.data() + done, n * 4);
        if (got < n * 4)
            base::fail(place, "input ends inside the picture (row " +
                                  std::to_string((done + got / 4) / e.channels / (l.x_major ? l.height : l.width)) +
                                  " of " + std::to_string(l.x_major ? l.width : l.height) + ")");
        done += n;
    }
    rgb.resize(total);
    if (e.big_endian.value_or(host_is_big_endian()) != host_is_big_endian()) swap_bytes(rgb.data(), total);
    if (e.channels == 1) {
        rgb.resize(3 * pixels);
        for (size_t i = pixels; i-- > 0;) rgb[3 * i] = rgb[3 * i + 1] = rgb[3 * i + 2] = rgb[i];
    }
}

void read_bytes(Input& in, const Layout& l, std::vector<float>& rgb, const std::string& place) {
    const int fast = l.x_major ? l.height : l.width, slow = l.x_major ? l.width : l.height;
    if (const auto left = in.remaining())
        if (*left < uint64_t(slow) * 4) base::fail(place, "input ends inside the picture");
    std::vector<uint8_t> row(4 * size_t(fast));
    const size_t total = 3 * size_t(fast) * slow;
    if (total <= grow_floats) rgb.resize(total);
    else rgb.clear();
    for (int s = 0; s < slow; ++s) {
        read_rgbe_row(in, fast, row.data(), place);
        const size_t at = 3 * size_t(fast) * s;
        if (rgb.size() < at + 3 * size_t(fast))
            rgb.resize(std::min(total, std::max(at + 3 * size_t(fast), at + grow_floats)));
        rgbe_to_float(row.data(), fast, &rgb[at]);
    }
}

// The picture that LAYERS=moments of the one before it announces.
Moments read_moments(Input& in, const Picture& picture, const std::string& place) {
    const Head head = read_head(in, place);
    if (!head.encoding.moments) base::fail(place, "LAYERS=moments says that its moments follow, but they do not");
    if (head.encoding.format != Format::flt || head.encoding.channels != int(moment_numbers))
        base::fail(place, fmt::format("its moments are not floats with NCOMP={}", moment_numbers));
    if (head.layout.width != picture.width || head.layout.height != picture.height)
        base::fail(place, fmt::format("its moments have {} x {} pixels, it has {} x {}", head.layout.width,
                                      head.layout.height, picture.width, picture.height));
    std::vector<float> moments;
    read_floats(in, head.encoding, head.layout, moments, place);
    reorient(moments, head.layout, moment_numbers);
    clean_moments(moments);
    return std::make_shared<const std::vector<float>>(std::move(moments));
}

// Exposure, colour correction, colour space: afterwards RADIANCE's RGB radiance.
void to_radiance(std::vector<float>& rgb, const Header& h, const Encoding& e) {
    const bool xyz = e.format == Format::xyze;  // its pixels are cd/m2
    const double unit = 1 / h.exposure / (xyz ? lumens_per_watt : 1);
    convert(rgb, {unit / e.colorcorr[0], unit / e.colorcorr[1], unit / e.colorcorr[2]},
            xyz           ? rgb_from_xyz()
            : e.primaries ? rgb_from_primaries(*e.primaries)
                          : std::nullopt);
}

// Pictures of the format's first years have no mark; those with float pixels, which came later, have lost it.
Head read_unmarked_head(Input& in, const std::string& place) {
    try {
        Head head = read_head(in, place);
        if (head.encoding.format != Format::flt) return head;
    } catch (const base::Error& e) {
        if (e.kind != base::Kind::input) throw;
    }
    base::fail(place, "is not a RADIANCE picture (it does not begin with #?)");
}

}  // namespace

void reorient(std::vector<float>& values, const Layout& l, size_t channels) {
    if (l.standard()) return;
    std::vector<float> out(values.size());
    const float* from = values.data();
    const int slow = l.x_major ? l.width : l.height, fast = l.x_major ? l.height : l.width;
    for (int s = 0; s < slow; ++s)
        for (int f = 0; f < fast; ++f, from += channels) {
            const int i = l.x_major ? s : f, j = l.x_major ? f : s;
            const int x = l.x_down ? l.width - 1 - i : i, y = l.y_up ? l.height - 1 - j : j;
            std::copy(from, from + channels, &out[channels * (size_t(y) * l.width + x)]);
        }
    values.swap(out);
}

Head read_head(Input& in, const std::string& place) {
    Head head;
    size_t bytes = 0;
    for (std::string line; !(line = read_line(in, place)).empty();) {
        if ((bytes += line.size() + 1) > most_header) base::fail(place, "the header is longer than 1 MiB");
        if (line == "FAILED=") throw base::FailedBefore(place);
        parse_header_line(line, head.header, head.encoding, place);
    }
    if (head.encoding.rows && head.encoding.columns) {
        head.layout.width = head.encoding.columns;
        head.layout.height = head.encoding.rows;
        if (head.layout.width > most_side || head.layout.height > most_side)
            base::fail(place, "picture size is not within 1.." + std::to_string(most_side));
    } else {
        head.layout = parse_resolution(read_line(in, place), place);
    }
    Header& h = head.header;
    if (h.frame && !h.seed) {  // rpict -S numbers the pictures of an animation; our frames have a seed
        add_history(h, fmt::format("FRAME={}", *h.frame));
        h.frame.reset();
    }
    return head;
}

// Number of the last frame in a picture.
static int64_t last_frame_in(const Header& h) {
    if (h.frame && !h.frames) return *h.frame;
    if (!h.ranges.empty()) return h.ranges.back().second;
    return h.frames.value_or(0);
}

struct StreamReader::State {
    Input in;
    int64_t count = 0;
    const FileFormat* whole_file = nullptr;  // null: a stream
    Pixels pixels;
    std::string named_by;
    int64_t edit = 0;                      // of the picture read last
    int64_t announced = -1, reached = -1;  // frame numbers: LASTFRAME=, and the picture read last

    CarriedMoments moments;

    State(const std::string& path, Pixels wanted, const base::Opener& by)
        : in(path, by), pixels(wanted), named_by(by.place) {
        char start[4];
        if (in.look(start, 4)) whole_file = format_by_magic(start);
        if (whole_file && (path == "-" || !in.remaining()))
            base::fail(in.name(),
                       fmt::format("holds a picture in the format {}: give the file's name, it cannot be read from "
                                   "a pipe",
                                   whole_file->name));
    }
    void require_announced(const std::string& place, const char* fact) const {
        if (reached < announced)
            base::fail(place, fmt::format("{} after frame {}, where frames up to {} were announced: the program "
                                          "that wrote it was stopped",
                                          fact, reached, announced));
    }
};

StreamReader::StreamReader(const std::string& path, Pixels pixels, const base::Opener& by)
    : state_(new State(path, pixels, by)) {}
StreamReader::~StreamReader() = default;
int64_t StreamReader::pictures() const { return state_->count; }

bool StreamReader::next(Picture& picture) {
    Input& in = state_->in;
    if (state_->whole_file) {
        if (state_->count++) return false;
        picture = state_->whole_file->read(in.name(), state_->named_by);
        return true;
    }
    if (in.at_end()) {
        if (base::shutdown_requested()) return false;
        if (state_->count == 0)
            base::fail(in.name(), std::string("holds no picture") +
                                      (in.name() == "stdin" ? " (ptaccum -o needs -o - as well to pass them on)" : ""));
        state_->require_announced(in.name(), "ends");
        return false;
    }
    const std::string place = in.name() + (state_->count ? ": picture " + std::to_string(state_->count + 1) : "");
    picture.frame0.clear();
    picture.sum.clear();
    picture.parts.clear();
    picture.moments.reset();
    char start[2];
    const bool marked = in.look(start, 2) && start[0] == '#' && start[1] == '?';
    if (!marked && state_->count) base::fail(place, "what follows is not a picture (it does not begin with #?)");
    Head head = marked ? read_head(in, place) : read_unmarked_head(in, place);
    Encoding& encoding = head.encoding;
    const Layout& layout = head.layout;
    picture.header = std::move(head.header);
    if (encoding.spectra)
        base::fail(place, "is a hyperspectral picture (FORMAT=Radiance_spectra): only specpict reads such");
    if (encoding.moments) base::fail(place, "is a layer (LAYER=moments) without its picture before it");
    if (encoding.format == Format::flt) {
        if (encoding.channels != 1 && encoding.channels != 3)
            base::fail(place, "NCOMP=" + std::to_string(encoding.channels) + ": float pictures have 1 or 3 channels");
        read_floats(in, encoding, layout, picture.rgb, place);
    } else {
        read_bytes(in, layout, picture.rgb, place);
    }
    reorient(picture.rgb, layout, 3);
    if (state_->pixels == Pixels::exposed) {
        encoding.primaries.reset();
        encoding.colorcorr = Encoding().colorcorr;
    }
    if (state_->pixels != Pixels::stored || encoding.format == Format::xyze)
        to_radiance(picture.rgb, picture.header, encoding);
    picture.width = layout.width;
    picture.height = layout.height;
    picture.floats = encoding.format == Format::flt;
    if (encoding.moments_follow) picture.moments = read_moments(in, picture, place);
    state_->moments.pass(picture);
    const int64_t number = last_frame_in(picture.header);
    const bool edited = picture.header.edit.value_or(0) > state_->edit;  // and so on purpose
    state_->edit = picture.header.edit.value_or(0);
    if (number == 0 && !edited) state_->require_announced(place, "begins anew");
    state_->reached = number;
    if (number == 0 || picture.header.last_frame) state_->announced = picture.header.last_frame.value_or(-1);
    ++state_->count;
    return true;
}

}  // namespace image
