// SPDX-License-Identifier: BSD-3-Clause
// Characters, lines and words of scene text.
#include "base/text_reader.h"
#include <cerrno>
#include <utility>
#include "base/descriptor.h"
#include "base/error.h"
#include "base/printable.h"
#include "base/split.h"
#include "base/text_file.h"

namespace base {

namespace {
constexpr size_t longest_word = 511;
inline bool space(int c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
}  // namespace

TextReader TextReader::from_file(const std::string& path, const Opener& by) {
    TextReader s;
    s.close_ = path != "-" || !by.place.empty();  // the standard input is the user's
    s.name_ = s.close_ ? path : "stdin";
    s.fd_ = s.close_ ? open_file(path, by) : 0;
    const FileStatus status = status_of(s.fd_);
    errno = 0;
    if (status.kind == FileKind::folder)
        fail_system(by.place.empty() ? path : by.place, "\"" + excerpt(path) + "\" is a directory");
    s.device = status.stamp.device;
    s.inode = s.close_ ? status.stamp.inode : 0;
    if (status.is_ordinary()) s.size = status.stamp.size;
    return s;
}

TextReader TextReader::from_text(std::string_view text, const std::string& name, uint32_t line) {
    TextReader s;
    s.at_ = text.data();
    s.end_ = s.at_ + text.size();
    s.name_ = name;
    s.line_ = line;
    s.counting_ = false;
    return s;
}

TextReader::TextReader(TextReader&& o) noexcept
    : device(o.device),
      inode(o.inode),
      size(o.size),
      fd_(std::exchange(o.fd_, -1)),
      close_(o.close_),
      counting_(o.counting_),
      buffer_(std::move(o.buffer_)),
      at_(o.at_),
      end_(o.end_),
      bytes_(o.bytes_),
      name_(std::move(o.name_)),
      line_(o.line_) {}

TextReader::~TextReader() {
    if (close_ && fd_ >= 0) close_descriptor(fd_);
}

// Fills the whole buffer if it can (pipes give less at a time), so that a header lies in the first one.
bool TextReader::refill() {
    if (fd_ < 0) return false;
    buffer_.resize(1 << 16);
    size_t have = 0;
    while (have < buffer_.size()) {
        const ssize_t n = read_some(fd_, buffer_.data() + have, buffer_.size() - have);
        if (n < 0) fail_system(name_, "read error");
        if (n == 0) break;
        have += size_t(n);
    }
    at_ = buffer_.data();
    end_ = at_ + have;
    if (bytes_ == 0 && begins_with(std::string_view(at_, have), byte_order_mark)) at_ += byte_order_mark.size();
    bytes_ += have;
    return have > 0;
}

std::string TextReader::header_format() {
    peek();
    const std::string_view text(at_, size_t(end_ - at_));
    if (text.substr(0, 2) != "#?") return "";
    std::string format;
    for (size_t i = 0; i < text.size();) {
        const size_t end = text.find('\n', i);
        if (end == std::string_view::npos) return "";
        std::string_view line = text.substr(i, end - i);
        if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        if (line.empty()) return format;
        if (line.substr(0, 7) == "FORMAT=") {
            line.remove_prefix(7);
            while (!line.empty() && line.back() == ' ') line.remove_suffix(1);
            while (!line.empty() && line.front() == ' ') line.remove_prefix(1);
            format = line;
        }
        i = end + 1;
    }
    return "";
}

bool TextReader::line(std::string& text, size_t longest) {
    text.clear();
    if (peek() < 0) return false;
    int c;
    while ((c = get()) >= 0 && c != '\n') {
        text += char(c);
        if (text.size() > longest) fail(place(), "the line is longer than " + std::to_string(longest) + " characters");
    }
    return true;
}

std::string TextReader::place() const { return name_ + ":" + std::to_string(line_); }

void TextReader::skip_space() {
    while (space(peek())) get();
}

void TextReader::skip_line() {
    int c;
    while ((c = get()) >= 0 && c != '\n') {}
}

bool TextReader::word(std::string_view& word) {
    skip_space();
    // Nearly always a whole plain word lies in the buffer: no copy.
    const char* p = at_;
    while (p<end_&& static_cast<unsigned char>(*p)> ' ' && *p != '"' && *p != '\'') p++;
    if (p > at_ && p < end_ && space(*p) && p - at_ <= ptrdiff_t(longest_word)) {
        word = {at_, size_t(p - at_)};
        at_ = p;
        return true;
    }
    if (peek() < 0) return false;
    word_.clear();
    const std::string start = place();
    int quote = 0, c;
    while ((c = peek()) >= 0 && (quote || !space(c))) {
        get();
        if (quote ? c == quote : c == '"' || c == '\'') quote = quote ? 0 : c;
        else word_ += char(c);
        if (word_.size() > longest_word) fail(start, "word \"" + excerpt(word_) + "\" is longer than 511 characters");
    }
    if (quote) fail(start, "a quoted word does not end");
    word = word_;
    return true;
}

std::string TextReader::rest_of_line() {
    std::string line;
    int c;
    while ((c = get()) >= 0 && (c != '\n' || ends_with(line, "\\") || ends_with(line, "\\\r"))) {
        line += char(c);
        if (line.size() > (1 << 20)) fail(place(), "the command is longer than a million characters");
    }
    while (!line.empty() && line.back() == '\r') line.pop_back();
    return line;
}

}  // namespace base
