// SPDX-License-Identifier: BSD-3-Clause
// See json.h.
#include "live/json.h"

#include <fmt/format.h>

#include <cmath>

#include "base/printable.h"

namespace live::json {

std::string text(const std::string& s) {
    std::string shown = s;
    for (char& c : shown)
        if (static_cast<unsigned char>(c) < ' ' && c != '\t') c = '?';
    return base::quoted_json(shown);
}

std::string number(double v) { return std::isfinite(v) ? fmt::format("{}", v) : "null"; }

std::string list(const std::vector<std::string>& items) { return list_of(items, text); }
std::string numbers(const std::vector<double>& values) { return list_of(values, number); }

std::string object(const Members& members) {
    std::string out = "{";
    for (const auto& [name, value] : members) out += (out.size() > 1 ? ",\"" : "\"") + (name + ("\":" + value));
    return out + "}";
}

}  // namespace live::json
