// SPDX-License-Identifier: BSD-3-Clause
// Reading and summing streams once more: see stream_model.h.
#include "stream_model.h"

#include <cmath>
#include <cstdlib>
#include <cstring>

namespace breaking {
namespace {

struct Storage {
    bool is_float = false, foreign = false, big = false;
    int channels = 3;
    double divide_by[3] = {1, 1, 1};
};

// The rest of the line after KEY=, without spaces around; nothing if the line has another key.
std::optional<std::string> value_of(const std::string& line, const char* key) {
    const size_t n = std::strlen(key);
    if (line.compare(0, n, key) != 0) return std::nullopt;
    size_t from = n, to = line.size();
    while (from < to && line[from] == ' ') ++from;
    while (to > from && std::strchr(" \t\r", line[to - 1])) --to;
    return line.substr(from, to - from);
}

std::optional<uint64_t> whole(const std::string& text) {
    char* end = nullptr;
    const uint64_t value = std::strtoull(text.c_str(), &end, 10);
    if (text.empty() || text[0] == '-' || *end || end != text.c_str() + text.size()) return std::nullopt;
    return value;
}

// One header line; false: a tool that takes this line knows more than we do.
bool take_line(const std::string& line, ModelPicture& p, Storage& s) {
    const auto number = [&](const std::string& text, auto& field) {
        const auto value = whole(text);
        if (value) field = static_cast<typename std::decay_t<decltype(field)>::value_type>(*value);
        return value.has_value();
    };
    if (const auto v = value_of(line, "FORMAT=")) return s.is_float = *v == "float";
    if (const auto v = value_of(line, "NCOMP=")) return (s.channels = std::atoi(v->c_str())) == 3 || s.channels == 1;
    if (const auto v = value_of(line, "BigEndian=")) {
        const auto big = whole(*v);
        s.big = big && *big != 0;
        return big.has_value();
    }
    if (const auto v = value_of(line, "EXPOSURE=")) {
        for (double& d : s.divide_by) d *= std::atof(v->c_str());
        return true;
    }
    if (const auto v = value_of(line, "COLORCORR=")) {
        double c[3] = {0, 0, 0};
        const bool three = std::sscanf(v->c_str(), "%lf %lf %lf", c, c + 1, c + 2) == 3;
        for (int i = 0; i < 3; ++i) s.divide_by[i] *= c[i];
        return three;
    }
    for (const char* key : {"PRIMARIES=", "NROWS=", "NCOLS=", "WAVELENGTH_SPLITS="})
        if (value_of(line, key)) return false;
    p.lines.push_back(line);
    if (const auto v = value_of(line, "FRAME=")) return number(*v, p.frame);
    if (const auto v = value_of(line, "FRAMES=")) return number(*v, p.frames);
    if (const auto v = value_of(line, "SEED=")) return !p.seed && number(*v, p.seed);
    if (const auto v = value_of(line, "LASTFRAME=")) return number(*v, p.announced);
    if (const auto v = value_of(line, "FINGERPRINT=")) p.fingerprint = *v;
    if (const auto v = value_of(line, "RANGE="))
        return v->find(':') != std::string::npos && number(v->substr(v->find(':') + 1), p.last);
    return true;
}

// The line at the cursor, without its end.
std::optional<std::string> next_line(const std::string& bytes, size_t& at) {
    const size_t end = bytes.find('\n', at);
    if (end == std::string::npos) return std::nullopt;
    const std::string line = bytes.substr(at, end - at);
    at = end + 1;
    return line;
}

float number_at(const char* at, bool big) {
    unsigned char b[4];
    std::memcpy(b, at, 4);
    uint32_t bits = 0;
    for (int i = 0; i < 4; ++i) bits |= uint32_t(b[big ? 3 - i : i]) << (8 * i);
    float f;
    std::memcpy(&f, &bits, 4);
    return f;
}

ModelStream::End read_one(const std::string& bytes, size_t& at, ModelPicture& p) {
    using End = ModelStream::End;
    Storage s;
    bool known = true;
    auto line = next_line(bytes, at);
    if (!line || line->compare(0, 2, "#?") != 0) return End::cut;
    while ((line = next_line(bytes, at)) && !line->empty() && *line != "\r") known = take_line(*line, p, s) && known;
    if (!line) return End::cut;
    if (!known || !s.is_float) return End::foreign;
    if (!(line = next_line(bytes, at))) return End::cut;
    if (std::sscanf(line->c_str(), "-Y %d +X %d", &p.height, &p.width) != 2) return End::foreign;
    if (p.width < 1 || p.height < 1 || p.width > 32768 || p.height > 32768) return End::cut;
    const size_t pixels = size_t(p.width) * size_t(p.height), size = pixels * size_t(s.channels) * 4;
    if (bytes.size() - at < size) return End::cut;
    for (size_t i = 0; i < 3 * pixels; ++i) {
        const size_t from = s.channels == 3 ? i : i / 3;
        p.rgb.push_back(number_at(&bytes[at + 4 * from], s.big) / s.divide_by[i % 3]);
    }
    at += size;
    return End::clean;
}

}  // namespace

ModelStream read_stream(const std::string& bytes) {
    ModelStream stream;
    for (size_t at = 0; at < bytes.size() && stream.end == ModelStream::End::clean;) {
        ModelPicture p;
        stream.end = read_one(bytes, at, p);
        if (stream.end == ModelStream::End::clean) stream.pictures.push_back(std::move(p));
    }
    return stream;
}

bool ModelStream::ends_early() const {
    if (end != End::clean) return false;
    std::optional<int64_t> at, announced;
    for (const ModelPicture& p : pictures) {
        at = p.frame && !p.frames ? p.frame : p.last;
        if (p.announced || at == 0) announced = p.announced;
    }
    return at && announced && *at < *announced;
}

std::string write_picture(const ModelPicture& p) {
    std::string bytes = "#?RADIANCE\n";
    for (const std::string& line : p.lines)
        if (!value_of(line, "LASTFRAME=")) bytes += line + "\n";  // by itself, it is the last
    bytes += "NCOMP=3\nBigEndian=0\nFORMAT=float\n\n-Y " + std::to_string(p.height) + " +X " + std::to_string(p.width) +
             "\n";
    for (const double value : p.rgb) {
        const float f = float(value);
        uint32_t bits;
        std::memcpy(&bits, &f, 4);
        for (int i = 0; i < 4; ++i) bytes += char(bits >> (8 * i) & 255);
    }
    return bytes;
}

std::optional<std::vector<ModelSum>> sums_of(const std::vector<ModelPicture>& frames) {
    std::vector<ModelSum> sums;
    std::vector<double> first, rest, scale;
    const ModelPicture* begin = nullptr;
    int64_t next = 0, n = 0;
    for (const ModelPicture& p : frames) {
        if (!p.frame || p.frames) return std::nullopt;
        if (!begin || *p.frame == 0) {
            begin = &p;
            next = *p.frame;
            n = 0;
            first.assign(p.rgb.size(), 0), rest = scale = first;
        }
        const bool other_scene =
            !p.fingerprint.empty() && !begin->fingerprint.empty() && p.fingerprint != begin->fingerprint;
        if (other_scene || *p.frame != next || p.width != begin->width || p.height != begin->height ||
            p.seed != begin->seed)
            return std::nullopt;
        ++next;
        if (*p.frame > 0) ++n;
        ModelSum sum{n, *begin->frame, *p.frame, {}, {}};
        for (size_t i = 0; i < p.rgb.size(); ++i) {
            const double value = std::isfinite(p.rgb[i]) ? p.rgb[i] : 0;  // as the manual says
            (*p.frame == 0 ? first : rest)[i] += value;
            scale[i] += std::fabs(value);
            sum.rgb.push_back(first[i] + (n ? rest[i] / double(n) : 0));
        }
        sum.scale = scale;
        sums.push_back(std::move(sum));
    }
    return sums;
}

}  // namespace breaking
