// SPDX-License-Identifier: BSD-3-Clause
// See functions.h.
#include "generators/functions.h"
#include <cmath>

namespace generators {

bool Functions::option(size_t& i) {
    const std::string& w = call_.words[i];
    if (w == "-e") evaluator_.define(call_.word(++i, "-e"), call_.place);
    else if (w == "-f") evaluator_.load(call_.word(++i, "-f"), call_.place);
    else return false;
    return true;
}

void Functions::define(const std::string& name, const std::string& parameters, const std::string& expression) {
    evaluator_.define(name + "(" + parameters + ")=" + expression, call_.place);
}

double Functions::operator()(const std::string& name, const std::vector<double>& arguments) {
    const double v = evaluator_.call(name, arguments, call_.place);
    if (!std::isfinite(v)) call_.fail("a value is not finite");
    return v;
}

}  // namespace generators
