// SPDX-License-Identifier: BSD-3-Clause
// A 64-bit hash: different contents collide with probability 2^-64; not safe against deliberate
// collisions.  Each word is mixed in by an odd multiplier and a shift, as in the finaliser of splitmix64
// (Steele, Lea, Flood 2014).
#pragma once
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <initializer_list>
#include <string>

namespace base {

class Hash {
public:
    void add(std::initializer_list<uint64_t> words) {
        for (const uint64_t word : words) mix(word);
    }
    // Elements without padding: numbers, characters.
    template <class Container>
    void add_all(const Container& values) {
        add_bytes(values.data(), values.size() * sizeof(*values.data()));
    }
    std::string text() const {  // 16 hexadecimal digits
        char digits[17];
        std::snprintf(digits, sizeof digits, "%016llx", (unsigned long long)state_);
        return digits;
    }

private:
    void mix(uint64_t word) {
        state_ = (state_ ^ word) * 0xbf58476d1ce4e5b9u;
        state_ ^= state_ >> 29;
    }
    void add_bytes(const void* data, size_t bytes) {
        const char* at = static_cast<const char*>(data);
        mix(bytes);
        for (; bytes >= 8; bytes -= 8, at += 8) {
            uint64_t word;
            std::memcpy(&word, at, 8);
            mix(word);
        }
        uint64_t rest = 0;
        if (bytes) std::memcpy(&rest, at, bytes);  // nothing may be at no address
        mix(rest);
    }
    uint64_t state_ = 0x9e3779b97f4a7c15u;
};

template <class Container>
std::string hash_of(const Container& values) {
    Hash hash;
    hash.add_all(values);
    return hash.text();
}

}  // namespace base
