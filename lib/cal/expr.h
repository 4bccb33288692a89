// SPDX-License-Identifier: BSD-3-Clause
// .cal text as trees: expressions, definitions, and the parser that makes them.
// Grammar (RADIANCE function files):  file = { name[(p,..)] ("="|":") E ";" }
//     E = E (+|-) T | T    T = T (*|/) F | F    F = U ^ F | U    U = (-|+) A | A    A = (E) | number | name[(E,..)] |
//     $int
// so a sign binds tighter than ^ : -2^2 is 4.  Comments { .. } nest.  Constant operands are folded while parsing.
#pragma once
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace cal {

struct Expr {
    enum class Kind : uint8_t { number, name, call, channel, negate, add, subtract, multiply, divide, power };
    Kind kind = Kind::number;
    uint16_t depth = 1;
    double value = 0;               // number; channel: its index
    std::string name;               // name, call
    std::vector<const Expr*> kids;  // operands or arguments
};

struct Definition {
    std::string name, context;  // context "" = global
    std::vector<std::string> parameters;
    bool is_function = false;
    bool is_constant = false;  // defined by ":"
    const Expr* body = nullptr;
    std::string place;  // file:line, for messages
};

// Owns trees; they live as long as the pool.
class Pool {
public:
    Expr* make(Expr::Kind kind) {
        exprs_.emplace_back();
        exprs_.back().kind = kind;
        return &exprs_.back();
    }
    const Expr* number(double value) {
        Expr* e = make(Expr::Kind::number);
        e->value = value;
        return e;
    }
    const Expr* call(const std::string& name, std::vector<const Expr*> kids);

private:
    std::deque<Expr> exprs_;
};

// Both throw Error(place); `place` of a file is its name, lines are added.
const Expr* parse_expression(std::string_view text, const std::string& place, Pool& pool);
std::vector<Definition> parse_definitions(std::string_view text, const std::string& file, Pool& pool);

}  // namespace cal
