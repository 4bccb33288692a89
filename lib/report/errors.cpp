// SPDX-License-Identifier: BSD-3-Clause
// See errors.h.
#include "report/errors.h"

#include <fmt/format.h>

#include <cmath>

#include "base/error.h"
#include "base/number.h"
#include "base/split.h"

namespace report {

void add_error(const std::string& name, const NumberError& e, std::string& cell) {
    if (std::isnan(e.error)) return;
    cell += fmt::format("{}{}={:.4g}/{:.3g}", cell.empty() ? "" : " ", name, e.error, e.degrees);
}

std::optional<NumberError> error_of(const std::string& name, const std::string& cell, const std::string& place) {
    for (const std::string& word : base::split_words(cell)) {
        if (word.compare(0, name.size() + 1, name + "=") != 0) continue;
        const std::vector<std::string> parts = base::split_list(word.substr(name.size() + 1), '/');
        NumberError e;
        if (parts.size() != 2 || !base::parse_real(parts[0], e.error) || !base::parse_real(parts[1], e.degrees) ||
            !(e.error >= 0) || !(e.degrees > 0))
            base::fail(place, "\"" + word + "\" is not NAME=ERROR/DEGREES");
        return e;
    }
    return std::nullopt;
}

}  // namespace report
