// SPDX-License-Identifier: BSD-3-Clause
// See exr_parts.h.
#include "image/exr_parts.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfTileDescription.h>

#include <algorithm>
#include <map>

#include "base/error.h"

namespace image {
namespace {

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

}  // namespace

std::string one_line(const char* text) {
    std::string s = text;
    std::replace(s.begin(), s.end(), '\n', ' ');
    return s;
}

// Checks every header: a file of several parts has several, and an empty one ends them.
void check_attributes(Imf::IStream& in, uint64_t end, const std::string& path) {
    const auto left = [&] { return int64_t(end) - int64_t(in.tellg()); };
    const auto read = [&](std::string& to) {  // as many bytes as it has; false where the file ends before
        if (left() < int64_t(to.size())) return false;
        constexpr size_t most = 1 << 20;  // OpenEXR counts bytes in an int
        for (size_t at = 0; at < to.size(); at += most) in.read(&to[at], int(std::min(to.size() - at, most)));
        return true;
    };
    const auto word = [&](std::string& to) {  // up to its NUL
        to.clear();
        for (std::string c(1, ' '); read(c); to += c)
            if (c[0] == '\0') return true;
        return false;
    };
    std::string start(8, '\0');
    in.seekg(0);
    if (!read(start)) return;
    const bool parts = (uint8_t(start[5]) & 0x10) != 0;
    bool any = false;
    for (std::string name, type, size(4, '\0'); word(name);) {
        if (name.empty()) {
            if (!parts || !any) return;
            any = false;
            continue;
        }
        any = true;
        if (!word(type) || !read(size)) return;
        const int64_t bytes = number_at(size, 0);
        const std::string what = "is not a readable OpenEXR file: attribute " + name.substr(0, 32);
        if (bytes < 0 || bytes > left()) base::fail(path, what + " is longer than the file");
        std::string value(size_t(bytes), '\0');
        if (!read(value)) return;
        if (!fits(type, value)) base::fail(path, what + " does not have the length of its type");
    }
}

void check_windows(const Imf::Header& h, const std::string& path) {
    const Imath::Box2i shown = h.displayWindow(), data = h.dataWindow();
    const auto meet = [](int64_t least, int64_t most) { return std::max<int64_t>(most - least + 1, 0); };
    const int64_t across = meet(std::max(shown.min.x, data.min.x), std::min(shown.max.x, data.max.x)),
                  down = meet(std::max(shown.min.y, data.min.y), std::min(shown.max.y, data.max.y));
    if (across * down == 0) base::fail(path, "its data window holds nothing of its display window");
    const int64_t all = meet(shown.min.x, shown.max.x) * meet(shown.min.y, shown.max.y);
    if (across * down < all)
        base::warn(path, std::to_string(all - across * down) + " of its " + std::to_string(all) +
                             " pixels are outside its data window: they are black");
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

}  // namespace image
