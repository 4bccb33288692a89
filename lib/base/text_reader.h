// SPDX-License-Identifier: BSD-3-Clause
// Text as characters, words and lines, with the line that each stands on: scene files, and what they name.  White space
// separates words; a word may hold quoted parts ('..' or "..", quotes removed); at most 511 characters.  Files are read
// in pieces, so their size does not matter.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>
#include "base/open_file.h"

namespace base {

class TextReader {
public:
    static TextReader from_file(const std::string& path, const Opener& by);  // "-" = stdin
    static TextReader from_text(std::string_view text, const std::string& name,
                                uint32_t line);  // every line counts as this one
    TextReader(TextReader&&) noexcept;
    TextReader& operator=(TextReader&&) = delete;
    ~TextReader();

    int peek() { return at_ < end_ || refill() ? static_cast<unsigned char>(*at_) : -1; }
    int get() {
        const int c = peek();
        if (c >= 0) at_++, line_ += c == '\n' && counting_;
        return c;
    }
    // For binary files: the unread bytes in the buffer; consume() skips bytes without counting lines.
    std::string_view buffered() const { return {at_, size_t(end_ - at_)}; }
    void consume(size_t bytes) { at_ += bytes; }
    void skip_space();
    void skip_line();
    // The next word into `word` (valid until the next call); false at the end of the text.
    bool word(std::string_view& word);
    bool line(std::string& text, size_t longest);  // up to the newline; false at the end; longer: Error
    // FORMAT= of a "#?" header that stands at the beginning; "" if there is none.  Nothing is consumed.
    std::string header_format();
    std::string rest_of_line();  // "\<newline>" goes on, both bytes kept; the newline is consumed

    const std::string& name() const { return name_; }
    uint32_t line() const { return line_; }
    uint64_t bytes() const { return bytes_; }  // of the file, read so far
    std::string place() const;
    uint64_t device = 0, inode = 0;  // of a file, to recognise one that includes itself
    uint64_t size = 0;               // in bytes, of an ordinary file; 0: not known

private:
    TextReader() = default;
    bool refill();
    int fd_ = -1;
    bool close_ = false, counting_ = true;
    std::vector<char> buffer_;
    const char *at_ = nullptr, *end_ = nullptr;
    uint64_t bytes_ = 0;
    std::string name_;
    uint32_t line_ = 1;
    std::string word_;
};

}  // namespace base
