// SPDX-License-Identifier: BSD-3-Clause
// From trees to graphs: evaluates an expression symbolically.  Functions are expanded where they are called, with
// arguments by name, so `if` is lazy, constant recursion ends, and function names can be arguments.  Recursion whose
// end depends on ray variables is expanded to a bounded depth, beyond which the program reports an error
// (docs/decisions/0007-cal-recursion.md).
#pragma once
#include <map>
#include <string>
#include <vector>
#include "base/xform.h"
#include "cal/graph.h"
#include "cal/library.h"

namespace cal {

struct Environment;

// An argument: an expression and where its names belong, or a finished value.
struct Thunk {
    const Expr* expr = nullptr;
    const Environment* env = nullptr;
    mutable int node = -1;
};
struct Environment {
    const std::string* context;
    const Definition* def = nullptr;
    std::vector<Thunk> arguments;
    const Environment* caller = nullptr;
};

// Counts how deep we are, also when an exception passes.
struct Nesting {
    int& depth;
    explicit Nesting(int& counter) : depth(counter) { depth++; }
    ~Nesting() { depth--; }
};

class GraphBuilder {
public:
    // `xform`: object -> world
    GraphBuilder(const Library::State& library, Graph& graph, const std::vector<double>& args, const base::Xform& xform,
                 const std::string& place);

    int expression(const Expr* e, const std::string& context);
    // A function named in a primitive (or a parameterless expression), called with finished values.
    int call(const std::string& function, const std::vector<int>& values, const std::string& context);
    // Number of parameters of a named function; -1 if there is no such function.
    int parameters(const std::string& function, const std::string& context) const;

    int recursion_limit = 32;  // times a function may be inside itself below a branch
    bool cut = false;          // a function met this limit: its program reports an error there
    size_t step_limit = 300000;
    struct TooLarge {};  // thrown beyond step_limit: try again with a smaller recursion_limit

private:
    int eval(const Expr* e, const Environment& env);
    const Thunk& given(const Environment& env, size_t i) const;
    int force(const Thunk& t);
    int name(const Expr* e, const Environment& env);
    int invoke(const std::string& function, std::vector<Thunk> args, const Environment& env);
    int expand(const Definition& def, std::vector<Thunk> args, const Environment& env);
    int variable(const Definition& def);
    int channel(double number);
    bool ray_variable(const std::string& name, int& node);
    bool builtin(const std::string& function, const std::vector<Thunk>& args, int& node);
    int vector_component(uint32_t first, int axis, bool is_point);
    int argument(int index);
    int choose(int condition, const Thunk& yes, const Thunk& no);
    int pick(int index, const std::vector<Thunk>& values, size_t first, int below);
    [[noreturn]] void fail(const std::string& fact) const;

    const Library::State& library_;
    Graph& graph_;
    const std::vector<double>& args_;
    base::Xform to_local_;
    double scale_;  // of to_local_, positive
    std::string place_;
    std::map<const Definition*, int> variables_;
    std::map<const Definition*, int> active_;
    int depth_ = 0, branches_ = 0;
    size_t steps_ = 0;
};

}  // namespace cal
