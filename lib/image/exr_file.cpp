// SPDX-License-Identifier: BSD-3-Clause
// See exr_file.h.  Files are composed in memory, so that a full disk is noticed by one checked write.
#include "image/exr_file.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfTileDescription.h>
#include <OpenEXR/ImfTiledOutputFile.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>

#include "base/error.h"
#include "image/header.h"
#include "image/stream.h"

namespace image {
namespace {

constexpr int most_side = 32768, block_lines = 64;
constexpr int64_t most_block = 256 << 20;  // bytes of a tile or of the lines that are decoded together

std::string one_line(const char* text) {
    std::string s = text;
    std::replace(s.begin(), s.end(), '\n', ' ');
    return s;
}

int32_t number_at(const std::string& bytes, size_t at) {
    uint32_t n = 0;
    for (size_t k = 0; k < 4 && at + k < bytes.size(); ++k) n |= uint32_t(uint8_t(bytes[at + k])) << (8 * k);
    return int32_t(n);
}

// OpenEXR 3.1 reserves what an attribute's length says before it reads it, and goes by the type where that disagrees.
bool fits(const std::string& type, const std::string& value) {
    static const std::map<std::string, size_t> fixed = {{"box2f", 16},
                                                        {"box2i", 16},
                                                        {"chromaticities", 32},
                                                        {"compression", 1},
                                                        {"deepImageState", 1},
                                                        {"double", 8},
                                                        {"envmap", 1},
                                                        {"float", 4},
                                                        {"int", 4},
                                                        {"keycode", 28},
                                                        {"lineOrder", 1},
                                                        {"m33d", 72},
                                                        {"m33f", 36},
                                                        {"m44d", 128},
                                                        {"m44f", 64},
                                                        {"rational", 8},
                                                        {"tiledesc", 9},
                                                        {"timecode", 8},
                                                        {"v2d", 16},
                                                        {"v2f", 8},
                                                        {"v2i", 8},
                                                        {"v3d", 24},
                                                        {"v3f", 12},
                                                        {"v3i", 12}};
    if (const auto f = fixed.find(type); f != fixed.end()) return value.size() == f->second;
    size_t at = 0;
    if (type == "chlist") {  // name, 16 bytes, ..., empty name
        for (size_t end; (end = value.find('\0', at)) != std::string::npos; at = end + 17)
            if (end == at) return end + 1 == value.size();
        return false;
    }
    if (type == "preview") {
        const int64_t w = uint32_t(number_at(value, 0)), h = uint32_t(number_at(value, 4));
        return value.size() >= 8 && w < 65536 && h < 65536 && int64_t(value.size()) == 8 + 4 * w * h;
    }
    if (type == "stringvector") {
        while (at + 4 <= value.size()) {
            const int32_t n = number_at(value, at);
            if (n < 0 || size_t(n) > value.size() - at - 4) return false;
            at += 4 + size_t(n);
        }
        return at == value.size();
    }
    return true;
}

// Of every header: a file of several parts has several, and an empty one ends them.
void check_attributes(std::istream& in, const std::string& path) {
    const int64_t end = in.seekg(0, std::ios::end).tellg();
    char start[8] = {};
    in.seekg(0).read(start, 8);
    const bool parts = (uint8_t(start[5]) & 0x10) != 0;
    bool any = false;
    for (std::string name, type, size(4, '\0'); std::getline(in, name, '\0');) {
        if (name.empty()) {
            if (!parts || !any) return;
            any = false;
            continue;
        }
        any = true;
        if (!std::getline(in, type, '\0') || !in.read(size.data(), 4)) return;
        const int64_t bytes = number_at(size, 0);
        const std::string what = "is no readable OpenEXR file: attribute " + name.substr(0, 32);
        if (bytes < 0 || bytes > end - in.tellg()) base::fail(path, what + " is longer than the file");
        std::string value(size_t(bytes), '\0');
        if (!in.read(value.data(), bytes)) return;
        if (!fits(type, value)) base::fail(path, what + " has not the length of its type");
    }
}

int lines_together(Imf::Compression c) {
    switch (c) {
    case Imf::NO_COMPRESSION:
    case Imf::RLE_COMPRESSION:
    case Imf::ZIPS_COMPRESSION: return 1;
    case Imf::ZIP_COMPRESSION:
    case Imf::PXR24_COMPRESSION: return 16;
    case Imf::DWAB_COMPRESSION: return 256;
    default: return 32;
    }
}

void check_blocks(const Imf::Header& h, const std::string& path) {
    int64_t bytes = 0;
    for (auto c = h.channels().begin(); c != h.channels().end(); ++c) bytes += c.channel().type == Imf::HALF ? 2 : 4;
    const Imath::Box2i data = h.dataWindow();
    const bool tiled = h.hasTileDescription();
    const int64_t across = tiled ? int64_t(h.tileDescription().xSize) : int64_t(data.max.x) - data.min.x + 1;
    const int64_t down = tiled ? int64_t(h.tileDescription().ySize) : lines_together(h.compression());
    if (across * down > most_block / std::max<int64_t>(bytes, 1))
        base::fail(path, std::string("its ") + (tiled ? "tiles" : "blocks of lines") +
                             " are too large: " + std::to_string(across) + " x " + std::to_string(down) +
                             " pixels of " + std::to_string(bytes) + " bytes");
}

class MemoryOut : public Imf::OStream {
public:
    MemoryOut() : Imf::OStream("memory") {}
    void write(const char c[], int n) override {
        if (bytes.size() < at_ + size_t(n)) bytes.resize(at_ + size_t(n));
        std::memcpy(&bytes[at_], c, size_t(n));
        at_ += size_t(n);
    }
    uint64_t tellp() override { return at_; }
    void seekp(uint64_t pos) override { at_ = pos; }
    std::string bytes;

private:
    size_t at_ = 0;
};

Imf::Compression compression_of(const std::string& name) {
    const std::pair<const char*, Imf::Compression> known[] = {
        {"none", Imf::NO_COMPRESSION},  {"rle", Imf::RLE_COMPRESSION},   {"zips", Imf::ZIPS_COMPRESSION},
        {"zip", Imf::ZIP_COMPRESSION},  {"piz", Imf::PIZ_COMPRESSION},   {"pxr24", Imf::PXR24_COMPRESSION},
        {"b44", Imf::B44_COMPRESSION},  {"b44a", Imf::B44A_COMPRESSION}, {"dwaa", Imf::DWAA_COMPRESSION},
        {"dwab", Imf::DWAB_COMPRESSION}};
    for (const auto& [text, code] : known)
        if (name == text) return code;
    base::fail("compression", "\"" + name + "\" is not one of none rle zips zip piz pxr24 b44 b44a dwaa dwab");
}

// One block of lines of every channel into a frame buffer, as halves or, uncopied, as floats.
class Lines {
public:
    Lines(bool half_floats, int width, const std::vector<ExrChannel>& channels)
        : half_(half_floats), width_(width), channels_(channels), halves_(half_floats ? channels.size() : 0) {}
    Imf::FrameBuffer frame(int first, int count) {
        Imf::FrameBuffer buffer;
        for (size_t k = 0; k < channels_.size(); ++k) {
            const ExrChannel& c = channels_[k];
            const float* from = c.first + size_t(first) * width_ * c.stride;
            if (half_) {
                halves_[k].resize(size_t(count) * width_);
                for (size_t i = 0; i < halves_[k].size(); ++i) halves_[k][i] = half(from[i * c.stride]);
                // OpenEXR wants the address that line 0 would have
                char* origin = reinterpret_cast<char*>(halves_[k].data()) - ptrdiff_t(sizeof(half)) * width_ * first;
                buffer.insert(c.name, Imf::Slice(Imf::HALF, origin, sizeof(half), sizeof(half) * width_));
            } else {
                char* origin = reinterpret_cast<char*>(const_cast<float*>(c.first));
                buffer.insert(c.name, Imf::Slice(Imf::FLOAT, origin, sizeof(float) * c.stride,
                                                 sizeof(float) * c.stride * width_));
            }
        }
        return buffer;
    }

private:
    bool half_;
    int width_;
    const std::vector<ExrChannel>& channels_;
    std::vector<std::vector<half>> halves_;
};

}  // namespace

struct ExrInput::File {
    Imf::MultiPartInputFile parts;  // reads headers only
    Imf::InputPart in;
    explicit File(const std::string& path) : parts(path.c_str()), in((check_blocks(parts.header(0), path), parts), 0) {}
};

ExrInput::ExrInput(const std::string& path) : path_(path) {
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    if (!file) base::fail_system(path, "cannot be read");
    check_attributes(file, path);
    Imf::Header::setMaxImageSize(most_side, most_side);  // before OpenEXR reserves anything
    Imf::Header::setMaxTileSize(most_side, most_side);
    try {
        file_.reset(new File(path));
        const Imath::Box2i shown = file_->in.header().displayWindow();
        const int64_t w = int64_t(shown.max.x) - shown.min.x + 1, h = int64_t(shown.max.y) - shown.min.y + 1;
        if (w < 1 || h < 1 || w > most_side || h > most_side)
            base::fail(path, "picture size is not within 1.." + std::to_string(most_side));
        width_ = int(w);
        height_ = int(h);
    } catch (const base::Error&) {
        throw;
    } catch (const std::exception& e) {
        base::fail(path, "is no readable OpenEXR file: " + one_line(e.what()));
    }
}

ExrInput::~ExrInput() = default;

std::vector<std::string> ExrInput::channels() const {
    std::vector<std::string> names;
    const Imf::ChannelList& list = file_->in.header().channels();
    for (auto c = list.begin(); c != list.end(); ++c) names.push_back(c.name());
    return names;
}

bool ExrInput::has(const std::string& channel) const {
    return file_->in.header().channels().findChannel(channel) != nullptr;
}

std::vector<float> ExrInput::read(const std::vector<std::string>& names) const {
    const size_t n = names.size();
    std::vector<float> out;
    try {
        const Imf::Header& header = file_->in.header();
        for (const std::string& name : names) {
            const Imf::Channel* c = header.channels().findChannel(name);
            if (!c) base::fail(path_, "has no channel " + name);
            if (c->xSampling != 1 || c->ySampling != 1)
                base::fail(path_, "channel " + name + " is subsampled: not read");
        }
        const Imath::Box2i shown = header.displayWindow(), data = header.dataWindow();
        const size_t data_width = size_t(data.max.x - data.min.x + 1);
        const int lines = int(std::clamp<int64_t>(
            most_block / int64_t(sizeof(float) * std::max<size_t>(n, 1) * data_width), 1, block_lines));
        std::vector<float> block(data_width * size_t(lines) * n);
        for (int y = data.min.y; y <= data.max.y; y += lines) {
            const int last = std::min(y + lines - 1, data.max.y);
            Imf::FrameBuffer frame;
            for (size_t c = 0; c < n; ++c) {
                // OpenEXR wants the address that pixel (0,0) would have
                char* origin = reinterpret_cast<char*>(block.data() + c) -
                               ptrdiff_t(sizeof(float) * n) * (data.min.x + ptrdiff_t(data_width) * y);
                frame.insert(names[c],
                             Imf::Slice(Imf::FLOAT, origin, sizeof(float) * n, sizeof(float) * n * data_width));
            }
            file_->in.setFrameBuffer(frame);
            file_->in.readPixels(y, last);
            const int top = std::max(y, shown.min.y), bottom = std::min(last, shown.max.y);
            const int left = std::max(data.min.x, shown.min.x), right = std::min(data.max.x, shown.max.x);
            for (int row = top; row <= bottom && left <= right; ++row) {
                const float* from = &block[n * (size_t(row - y) * data_width + size_t(left - data.min.x))];
                const size_t at = n * (size_t(row - shown.min.y) * width_ + size_t(left - shown.min.x));
                if (out.size() < at + n * width_) out.resize(at + n * width_);
                std::copy(from, from + n * size_t(right - left + 1), &out[at]);
            }
        }
        out.resize(n * width_ * size_t(height_));
    } catch (const base::Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& e) {
        base::fail(path_, "is a broken OpenEXR file: " + one_line(e.what()));
    }
    return out;
}

std::map<std::string, std::string> ExrInput::texts() const {
    std::map<std::string, std::string> all;
    const Imf::Header& h = file_->in.header();
    for (auto a = h.begin(); a != h.end(); ++a)
        if (const auto* s = dynamic_cast<const Imf::StringAttribute*>(&a.attribute())) all[a.name()] = s->value();
    return all;
}

std::optional<std::string> ExrInput::text(const std::string& attribute) const {
    const auto all = texts();
    const auto found = all.find(attribute);
    if (found == all.end()) return std::nullopt;
    return found->second;
}

Header ExrInput::header() const {
    Header h;
    Encoding unused;
    if (const auto lines = text("radianceHeader")) {
        std::istringstream in(*lines);
        for (std::string line; std::getline(in, line);) parse_header_line(line, h, unused, path_);
    } else {
        for (const auto& [name, value] : texts())
            if (!name.empty() && value.find('\n') == std::string::npos)
                parse_header_line((name == "view" ? "VIEW" : name) + "=" + value, h, unused, path_);
        h.pixel_aspect = 1 / std::max(1e-6f, file_->in.header().pixelAspectRatio());
    }
    h.exposure = 1;  // the pixels carry no exposure
    return h;
}

double ExrInput::white_luminance() const {
    const Imf::Header& h = file_->in.header();
    return Imf::hasWhiteLuminance(h) && Imf::whiteLuminance(h) > 0 ? Imf::whiteLuminance(h) : 179;
}

std::optional<std::array<double, 8>> ExrInput::primaries() const {
    const Imf::Header& h = file_->in.header();
    if (!Imf::hasChromaticities(h)) return std::nullopt;
    const Imf::Chromaticities& c = Imf::chromaticities(h);
    return std::array<double, 8>{c.red.x, c.red.y, c.green.x, c.green.y, c.blue.x, c.blue.y, c.white.x, c.white.y};
}

void write_exr_channels(const std::string& path, int width, int height, const std::vector<ExrChannel>& channels,
                        const Header& header, const std::map<std::string, std::string>& texts,
                        const ExrOptions& options) {
    const Imf::Compression compression = compression_of(options.compression);
    MemoryOut memory;
    try {
        Imf::Header h(width, height, float(1 / header.pixel_aspect));
        h.compression() = compression;
        std::string lines;
        for (const std::string& line : header_lines(header)) lines += line + "\n";
        h.insert("radianceHeader", Imf::StringAttribute(lines));
        if (header.view) h.insert("VIEW", Imf::StringAttribute(view::to_options(*header.view)));
        for (const auto& [name, value] : texts) h.insert(name, Imf::StringAttribute(value));
        Imf::addWhiteLuminance(h, 179);
        const auto& p = radiance_primaries;
        const auto xy = [&](int i) { return Imath::V2f(float(p[i]), float(p[i + 1])); };
        Imf::addChromaticities(h, Imf::Chromaticities(xy(0), xy(2), xy(4), xy(6)));
        for (const ExrChannel& c : channels)
            h.channels().insert(c.name, Imf::Channel(options.half ? Imf::HALF : Imf::FLOAT));
        Lines lines_of(options.half, width, channels);
        if (options.tiled) {
            h.setTileDescription(Imf::TileDescription(64, 64, Imf::ONE_LEVEL));
            Imf::TiledOutputFile file(memory, h);
            file.setFrameBuffer(lines_of.frame(0, height));
            file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
        } else {
            Imf::OutputFile file(memory, h);
            for (int y = 0; y < height; y += block_lines) {
                const int count = std::min(block_lines, height - y);
                file.setFrameBuffer(lines_of.frame(y, count));
                file.writePixels(count);
            }
        }
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& e) {
        base::fail(path, "cannot be written as OpenEXR: " + one_line(e.what()));
    }
    write_bytes(path, memory.bytes);
}

}  // namespace image
