// SPDX-License-Identifier: BSD-3-Clause
// See printable.h.
#include "base/printable.h"

#include <cstdint>
#include <cstdio>

namespace base {
namespace {

// Length of the UTF-8 character at the beginning; 0: it is none, or one that steers a terminal (U+0080 to U+009F).
size_t character(std::string_view text) {
    const auto byte = [&](size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char c = byte(0);
    if (c < 0x80) return c >= ' ' && c != 127;
    const size_t length = c >= 0xf0 && c < 0xf5 ? 4 : c >= 0xe0 && c < 0xf0 ? 3 : c >= 0xc2 && c < 0xe0 ? 2 : 0;
    if (length == 0 || length > text.size()) return 0;
    for (size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xc0) != 0x80) return 0;
    const bool steers = c == 0xc2 && byte(1) < 0xa0;
    const bool overlong = (c == 0xe0 && byte(1) < 0xa0) || (c == 0xf0 && byte(1) < 0x90);
    const bool surrogate = c == 0xed && byte(1) >= 0xa0, beyond = c == 0xf4 && byte(1) >= 0x90;
    return steers || overlong || surrogate || beyond ? 0 : length;
}

}  // namespace

std::string printable(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const size_t n = character(text);
        if (n) out += text.substr(0, n);
        else out += '?';
        text.remove_prefix(n ? n : 1);
    }
    return out;
}

std::string quoted_json(const std::string& s) {
    std::string out = "\"";
    char code[8];
    for (size_t k = 0; k < s.size(); ++k) {
        const unsigned char c = static_cast<unsigned char>(s[k]);
        if (c == '"' || c == '\\') {
            out += '\\';
            out += char(c);
        } else if (c == '\t') {
            out += "\\t";
        } else if (c < 0x20 || c == 0x7f) {
            std::snprintf(code, sizeof code, "\\u%04x", c);
            out += code;
        } else if (c >= 0x80) {  // JSON is UTF-8
            size_t end = k + 1;
            while (end < s.size() && static_cast<unsigned char>(s[end]) >= 0x80) ++end;
            out += printable(std::string_view(s).substr(k, end - k));
            k = end - 1;
        } else out += char(c);
    }
    return out + "\"";
}

std::string excerpt(std::string_view text, size_t longest) {
    return text.size() > longest ? printable(text.substr(0, longest)) + "..." : printable(text);
}

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : printable(text)) {
        if (c == '&') out += "&amp;";
        else if (c == '<') out += "&lt;";
        else if (c == '>') out += "&gt;";
        else if (c == '"') out += "&quot;";
        else if (c == '\'') out += "&#39;";
        else out += c;
    }
    return out;
}

std::string base64(const std::string& bytes) {
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    out.reserve(bytes.size() * 4 / 3 + 4);
    for (size_t k = 0; k < bytes.size(); k += 3) {
        uint32_t three = 0;
        for (size_t i = 0; i < 3; ++i)
            three = three << 8 | (k + i < bytes.size() ? static_cast<unsigned char>(bytes[k + i]) : 0);
        for (size_t i = 0; i < 4; ++i) out += k + i <= bytes.size() ? digits[three >> (18 - 6 * i) & 63] : '=';
    }
    return out;
}

}  // namespace base
