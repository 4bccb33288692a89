// SPDX-License-Identifier: BSD-3-Clause
// Shared by the generators of curves and surfaces: functions of t (or s and t) given as .cal expressions on the
// command line, with -e definitions and -f files, evaluated in double.
#pragma once
#include <cmath>
#include "cal/eval.h"
#include "generators/generators.h"

namespace generators {

class Functions {
public:
    explicit Functions(const Call& call) : call_(call), evaluator_(call.options) {}
    // -e or -f at word i (then stepped over)
    bool option(size_t& i) {
        const std::string& w = call_.words[i];
        if (w == "-e") evaluator_.define(call_.word(++i, "-e"), call_.place);
        else if (w == "-f") evaluator_.load(call_.word(++i, "-f"), call_.place);
        else return false;
        return true;
    }
    void define(const std::string& name, const std::string& parameters, const std::string& expression) {
        evaluator_.define(name + "(" + parameters + ")=" + expression, call_.place);
    }
    // Finite, or an Error.
    double operator()(const std::string& name, const std::vector<double>& arguments) {
        const double v = evaluator_.call(name, arguments, call_.place);
        if (!std::isfinite(v)) call_.fail("a value is not finite");
        return v;
    }
    bool has(const std::string& name) const { return evaluator_.has_function(name); }

private:
    const Call& call_;
    cal::Evaluator evaluator_;
};

}  // namespace generators
