// SPDX-License-Identifier: BSD-3-Clause
// Numbers and strings as RADIANCE's binary files hold them, for the scenes that benchmarks make.
#pragma once
#include <cmath>
#include <cstdio>
#include <string>

inline void put(FILE* f, long long v, int bytes) {
    while (bytes-- > 0) std::putc(int(v >> (8 * bytes) & 255), f);
}
inline void put_real(FILE* f, double v) {
    int e = 0;
    const double m = std::frexp(v, &e);
    put(f, v == 0 ? 0 : (long long)(m * 0x7fffffff), 4);
    put(f, v == 0 ? 0 : e, 1);
}
inline void put_text(FILE* f, const std::string& s) { std::fwrite(s.c_str(), 1, s.size() + 1, f); }
