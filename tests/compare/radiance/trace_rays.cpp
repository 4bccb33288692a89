// SPDX-License-Identifier: BSD-3-Clause
// trace_rays FEWEST MOST SCENE ARGUMENTS [LEAST] < rays
// ptrace's value of single rays (origin and direction, one a line), under rtrace's arguments.  One line a ray: red,
// green, blue, their standard errors, samples.  Between FEWEST and MOST samples are taken, until the brightest channel
// is known to 2e-4.  LEAST is the least chance of each way on from a surface, for light that comes by ways hardly ever
// taken. For the comparison of random scenes (compare.py).
#include <fmt/core.h>

#include <cstdlib>
#include <iostream>
#include <sstream>

#include "base/error.h"
#include "base/run.h"
#include "parity/trace_row.h"

int main(int argc, char** argv) {
    return base::run("trace_rays", [&] {
        if (argc != 5 && argc != 6) base::fail("", "usage: trace_rays fewest most scene arguments [least] < rays");
        const double least = argc == 6 ? std::atof(argv[5]) : 0;
        parity::RowTracer tracer("cpu", std::atol(argv[2]), std::atol(argv[1]), least);
        parity::Row row;
        row.file = argv[3];
        row.arguments = argv[4];
        for (std::string line; std::getline(std::cin, line);) {
            std::istringstream in(line);
            row.input.assign(6, 0);
            for (double& v : row.input) in >> v;
            if (!in) base::fail("stdin", "\"" + line + "\" is not a ray");
            const parity::Value v = tracer.trace(row);
            for (double mean : v.mean) fmt::print("{:.9g} ", mean);
            fmt::print("{:.3g} {:.3g} {:.3g} {}\n", v.error[0], v.error[1], v.error[2], v.samples);
        }
        return 0;
    });
}
