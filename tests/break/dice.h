// SPDX-License-Identifier: BSD-3-Clause
// Random choices of one trial: they depend on (seed, trial) alone, so that any trial can be run again by itself.
// Generator: splitmix64 (Steele, Lea, Flood 2014).
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace breaking {

class Dice {
public:
    Dice(uint64_t seed, uint64_t trial) : state_(seed * 0xd1342543de82ef95u + trial * 0x2545f4914f6cdd1du) { next(); }

    uint64_t next() {
        uint64_t z = state_ += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    size_t below(size_t n) { return n ? size_t(next() % n) : 0; }  // 0 .. n-1
    int within(int from, int to) { return from + int(below(size_t(to - from) + 1)); }
    double unit() { return double(next() >> 11) / 9007199254740992.0; }  // [0, 1)
    bool chance(double p) { return unit() < p; }

    template <class T>
    const T& pick(const std::vector<T>& from) {
        return from[below(from.size())];
    }

private:
    uint64_t state_;
};

// "a b c" as a vector; a table that reads as one.
inline std::vector<std::string> choices(const std::string& text, char between = ' ') {
    std::vector<std::string> all;
    for (size_t at = 0, end; at <= text.size(); at = end + 1) {
        end = std::min(text.find(between, at), text.size());
        all.push_back(text.substr(at, end - at));
    }
    return all;
}

}  // namespace breaking
