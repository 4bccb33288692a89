// SPDX-License-Identifier: BSD-3-Clause
// compile(): text -> tree -> graph -> words.
#include "cal/compile.h"
#include "base/error.h"
#include "cal/build.h"
#include "cal/codegen.h"
#include "cal/program.h"

namespace cal {

namespace {

// Does it read where the ray comes from: its direction, its length, its angle with the surface?
bool reads_ray(const Graph& graph) {
    for (int i = 0; i < int(graph.size()); i++) {
        if (graph[i].op != OP_VAR) continue;
        switch (graph[i].aux) {
        case device::CAL_DX:
        case device::CAL_DY:
        case device::CAL_DZ:
        case device::CAL_T:
        case device::CAL_TS:
        case device::CAL_RDOT:
        case device::CAL_RDOTP: return true;
        default: break;
        }
    }
    return false;
}

}  // namespace

uint32_t with_builder(Library& library, const std::vector<double>& args, const base::Xform& xform,
                      const std::string& place, Code& code,
                      const std::function<std::vector<int>(GraphBuilder&, Graph&)>& make) {
    for (int limit = 32;; limit /= 2) {
        Graph graph;
        GraphBuilder builder(library.state(), graph, args, xform, place);
        builder.recursion_limit = limit;
        try {
            const uint32_t entry = generate(graph, make(builder, graph), place, code);
            code.looks = code.looks || reads_ray(graph);
            return entry;
        } catch (const GraphBuilder::TooLarge&) {
            if (limit == 1) base::fail(place, "function is too large to compile");
        }
    }
}

uint32_t compile(Library& library, const std::vector<std::string>& outputs, const std::string& cal_file,
                 const std::vector<double>& args, const base::Xform& xform, const std::string& place, Code& code) {
    const std::string context = library.state().load(cal_file, place);
    std::vector<const Expr*> trees;
    for (const std::string& text : outputs) trees.push_back(parse_expression(text, place, library.state().pool));
    return with_builder(library, args, xform, place, code, [&](GraphBuilder& builder, Graph&) {
        std::vector<int> nodes;
        for (const Expr* e : trees) nodes.push_back(builder.expression(e, context));
        return nodes;
    });
}

}  // namespace cal
