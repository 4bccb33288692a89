// SPDX-License-Identifier: BSD-3-Clause
// Data files and pictures to tables.  A picture is a data array of three channels over (v, u): samples stand at the
// ends of the range, the shorter side has length 1, v is up, values are those in the file (its exposure is not divided
// out).
#include <algorithm>
#include <array>
#include <cmath>
#include "base/error.h"
#include "base/number.h"
#include "cal/tables.h"
#include "image/spectral.h"
#include "image/stream.h"
#include "kernels/dialect/compat_host.h"

namespace cal {

namespace {

constexpr size_t max_data_file = size_t(256) << 20;
constexpr uint32_t max_dims = 5;
constexpr uint32_t even = 0xffffffffu;

class Numbers {  // the words of a data file, comments left out
public:
    Numbers(const std::string& text, const std::string& path, const std::string& place)
        : text_(text), path_(path), place_(place) {}
    [[noreturn]] void fail(const std::string& fact) const {
        base::fail(place_, "data file \"" + path_ + "\": " + fact);
    }
    double real() {
        for (;;) {
            while (at_ < text_.size() && (text_[at_] == ' ' || (text_[at_] >= '\t' && text_[at_] <= '\r'))) at_++;
            if (at_ >= text_.size() || text_[at_] != '#') break;
            while (at_ < text_.size() && text_[at_] != '\n') at_++;
        }
        const size_t from = at_;
        while (at_ < text_.size() && static_cast<unsigned char>(text_[at_]) > ' ' && text_[at_] != '#') at_++;
        if (at_ == from) fail("ends too early");
        double v;
        const std::string_view word(text_.data() + from, at_ - from);
        if (!base::parse_real(word, v)) fail("\"" + std::string(word.substr(0, 40)) + "\" is not a number");
        return v;
    }
    uint32_t count(const char* what) {
        const double v = real();
        if (!(v >= 1 && v <= 2e9) || v != std::floor(v)) fail(std::string("bad ") + what);
        return uint32_t(v);
    }
    size_t left() const { return text_.size() - at_; }

private:
    const std::string& text_;
    const std::string &path_, &place_;
    size_t at_ = 0;
};

}  // namespace

DataFile read_data(const std::string& path, const base::Opener& by) {
    const std::string text = read_text(path, max_data_file, by);
    Numbers in(text, path, by.place);
    DataFile data;
    const uint32_t dims = in.count("number of dimensions");
    if (dims > max_dims) in.fail("more than 5 dimensions");
    size_t total = 1;
    for (uint32_t d = 0; d < dims; d++) {
        DataFile::Dimension dim;
        dim.begin = in.real();
        dim.end = in.real();
        dim.count = in.count("number of points");
        if (dim.count < 2) in.fail("a dimension needs at least 2 points");
        if (dim.count > in.left()) in.fail("is shorter than its dimensions say");
        if (dim.begin == dim.end) {
            for (uint32_t i = 0; i < dim.count; i++) dim.positions.push_back(float(in.real()));
            const bool up = dim.positions[1] > dim.positions[0];
            for (uint32_t i = 1; i < dim.count; i++)
                if (dim.positions[i] == dim.positions[i - 1] || (dim.positions[i] > dim.positions[i - 1]) != up)
                    in.fail("positions are not in order");
        }
        total *= dim.count;
        data.dimensions.push_back(std::move(dim));
        if (total > in.left()) in.fail("is shorter than its dimensions say");
    }
    data.values.reserve(total);
    for (size_t i = 0; i < total; i++) data.values.push_back(float(in.real()));
    return data;
}

uint32_t add_data(const DataFile& data, uint32_t channels, Code& code) {
    const uint32_t table = uint32_t(code.words.size());
    if (code.floats.size() + data.values.size() > 0xf0000000u) base::fail("", "data and pictures are too large");
    code.words.push_back(uint32_t(data.dimensions.size()));
    code.words.push_back(channels);
    code.words.push_back(uint32_t(code.floats.size()));
    code.floats.insert(code.floats.end(), data.values.begin(), data.values.end());
    for (const DataFile::Dimension& d : data.dimensions) {
        code.words.push_back(d.count);
        code.words.push_back(as_uint_(float(d.begin)));
        code.words.push_back(as_uint_(float((d.end - d.begin) / (d.count - 1))));
        code.words.push_back(d.positions.empty() ? even : uint32_t(code.floats.size()));
        code.floats.insert(code.floats.end(), d.positions.begin(), d.positions.end());
    }
    return table;
}

uint32_t data_table(Library::State& library, const std::string& file, size_t dimensions, const std::string& place,
                    Code& code) {
    const std::string path = base::find_file(file, library.files, place);
    const auto known = code.tables.find("data " + path);
    const uint32_t table = known != code.tables.end() ? known->second
                                                      : code.tables["data " + path] = add_data(
                                                            read_data(path, library.files.opener(place)), 1, code);
    if (code.words[table] != dimensions)
        base::fail(place, "data file \"" + file + "\" has " + std::to_string(code.words[table]) + " dimensions, " +
                              std::to_string(dimensions) + " coordinates are given");
    return table;
}

// The picture as a plane over (v, u), row by row from below.  A side of one pixel has the same value everywhere: its
// pixel comes twice, and the second one is infinitely far away.
template <class PIXEL>
static DataFile picture_plane(int width, int height, double pixel_aspect, PIXEL&& pixel) {
    DataFile data;
    const double wide = width, high = height * pixel_aspect, shorter = std::min(wide, high);
    for (const auto& [pixels, length] : {std::pair(height, high), {width, wide}}) {
        DataFile::Dimension dim;
        dim.end = pixels > 1 ? length / shorter : 1e30;
        dim.count = uint32_t(std::max(pixels, 2));
        data.dimensions.push_back(dim);
    }
    data.values.reserve(size_t(3) * data.dimensions[0].count * data.dimensions[1].count);
    for (int y = std::max(height, 2) - 1; y >= 0; y--)
        for (int x = 0; x < std::max(width, 2); x++) {
            const std::array<float, 3> channels = pixel(std::min(x, width - 1), std::min(y, height - 1));
            data.values.insert(data.values.end(), channels.begin(), channels.end());
        }
    return data;
}

uint32_t picture_table(Library::State& library, const std::string& file, const std::string& place, Code& code) {
    const std::string path = base::find_file(file, library.files, place);
    const auto known = code.tables.find("picture " + path);
    if (known != code.tables.end()) return known->second;
    const image::Picture picture = image::read_file(path, image::Pixels::stored, library.files.opener(place));
    const DataFile data = picture_plane(picture.width, picture.height, picture.header.pixel_aspect, [&](int x, int y) {
        return std::array{picture.at(x, y)[0], picture.at(x, y)[1], picture.at(x, y)[2]};
    });
    return code.tables["picture " + path] = add_data(data, 3, code);
}

std::optional<SpectralTables> spectral_tables(Library::State& library, const std::string& file,
                                              const std::string& place, Code& code) {
    const std::string path = base::find_file(file, library.files, place);
    const auto picture = image::read_spectral_file(path, library.files.opener(place));
    if (!picture) return {};
    SpectralTables r;
    r.bands = picture->bands;
    r.from = picture->from;
    r.to = picture->to;
    for (int first = 0; first < r.bands; first += 3) {
        const std::string key = "bands " + std::to_string(first) + " " + path;
        const auto known = code.tables.find(key);
        if (known != code.tables.end()) {
            r.tables.push_back(known->second);
            continue;
        }
        const auto band = [&](int x, int y, int k) {
            return k < r.bands ? picture->values[(size_t(y) * picture->width + x) * r.bands + k] : 0;
        };
        const DataFile data = picture_plane(picture->width, picture->height, picture->pixel_aspect, [&](int x, int y) {
            return std::array{band(x, y, first), band(x, y, first + 1), band(x, y, first + 2)};
        });
        r.tables.push_back(code.tables[key] = add_data(data, 3, code));
    }
    return r;
}

}  // namespace cal
