// SPDX-License-Identifier: BSD-3-Clause
// See spectra.h.
#include "spectra.h"

#include <fmt/core.h>

#include "glare/actions.h"
#include "report/table.h"
#include "spectrum/action.h"
#include "spectrum/illuminants.h"

int print_spectra(const Options& options) {
    std::vector<report::Line> lines;
    for (const std::string& light : options.spectra) {
        const spectrum::Spectrum s = spectrum::illuminant(light, "-spectrum");
        report::Line line;
        report::add(line, "light", report::text_cell(light));
        for (const auto& [action, symbol] : glare::alpha_opic)
            report::add(line, symbol + std::string("DER"), spectrum::daylight_ratio(spectrum::action_of(action), s));
        lines.push_back(line);
    }
    fmt::print("{}", report::table(lines, options.format));
    return 0;
}
