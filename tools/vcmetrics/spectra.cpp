// SPDX-License-Identifier: BSD-3-Clause
// See spectra.h.
#include "spectra.h"

#include <fmt/core.h>

#include "report/table.h"
#include "spectrum/action.h"
#include "spectrum/illuminants.h"

int print_spectra(const Options& options) {
    std::vector<report::Line> lines;
    for (const std::string& light : options.spectra) {
        const spectrum::Spectrum s = spectrum::illuminant(light, "-spectrum");
        report::Line line;
        report::add(line, "light", report::text_cell(light));
        for (const char* const action : {"mel", "rh", "sc", "mc", "lc"}) {
            const std::string name = action == std::string("mel") ? "mDER" : action + std::string("DER");
            report::add(line, name, spectrum::daylight_ratio(spectrum::action_of(action), s));
        }
        lines.push_back(line);
    }
    fmt::print("{}", report::table(lines, options.format));
    return 0;
}
