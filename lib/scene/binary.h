// SPDX-License-Identifier: BSD-3-Clause
// Numbers and strings of RADIANCE's portable binary files: big-endian integers, 5-byte reals, NUL-terminated strings.
#pragma once
#include <cstdint>
#include <string>
#include "base/text_reader.h"

namespace scene {

class Binary {
public:
    explicit Binary(base::TextReader& in) : in_(in) {}
    std::vector<std::string> header();  // "#?" lines up to the empty one
    int byte();                         // 0..255; the end of the file throws
    int64_t integer(int bytes);         // two's complement, 1 to 8 bytes
    uint64_t unsigned_integer(int bytes);
    double real();       // 4-byte mantissa, 1-byte exponent
    double text_real();  // a number as a string
    std::string text();  // at most 64 KB
    void skip(uint64_t bytes);
    [[noreturn]] void fail(const std::string& fact) const;
    base::TextReader& source() { return in_; }

private:
    base::TextReader& in_;
};

}  // namespace scene
