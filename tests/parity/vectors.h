// SPDX-License-Identifier: BSD-3-Clause
// The tables of values that RADIANCE gives (tests/golden/vectors/vectors.tsv; found.tsv: by comparing random scenes):
// one row a ray, tab separated: id, kind, scene file, rtrace's arguments, input (origin and direction), output, note.
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace parity {

struct Row {
    std::string id, kind, file, arguments;
    std::vector<double> input, output;
    double error[3] = {0, 0, 0};  // standard errors, of means
    std::optional<double> exact;  // the integral itself, where RADIANCE's quadrature is not it
};

// Rows of the kinds rtrace and rtrace-mean(N) whose input is a ray.
std::vector<Row> read_rays(const std::string& path);

// Rows that are known to differ: id, tab, reason.  Those whose note tells the exact value must agree with it instead.
struct Exception {
    std::string id, reason;
};
std::vector<Exception> read_exceptions(const std::string& path);

}  // namespace parity
