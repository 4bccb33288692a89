// SPDX-License-Identifier: BSD-3-Clause
// See errors.h.
#include "report/errors.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "base/error.h"
#include "base/number.h"
#include "base/split.h"

namespace report {
namespace {

// The digits of base 64 (RFC 4648, section 5): none means anything in a table, in JSON or to a shell.
constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
constexpr int zero = 32;

std::optional<uncertainty::HalfCodes> codes_of(const std::string& letters) {
    uncertainty::HalfCodes codes{};
    if (letters.size() != codes.size()) return std::nullopt;
    for (size_t k = 0; k < codes.size(); ++k) {
        const size_t digit = digits.find(letters[k]);
        if (digit == digits.npos) return std::nullopt;
        codes[k] = int8_t(int(digit) - zero);
    }
    return codes;
}

}  // namespace

void add_error(const std::string& name, const NumberError& e, std::string& cell) {
    if (std::isnan(e.error)) return;
    cell += fmt::format("{}{}={:.4g}/{:.3g}", cell.empty() ? "" : " ", name, e.error, e.degrees);
    if (!(e.halves.strata > 0)) return;
    cell += '/';
    for (const int code : e.halves.codes) cell += digits[size_t(code + zero)];
    cell += fmt::format("/{:.3g}", e.halves.strata);
}

std::optional<NumberError> error_of(const std::string& name, const std::string& cell, const std::string& place) {
    for (const std::string& word : base::split_words(cell)) {
        if (word.compare(0, name.size() + 1, name + "=") != 0) continue;
        const std::vector<std::string> parts = base::split_list(word.substr(name.size() + 1), '/');
        NumberError e;
        const auto real = [&](size_t k, double& number) {
            return k < parts.size() && base::parse_real(parts[k], number) && number >= 0;
        };
        bool good = real(0, e.error) && real(1, e.degrees) && (parts.size() == 2 || parts.size() == 4);
        if (parts.size() == 4) {
            const auto codes = codes_of(parts[2]);
            good = good && codes && real(3, e.halves.strata);
            if (codes) e.halves.codes = *codes;
        }
        if (!good) base::fail(place, "\"" + word + "\" is not NAME=ERROR/DEGREES or NAME=ERROR/DEGREES/HALVES/STRATA");
        return e;
    }
    return std::nullopt;
}

}  // namespace report
