// SPDX-License-Identifier: BSD-3-Clause
// The built-in variables and functions of function files, for GraphBuilder (build.h).
// To add a function of numbers: 1. an operation in kernels/cal/cal_vm.h, 2. fold() in graph.cpp, 3. a row in
// `functions`.
#include <cmath>
#include "cal/build.h"

namespace cal {

namespace {

const struct {
    const char* name;
    uint32_t op;
    int arguments;
} functions[] = {
    {"sqrt", OP_SQRT, 1}, {"exp", OP_EXP, 1},   {"log", OP_LOG, 1},     {"log10", OP_LOG10, 1},
    {"sin", OP_SIN, 1},   {"cos", OP_COS, 1},   {"tan", OP_TAN, 1},     {"asin", OP_ASIN, 1},
    {"acos", OP_ACOS, 1}, {"atan", OP_ATAN, 1}, {"atan2", OP_ATAN2, 2}, {"floor", OP_FLOOR, 1},
    {"ceil", OP_CEIL, 1}, {"erf", OP_ERF, 1},   {"erfc", OP_ERFC, 1},   {"rand", OP_RAND, 1},
};
// Functions without an operation of their own.
const struct {
    const char* name;
    int arguments;
} special[] = {
    {"if", 3},      {"select", 1},  {"min", 1}, {"max", 1}, {"arg", 1}, {"noise3", 3}, {"noise3x", 3}, {"noise3y", 3},
    {"noise3z", 3}, {"fnoise3", 3}, {"j0", 1},  {"j1", 1},  {"jn", 2},  {"y0", 1},     {"y1", 1},      {"yn", 2},
};
const struct {
    const char* name;
    uint32_t index;
} plain[] = {
    {"Rdot", device::CAL_RDOT}, {"Lu", device::CAL_LU},   {"Lv", device::CAL_LV},   {"RdotP", device::CAL_RDOTP},
    {"CrP", device::CAL_CRP},   {"CgP", device::CAL_CGP}, {"CbP", device::CAL_CBP},
};
const struct {
    const char* name;
    uint32_t first;
    int axis;
} vectors[] = {
    {"Dx", device::CAL_DX, 0},   {"Dy", device::CAL_DX, 1},   {"Dz", device::CAL_DX, 2},   {"Nx", device::CAL_NX, 0},
    {"Ny", device::CAL_NX, 1},   {"Nz", device::CAL_NX, 2},   {"Px", device::CAL_PX, 0},   {"Py", device::CAL_PX, 1},
    {"Pz", device::CAL_PX, 2},   {"NxP", device::CAL_NXP, 0}, {"NyP", device::CAL_NXP, 1}, {"NzP", device::CAL_NXP, 2},
    {"DxA", device::CAL_DXA, 0}, {"DyA", device::CAL_DXA, 1}, {"DzA", device::CAL_DXA, 2},
};

// $1 .. $27
const char* const channels[27] = {"Dx", "Dy", "Dz", "Nx", "Ny", "Nz", "Px", "Py", "Pz", "T",  "Rdot", "S",  "Tx", "Ty",
                                  "Tz", "Ix", "Iy", "Iz", "Jx", "Jy", "Jz", "Kx", "Ky", "Kz", "Ts",   "Lu", "Lv"};
constexpr int first_given = 101;  // $101.. = CAL_LX..

}  // namespace

int GraphBuilder::parameters(const std::string& function, const std::string& context) const {
    if (const Definition* d = library_.lookup(function, context))
        return d->is_function ? int(d->parameters.size()) : -1;
    for (const auto& f : functions)
        if (function == f.name) return f.arguments;
    for (const auto& f : special)
        if (function == f.name) return f.arguments;
    return -1;
}

// Local coordinates: points by the inverse transform, directions by it and divided by its scale.
int GraphBuilder::vector_component(uint32_t first, int axis, bool is_point) {
    int sum = is_point ? graph_.constant(to_local_.m[3][axis]) : graph_.constant(0);
    for (int k = 0; k < 3; k++) {
        double m = to_local_.m[k][axis];
        if (!is_point) m /= scale_;
        if (std::fabs(m) < 1e-15) m = 0;
        sum = graph_.add(sum, graph_.mul(graph_.variable(first + uint32_t(k)), graph_.constant(m)));
    }
    return sum;
}

bool GraphBuilder::ray_variable(const std::string& name, int& node) {
    for (const auto& v : vectors)
        if (name == v.name) {
            node = vector_component(v.first, v.axis, v.first == device::CAL_PX);
            return true;
        }
    for (const auto& v : plain)
        if (name == v.name) {
            node = graph_.variable(v.index);
            return true;
        }
    if (name == "T" || name == "Ts") {
        node = graph_.mul(graph_.variable(name == "T" ? device::CAL_T : device::CAL_TS), graph_.constant(scale_));
        return true;
    }
    if (name == "S") {
        node = graph_.constant(scale_);
        return true;
    }
    if (name.size() == 2 && name[1] >= 'x' && name[1] <= 'z') {
        const int axis = name[1] - 'x';
        if (name[0] == 'T') {
            node = graph_.constant(to_local_.m[3][axis]);
            return true;
        }
        if (name[0] >= 'I' && name[0] <= 'K') {
            node = graph_.constant(to_local_.m[name[0] - 'I'][axis] / scale_);
            return true;
        }
    }
    return false;
}

// $1 .. $27, and $101 .. as CAL_LX ..
int GraphBuilder::channel(double number) {
    const int k = number < 1000 ? int(number) : 1000, given = k - first_given;
    int node;
    if (k >= 1 && k <= 27 && ray_variable(channels[k - 1], node)) return node;
    if (given < 0 || given >= device::CAL_VARS - device::CAL_LX)
        fail("there is no such channel as $" + std::to_string(k));
    if (given < 3) return vector_component(device::CAL_LX, given, false);
    return graph_.variable(uint32_t(device::CAL_LX + given));
}

// The real argument of that number; their number for an index below 1/2.
int GraphBuilder::argument(int index) {
    const double count = double(args_.size());
    if (graph_.is_constant(index) && graph_.value(index) >= count + 0.5)
        fail("real argument A" + std::to_string(int(std::fmin(graph_.value(index) + 0.5, 1e9))) + " is missing");
    std::vector<Thunk> values(args_.size());
    for (size_t i = 0; i < values.size(); i++) values[i].node = graph_.constant(args_[i]);
    return pick(index, values, 0, graph_.constant(count));
}

// values[first + k - 1] for an index from k - 1/2 up to below k + 1/2; their number for k = 0; `below` (-1: an error)
// for less, and an error for more.
int GraphBuilder::pick(int index, const std::vector<Thunk>& values, size_t first, int below) {
    const double count = double(values.size() - first);
    const auto low = [&] { return below < 0 ? graph_.fail() : below; };
    if (graph_.is_constant(index)) {
        const double k = std::floor(graph_.value(index) + 0.5);
        if (k < 1) return k == 0 ? graph_.constant(count) : low();
        return k <= count ? force(values[first + size_t(k) - 1]) : graph_.fail();
    }
    const Nesting branch(branches_);
    const auto under = [&](double limit, int yes, int no) {  // choose() takes "above 0": a half counts upward
        return graph_.choose(graph_.sub(graph_.constant(limit), index), yes, no);
    };
    int node = under(-0.5, low(), graph_.constant(count));
    for (size_t k = 1; k <= values.size() - first; k++)
        node = under(double(k) - 0.5, node, force(values[first + k - 1]));
    return under(count + 0.5, node, graph_.fail());
}

bool GraphBuilder::builtin(const std::string& function, const std::vector<Thunk>& args, int& node) {
    auto need = [&](size_t n) {
        if (args.size() < n) fail("too few arguments for function \"" + function + "\"");
    };
    for (const auto& f : functions)
        if (function == f.name) {
            need(size_t(f.arguments));
            node = f.arguments == 1 ? graph_.make(f.op, force(args[0]))
                                    : graph_.make(f.op, force(args[0]), force(args[1]));
            return true;
        }
    if (function == "if") {
        need(3);
        node = choose(force(args[0]), args[1], args[2]);
    } else if (function == "select") {
        need(1);
        node = pick(force(args[0]), args, 1, -1);
    } else if (function == "min" || function == "max") {
        need(1);
        node = force(args[0]);
        for (size_t i = 1; i < args.size(); i++)
            node = graph_.make(function == "min" ? OP_MIN : OP_MAX, node, force(args[i]));
    } else if (function == "arg") {
        need(1);
        node = argument(force(args[0]));
    } else if (function == "noise3" || function == "noise3x" || function == "noise3y" || function == "noise3z") {
        need(3);
        const uint32_t axis = function.size() == 6 ? 0 : uint32_t(function[6] - 'x' + 1);
        node = graph_.lookup(OP_NOISE, {force(args[0]), force(args[1]), force(args[2])}, axis);
    } else if (function == "fnoise3") {
        need(3);
        node = graph_.lookup(OP_FNOISE, {force(args[0]), force(args[1]), force(args[2])}, 0);
    } else if (function.size() == 2 && (function[0] == 'j' || function[0] == 'y') &&
               (function[1] == '0' || function[1] == '1' || function[1] == 'n')) {
        const bool order = function[1] == 'n';
        need(order ? 2 : 1);
        const int n = order ? force(args[0]) : graph_.constant(function[1] - '0'), x = force(args[order ? 1 : 0]);
        if (!graph_.is_constant(n) || !graph_.is_constant(x))
            fail("function \"" + function + "\" needs constant arguments here");
        const int k = int(std::fmax(-1000, std::fmin(1000, graph_.value(n))));
        const double v = function[0] == 'j' ? ::jn(k, graph_.value(x)) : ::yn(k, graph_.value(x));
        node = std::isfinite(v) ? graph_.constant(v) : graph_.fail();
    } else {
        return false;
    }
    return true;
}

}  // namespace cal
