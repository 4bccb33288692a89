// SPDX-License-Identifier: BSD-3-Clause
// Writing: see exr_file.h.  Files are composed in memory, so that a full disk is noticed by one checked write.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfTileDescription.h>
#include <OpenEXR/ImfTiledOutputFile.h>

#include <algorithm>
#include <cstring>

#include "base/error.h"
#include "image/exr_file.h"
#include "image/exr_parts.h"
#include "image/header.h"
#include "image/stream.h"

namespace image {
namespace {

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

// One block of lines of every channel into a frame buffer, as halves or, uncopied, as they are.
class Lines {
public:
    Lines(bool half_floats, int width, const std::vector<ExrChannel>& channels)
        : half_(half_floats), width_(width), channels_(channels), halves_(channels.size()) {}
    Imf::FrameBuffer frame(int first, int count) {
        Imf::FrameBuffer buffer;
        for (size_t k = 0; k < channels_.size(); ++k) {
            const ExrChannel& c = channels_[k];
            if ((half_ || c.half) && !c.whole) {
                const float* from = static_cast<const float*>(c.first) + size_t(first) * width_ * c.stride;
                halves_[k].resize(size_t(count) * width_);
                for (size_t i = 0; i < halves_[k].size(); ++i) halves_[k][i] = half(from[i * c.stride]);
                // OpenEXR expects the address that line 0 would have
                char* origin = reinterpret_cast<char*>(halves_[k].data()) - ptrdiff_t(sizeof(half)) * width_ * first;
                buffer.insert(c.name, Imf::Slice(Imf::HALF, origin, sizeof(half), sizeof(half) * width_));
            } else {
                char* origin = static_cast<char*>(const_cast<void*>(c.first));
                buffer.insert(c.name, Imf::Slice(c.whole ? Imf::UINT : Imf::FLOAT, origin, sizeof(float) * c.stride,
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

std::string exr_bytes_of(const std::string& path, int width, int height, const std::vector<ExrChannel>& channels,
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
        Imf::addWhiteLuminance(h, float(lumens_per_watt));
        const auto& p = radiance_primaries;
        const auto xy = [&](int i) { return Imath::V2f(float(p[i]), float(p[i + 1])); };
        Imf::addChromaticities(h, Imf::Chromaticities(xy(0), xy(2), xy(4), xy(6)));
        for (const ExrChannel& c : channels)
            h.channels().insert(c.name, Imf::Channel(c.whole                  ? Imf::UINT
                                                     : options.half || c.half ? Imf::HALF
                                                                              : Imf::FLOAT));
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
    return std::move(memory.bytes);
}

void write_exr_channels(const std::string& path, int width, int height, const std::vector<ExrChannel>& channels,
                        const Header& header, const std::map<std::string, std::string>& texts,
                        const ExrOptions& options) {
    write_bytes(path, exr_bytes_of(path, width, height, channels, header, texts, options));
}

}  // namespace image
