// SPDX-License-Identifier: BSD-3-Clause
// See sha256.h.  FIPS 180-4, sections 4.1.2, 4.2.2 and 6.2, with its names.
#include "base/sha256.h"

#include <array>
#include <cstdint>
#include <cstdio>

#include "base/descriptor.h"
#include "base/error.h"
#include "base/open_file.h"

namespace base {

namespace {

constexpr std::array<uint32_t, 64> K = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

class Sha256 {
public:
    void add(const char* bytes, size_t n) {
        length_ += n;
        for (; n > 0; --n, ++bytes) {
            block_[used_++] = uint8_t(*bytes);
            if (used_ == block_.size()) take_block();
        }
    }
    std::string text() {
        const uint64_t bits = 8 * length_;
        add("\x80", 1);
        while (used_ != 56) add("", 1);  // zeros
        for (int shift = 56; shift >= 0; shift -= 8) block_[used_++] = uint8_t(bits >> shift);
        take_block();
        char digits[65];
        for (size_t k = 0; k < 8; ++k) std::snprintf(digits + 8 * k, 9, "%08x", H_[k]);
        return digits;
    }

private:
    static uint32_t rotr(uint32_t x, int n) { return x >> n | x << (32 - n); }
    void take_block() {
        std::array<uint32_t, 64> W;
        for (size_t t = 0; t < 16; ++t)
            W[t] = uint32_t(block_[4 * t]) << 24 | uint32_t(block_[4 * t + 1]) << 16 |
                   uint32_t(block_[4 * t + 2]) << 8 | block_[4 * t + 3];
        for (size_t t = 16; t < 64; ++t)
            W[t] = (rotr(W[t - 2], 17) ^ rotr(W[t - 2], 19) ^ W[t - 2] >> 10) + W[t - 7] +
                   (rotr(W[t - 15], 7) ^ rotr(W[t - 15], 18) ^ W[t - 15] >> 3) + W[t - 16];
        auto [a, b, c, d, e, f, g, h] = H_;
        for (size_t t = 0; t < 64; ++t) {
            const uint32_t T1 = h + (rotr(e, 6) ^ rotr(e, 11) ^ rotr(e, 25)) + ((e & f) ^ (~e & g)) + K[t] + W[t];
            const uint32_t T2 = (rotr(a, 2) ^ rotr(a, 13) ^ rotr(a, 22)) + ((a & b) ^ (a & c) ^ (b & c));
            h = g, g = f, f = e, e = d + T1, d = c, c = b, b = a, a = T1 + T2;
        }
        const std::array<uint32_t, 8> added = {a, b, c, d, e, f, g, h};
        for (size_t k = 0; k < 8; ++k) H_[k] += added[k];
        used_ = 0;
    }
    std::array<uint32_t, 8> H_ = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                  0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
    std::array<uint8_t, 64> block_ = {};
    size_t used_ = 0;
    uint64_t length_ = 0;
};

}  // namespace

std::string sha256(const std::string& bytes) {
    Sha256 hash;
    hash.add(bytes.data(), bytes.size());
    return hash.text();
}

std::string sha256_of_file(const std::string& path, const Overlays& overlays) {
    const int file = open_file(path, {"", &overlays});
    Sha256 hash;
    char block[1 << 16];
    ssize_t n;
    while ((n = read_some(file, block, sizeof block)) > 0) hash.add(block, size_t(n));
    close_descriptor(file);
    if (n < 0) fail_system(path, "cannot be read");
    return hash.text();
}

}  // namespace base
