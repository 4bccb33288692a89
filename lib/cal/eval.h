// SPDX-License-Identifier: BSD-3-Clause
// Evaluates .cal expressions in double, for the generators (genrev, genworm, gensurf: -e expressions, -f files).
// All functions of function files are known (hermite, bezier, bspline, noise3, j0 ..); ray variables are not.
#pragma once
#include <memory>
#include <string>
#include <vector>
#include "base/find_file.h"

namespace cal {

class Evaluator {
public:
    explicit Evaluator(const base::ReadOptions& files);
    ~Evaluator();

    void define(const std::string& definitions, const std::string& place);  // "r(t) = 1+t; k : 3"
    void load(const std::string& file, const std::string& place);           // definitions of a file on RAYPATH

    bool has_function(const std::string& name) const;  // defined by define() or load()
    // A defined function, or any expression without parameters.  Domain errors and divisions by zero give 0, as in
    // RADIANCE, and are counted.  Throws Error(place) for what is not defined or never ends.
    double call(const std::string& function, const std::vector<double>& arguments, const std::string& place);
    double value(const std::string& expression, const std::string& place);
    long errors() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace cal
