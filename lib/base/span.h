// SPDX-License-Identifier: BSD-3-Clause
// A borrowed run of values: first and count (C++17 has no std::span).
#pragma once
#include <cstddef>

namespace base {

template <class T>
struct Span {
    const T* first = nullptr;
    size_t count = 0;
    const T* begin() const { return first; }
    const T* end() const { return first + count; }
    const T* data() const { return first; }
    size_t size() const { return count; }
    const T& operator[](size_t i) const { return first[i]; }
};

}  // namespace base
