// SPDX-License-Identifier: BSD-3-Clause
// Shared by the generators of curves and surfaces: functions of t (or s and t) given as .cal expressions on the
// command line, with -e definitions and -f files, evaluated in double.
#pragma once
#include "cal/eval.h"
#include "generators/generators.h"

namespace generators {

class Functions {
public:
    explicit Functions(const Call& call) : call_(call), evaluator_(call.options) {}
    bool option(size_t& i);  // -e or -f at word i (then stepped over)
    void define(const std::string& name, const std::string& parameters, const std::string& expression);
    double operator()(const std::string& name, const std::vector<double>& arguments);  // finite, or an Error
    bool has(const std::string& name) const { return evaluator_.has_function(name); }

private:
    const Call& call_;
    cal::Evaluator evaluator_;
};

}  // namespace generators
