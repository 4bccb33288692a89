// SPDX-License-Identifier: BSD-3-Clause
// JSON: the one place where it is written.
#pragma once
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace live::json {
std::string text(const std::string& s);  // quoted; bytes that are no UTF-8 become '?'
std::string number(double v);            // as many digits as it takes; null where it is not finite
inline std::string truth(bool v) { return v ? "true" : "false"; }

template <class ITEMS, class WRITE>
std::string list_of(const ITEMS& items, WRITE&& write) {
    std::string out = "[";
    for (const auto& item : items) out += (out.size() > 1 ? "," : "") + write(item);
    return out + "]";
}
std::string list(const std::vector<std::string>& items);             // of texts
inline std::string pair(int64_t number, const std::string& value) {  // which is JSON already
    return "[" + std::to_string(number) + "," + value + "]";
}
std::string numbers(const std::vector<double>& values);
// Names, and values that are JSON already.
using Members = std::vector<std::pair<const char*, std::string>>;
std::string object(const Members& members);
}  // namespace live::json
