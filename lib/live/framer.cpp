// SPDX-License-Identifier: BSD-3-Clause
// See framer.h.
#include "live/framer.h"

#include <algorithm>
#include <cstdio>
#include <cstring>

#include "base/error.h"
#include "image/header.h"

namespace live {

namespace {
constexpr size_t longest_header = 1 << 20;
constexpr int longest_side = 32768;
constexpr size_t largest_picture = size_t(1) << 30;  // bytes of pixels

bool host_is_little_endian() {
    const uint16_t one = 1;
    char first = 0;
    std::memcpy(&first, &one, 1);
    return first == 1;
}
}  // namespace

void Framer::pass(const char* data, size_t bytes) {
    while (bytes > 0 && stopped_.empty()) {
        const size_t used = left_ > 0 ? pixels(data, bytes) : header(data, bytes);
        data += used;
        bytes -= used;
    }
}

// Line by line until the resolution line.
size_t Framer::header(const char* data, size_t bytes) {
    const char* end = static_cast<const char*>(std::memchr(data, '\n', bytes));
    const size_t used = end ? size_t(end - data) + 1 : bytes;
    const size_t line = head_.rfind('\n') == std::string::npos ? 0 : head_.rfind('\n') + 1;
    head_.append(data, used);
    if (head_.size() > longest_header) return stop("a header is too long"), bytes;
    if (!end) return used;
    if (resolution_) begin_pixels();
    else if (head_.size() - line == 1) resolution_ = true;  // an empty line
    return used;
}

void Framer::begin_pixels() {
    image::Picture picture;
    image::Encoding encoding;
    std::vector<std::string> lines;
    for (size_t at = 0; at < head_.size();) {
        const size_t end = head_.find('\n', at);
        lines.push_back(head_.substr(at, end - at));
        at = end + 1;
    }
    head_.clear();
    resolution_ = false;
    try {
        for (size_t k = 0; k + 2 < lines.size(); ++k)
            image::parse_header_line(lines[k], picture.header, encoding, "stdin");
    } catch (const base::Error& e) {
        return stop(e.message);
    }
    int width = 0, height = 0;
    const int read = std::sscanf(lines.back().c_str(), "-Y %d +X %d", &height, &width);
    if (encoding.format != image::Format::flt) return stop("the pixels are no floats (ptaccum -ff)");
    if (read != 2 || width < 1 || height < 1 || width > longest_side || height > longest_side)
        return stop("the pictures are not in standard orientation");
    const size_t channels = encoding.moments ? image::moment_numbers : 3;
    if (encoding.big_endian.value_or(false) || !host_is_little_endian() || encoding.channels != int(channels))
        return stop("the pixels are not those of ptaccum");
    layer_ = encoding.moments;
    left_ = sizeof(float) * channels * size_t(width) * size_t(height);
    if (left_ > largest_picture) return stop("the pictures are too large");
    picture.width = width;
    picture.height = height;
    picture.floats = true;
    picture_ = std::move(picture);
    values_.assign(left_ / sizeof(float), 0);
}

size_t Framer::pixels(const char* data, size_t bytes) {
    const size_t used = std::min(bytes, left_);
    char* to = reinterpret_cast<char*>(values_.data()) + (sizeof(float) * values_.size() - left_);
    std::memcpy(to, data, used);
    left_ -= used;
    if (left_ > 0 || layer_) return used;
    const float exposure = float(1 / picture_.header.exposure);
    if (exposure != 1)
        for (float& v : values_) v *= exposure;
    picture_.rgb = std::move(values_);
    taken_(std::move(picture_));
    picture_ = {};
    return used;
}

}  // namespace live
