// SPDX-License-Identifier: BSD-3-Clause
// An expression as a graph of values: equal subexpressions are one node, constants are folded in double.
// Nodes hold the VM's operation numbers (kernels/cal/cal_vm.h) and three more.
#pragma once
#include <cstdint>
#include <unordered_map>
#include <vector>
#include "cal/ops.h"

namespace cal {

constexpr uint8_t NODE_CONST = 128;    // value
constexpr uint8_t NODE_IF = 129;       // kid 0 > 0 ? kid 1 : kid 2; only the branch taken is evaluated
constexpr uint8_t NODE_CHANNEL = 130;  // component aux of kid 0 (a look-up)

struct Node {
    uint8_t op = NODE_CONST;
    uint8_t kid_count = 0;
    uint32_t aux = 0;  // OP_VAR: variable; OP_NOISE: axis; OP_DATA, OP_TEXT: table
    double value = 0;  // constants; OP_DATA: number of channels
    int kid[5] = {-1, -1, -1, -1, -1};
    bool operator==(const Node& o) const;
};
struct NodeHash {
    size_t operator()(const Node& n) const;
};

class Graph {
public:
    // numbers_only: failing operations give 0 and set `error` instead of staying in the program.
    explicit Graph(bool numbers_only = false) : numbers_only_(numbers_only) {}

    int constant(double value);
    int variable(uint32_t index);
    int make(uint32_t op, int a = -1, int b = -1, uint32_t aux = 0);
    int choose(int condition, int yes, int no);
    int lookup(uint32_t op, const std::vector<int>& kids, uint32_t aux, int channels = 1);  // noise, data, text
    int channel(int node, uint32_t k);
    int fail();

    int add(int a, int b) { return make(OP_ADD, a, b); }
    int sub(int a, int b) { return make(OP_SUB, a, b); }
    int mul(int a, int b) { return make(OP_MUL, a, b); }

    const Node& operator[](int id) const { return nodes_[size_t(id)]; }
    size_t size() const { return nodes_.size(); }
    bool is_constant(int id) const { return nodes_[size_t(id)].op == NODE_CONST; }
    double value(int id) const { return nodes_[size_t(id)].value; }
    void clear() {
        nodes_.clear();
        known_.clear();
        error = false;
    }
    bool error = false;

private:
    int intern(const Node& n);
    int power(int a, int b);
    bool is(int id, double v) const { return is_constant(id) && value(id) == v; }
    bool numbers_only_;
    std::vector<Node> nodes_;
    std::unordered_map<Node, int, NodeHash> known_;
};

// Result of an operation in double; false if it is an error (domain, range, division by zero).
bool fold(uint32_t op, double a, double b, double& result);

// May evaluating this node, its operands apart, end with an error?
bool may_fail(const Graph& graph, const Node& node);
// RADIANCE forgets earlier errors when it begins a library call or a power.
bool forgets(const Node& node);

}  // namespace cal
