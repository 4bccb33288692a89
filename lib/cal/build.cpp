// SPDX-License-Identifier: BSD-3-Clause
// Symbolic evaluation: see build.h.  Built-in functions are in build_builtins.cpp.
#include "cal/build.h"
#include <cmath>
#include "base/error.h"

namespace cal {

namespace {

constexpr int max_evaluation = 3000;  // of evaluation: C++ stack

}  // namespace

GraphBuilder::GraphBuilder(const Library::State& library, Graph& graph, const std::vector<double>& args,
                           const base::Xform& xform, const std::string& place)
    : library_(library), graph_(graph), args_(args), to_local_(base::inverse(xform)), place_(place) {
    scale_ = std::fabs(to_local_.scale);
}

void GraphBuilder::fail(const std::string& fact) const { base::fail(place_, fact); }

int GraphBuilder::expression(const Expr* e, const std::string& context) {
    Environment env{&context, nullptr, {}, nullptr};
    return eval(e, env);
}

int GraphBuilder::call(const std::string& function, const std::vector<int>& values, const std::string& context) {
    Environment env{&context, nullptr, {}, nullptr};
    std::vector<Thunk> args(values.size());
    for (size_t i = 0; i < values.size(); i++) args[i].node = values[i];
    return invoke(function, std::move(args), env);
}

int GraphBuilder::force(const Thunk& t) {
    if (t.node < 0) t.node = eval(t.expr, *t.env);
    return t.node;
}

int GraphBuilder::eval(const Expr* e, const Environment& env) {
    if (++steps_ > step_limit) throw TooLarge();
    if (depth_ >= max_evaluation) fail("evaluation is nested too deeply: a definition that never ends?");
    const Nesting deeper(depth_);
    switch (e->kind) {
    case Expr::Kind::number: return graph_.constant(e->value);
    case Expr::Kind::channel: return channel(e->value);
    case Expr::Kind::name: return name(e, env);
    case Expr::Kind::call: {
        std::vector<Thunk> args(e->kids.size());
        for (size_t i = 0; i < args.size(); i++) {
            args[i].expr = e->kids[i];
            args[i].env = &env;
        }
        return invoke(e->name, std::move(args), env);
    }
    case Expr::Kind::negate: return graph_.make(OP_NEG, eval(e->kids[0], env));
    default: break;
    }
    const int a = eval(e->kids[0], env), b = eval(e->kids[1], env);
    switch (e->kind) {
    case Expr::Kind::add: return graph_.make(OP_ADD, a, b);
    case Expr::Kind::subtract: return graph_.make(OP_SUB, a, b);
    case Expr::Kind::multiply: return graph_.make(OP_MUL, a, b);
    case Expr::Kind::divide: return graph_.make(OP_DIV, a, b);
    default: return graph_.make(OP_POW, a, b);
    }
}

// A missing argument is an error where it is used, so that `or(1)' is 1.
const Thunk& GraphBuilder::given(const Environment& env, size_t i) const {
    if (i >= env.arguments.size()) fail("too few arguments for function \"" + env.def->name + "\"");
    return env.arguments[i];
}

int GraphBuilder::name(const Expr* e, const Environment& env) {
    if (env.def)
        for (size_t i = 0; i < env.def->parameters.size(); i++)
            if (e->name == env.def->parameters[i]) return force(given(env, i));
    if (const Definition* d = library_.lookup(e->name, *env.context)) {
        if (d->is_function) fail("function \"" + e->name + "\" is used without arguments");
        return variable(*d);
    }
    int node;
    if (ray_variable(e->name, node)) return node;
    fail("variable \"" + e->name + "\" is not defined");
}

int GraphBuilder::variable(const Definition& def) {
    const auto known = variables_.find(&def);
    if (known != variables_.end()) {
        if (known->second < 0) fail("definition of \"" + def.name + "\" (" + def.place + ") refers to itself");
        return known->second;
    }
    variables_[&def] = -1;
    Environment env{&def.context, nullptr, {}, nullptr};
    const int node = eval(def.body, env);
    variables_[&def] = node;
    return node;
}

int GraphBuilder::invoke(const std::string& function, std::vector<Thunk> args, const Environment& env) {
    if (env.def)
        for (size_t i = 0; i < env.def->parameters.size(); i++)
            if (function == env.def->parameters[i]) {  // a parameter that stands for a function
                const Thunk& t = given(env, i);
                if (!t.expr || t.expr->kind != Expr::Kind::name)
                    fail("argument \"" + function + "\" is not a function");
                return invoke(t.expr->name, std::move(args), *t.env);
            }
    if (const Definition* d = library_.lookup(function, *env.context)) return expand(*d, std::move(args), env);
    int node;
    if (builtin(function, args, node)) return node;
    fail("function \"" + function + "\" is not defined");
}

int GraphBuilder::expand(const Definition& def, std::vector<Thunk> args, const Environment& env) {
    if (!def.is_function) fail("\"" + def.name + "\" is not a function");
    int& active = active_[&def];
    if (branches_ > 0 && active >= recursion_limit) {
        cut = true;
        return graph_.fail();
    }
    const Nesting one_more(active);
    Environment inner{&def.context, &def, std::move(args), &env};
    return eval(def.body, inner);
}

int GraphBuilder::choose(int condition, const Thunk& yes, const Thunk& no) {
    if (graph_.is_constant(condition)) return force(graph_.value(condition) > 0 ? yes : no);
    const Nesting branch(branches_);
    const int a = force(yes), b = force(no);
    return graph_.choose(condition, a, b);
}

}  // namespace cal
