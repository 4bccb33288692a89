// SPDX-License-Identifier: BSD-3-Clause
// The evaluator is the symbolic one (build.h) on a graph of numbers: everything folds.
#include "cal/eval.h"
#include <functional>
#include "base/error.h"
#include "cal/build.h"

namespace cal {

struct Evaluator::State {
    Library library;
    Graph graph{true};
    long errors = 0;
    std::vector<double> no_arguments;

    explicit State(const base::ReadOptions& files) : library(files) {}

    double run(const std::string& place, const std::function<int(GraphBuilder&)>& make) {
        graph.clear();
        GraphBuilder builder(library.state(), graph, no_arguments, base::Xform(), place);
        builder.step_limit = 2000000;
        try {
            const int node = make(builder);
            if (!graph.is_constant(node)) base::fail(place, "ray variables have no value here");
            if (graph.error) errors++;
            return graph.value(node);
        } catch (const GraphBuilder::TooLarge&) {
            base::fail(place, "evaluation takes too long: a definition that never ends?");
        }
    }
};

Evaluator::Evaluator(const base::ReadOptions& files) : state_(new State(files)) {}
Evaluator::~Evaluator() = default;

void Evaluator::define(const std::string& definitions, const std::string& place) {
    state_->library.state().add(definitions, place, "", false);
}

void Evaluator::load(const std::string& file, const std::string& place) {
    state_->library.state().add_global_file(file, place, false);
}

bool Evaluator::has_function(const std::string& name) const {
    const Definition* d = state_->library.state().lookup(name, "");
    return d && d->is_function;
}

double Evaluator::call(const std::string& function, const std::vector<double>& arguments, const std::string& place) {
    static const std::string global;
    return state_->run(place, [&](GraphBuilder& b) {
        std::vector<int> nodes;
        for (double a : arguments) nodes.push_back(state_->graph.constant(a));
        return b.call(function, nodes, global);
    });
}

double Evaluator::value(const std::string& expression, const std::string& place) {
    static const std::string global;
    const Expr* tree = parse_expression(expression, place, state_->library.state().pool);
    return state_->run(place, [&](GraphBuilder& b) { return b.expression(tree, global); });
}

long Evaluator::errors() const { return state_->errors; }

}  // namespace cal
