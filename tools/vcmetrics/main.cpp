// SPDX-License-Identifier: BSD-3-Clause
// vcmetrics - glare and visual-comfort metrics of pictures or of a stream of them, one line a picture.
// The metrics live in lib/glare; this file only connects them.  See man/vcmetrics.1.
#include "base/run.h"
#include "difference_inputs.h"
#include "measure_stream.h"
#include "options.h"
#include "spectra.h"

int main(int argc, char** argv) {
    return base::run("vcmetrics", [&] {
        Options options;
        if (const auto status = parse_options(argc, argv, options)) return *status;
        if (!options.spectra.empty()) return print_spectra(options);
        return options.difference ? difference_inputs(options) : measure_all(options);
    });
}
