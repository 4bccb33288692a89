// SPDX-License-Identifier: BSD-3-Clause
// compile(): text -> tree -> graph -> words.
#include "cal/compile.h"
#include "base/error.h"
#include "cal/build.h"
#include "cal/codegen.h"
#include "cal/program.h"

namespace cal {

namespace {

unsigned reads_of(uint32_t variable) {
    switch (variable) {
    case device::CAL_DX:
    case device::CAL_DY:
    case device::CAL_DZ:
    case device::CAL_TS:
    case device::CAL_RDOT:
    case device::CAL_RDOTP: return READS_RAY;
    case device::CAL_T: return READS_RAY | READS_TOTAL;
    case device::CAL_PX:
    case device::CAL_PY:
    case device::CAL_PZ: return READS_PLACE;
    default: return 0;
    }
}

unsigned reads_of(const Graph& graph) {
    unsigned out = 0;
    for (int i = 0; i < int(graph.size()); i++)
        if (graph[i].op == OP_VAR) out |= reads_of(uint32_t(graph[i].aux));
    return out;
}

}  // namespace

uint32_t with_builder(Library& library, const std::vector<double>& args, const base::Xform& xform,
                      const std::string& place, Code& code,
                      const std::function<std::vector<int>(GraphBuilder&, Graph&)>& make) {
    constexpr int deepest = 256, usual = 32;
    for (int limit = deepest;; limit /= 2) {
        Graph graph;
        GraphBuilder builder(library.state(), graph, args, xform, place);
        builder.recursion_limit = limit;
        if (limit > usual) builder.step_limit /= 4;  // what will not fit is soon known
        try {
            const uint32_t entry = generate(graph, make(builder, graph), place, code);
            code.reads |= reads_of(graph);
            if (builder.cut)
                base::warn("", place + ": a function that calls itself as the ray decides is followed " +
                                   std::to_string(limit) + " levels deep; there is no value where it goes deeper");
            return entry;
        } catch (const GraphBuilder::TooLarge&) {
            if (limit == 1) base::fail(place, "function is too large to compile");
        } catch (const base::Error&) {  // too deep for the stack or for the registers, or a mistake at any depth
            if (limit <= usual) throw;
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
