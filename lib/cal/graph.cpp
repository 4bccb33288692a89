// SPDX-License-Identifier: BSD-3-Clause
// Folding and sharing.
#include "cal/graph.h"
#include <cmath>
#include <cstring>

namespace cal {

bool Node::operator==(const Node& o) const {
    return op == o.op && kid_count == o.kid_count && aux == o.aux && std::memcmp(&value, &o.value, sizeof value) == 0 &&
           std::memcmp(kid, o.kid, sizeof kid) == 0;
}

size_t NodeHash::operator()(const Node& n) const {
    uint64_t bits, h = 1469598103934665603ull;
    std::memcpy(&bits, &n.value, sizeof bits);
    auto mix = [&](uint64_t v) {
        h = (h ^ v) * 1099511628211ull;
        h ^= h >> 29;
    };
    mix(n.op | uint64_t(n.aux) << 8);
    mix(bits);
    for (int i = 0; i < n.kid_count; i++) mix(uint64_t(n.kid[i]) + 1);
    return size_t(h);
}

bool fold(uint32_t op, double a, double b, double& r) {
    switch (op) {
    case OP_ADD: r = a + b; break;
    case OP_SUB: r = a - b; break;
    case OP_MUL: r = a * b; break;
    case OP_DIV:
        if (b == 0) return false;
        r = a / b;
        break;
    case OP_MIN: r = b < a ? b : a; break;
    case OP_MAX: r = b > a ? b : a; break;
    case OP_POW: r = std::pow(a, b); break;
    case OP_NEG: r = -a; break;
    case OP_SQRT: r = std::sqrt(a); break;
    case OP_EXP: r = std::exp(a); break;
    case OP_LOG: r = std::log(a); break;
    case OP_LOG10: r = std::log10(a); break;
    case OP_SIN: r = std::sin(a); break;
    case OP_COS: r = std::cos(a); break;
    case OP_TAN: r = std::tan(a); break;
    case OP_ASIN: r = std::asin(a); break;
    case OP_ACOS: r = std::acos(a); break;
    case OP_ATAN: r = std::atan(a); break;
    case OP_ATAN2: r = a == 0 && b == 0 ? 0 : std::atan2(a, b); break;
    case OP_FLOOR: r = std::floor(a); break;
    case OP_CEIL: r = std::ceil(a); break;
    case OP_ERF: r = std::erf(a); break;
    case OP_ERFC: r = std::erfc(a); break;
    case OP_RAND: r = device::cal_rand(a); break;
    default: return false;
    }
    return std::isfinite(r);
}

int Graph::intern(const Node& n) {
    if (numbers_only_) {
        nodes_.push_back(n);
        return int(nodes_.size()) - 1;
    }
    const auto found = known_.find(n);
    if (found != known_.end()) return found->second;
    nodes_.push_back(n);
    known_.emplace(n, int(nodes_.size()) - 1);
    return int(nodes_.size()) - 1;
}

int Graph::constant(double value) {
    Node n;
    n.value = value == 0 ? 0.0 : value;  // one zero
    return intern(n);
}

int Graph::variable(uint32_t index) {
    Node n;
    n.op = OP_VAR;
    n.aux = index;
    return intern(n);
}

int Graph::fail() {
    if (numbers_only_) {
        error = true;
        return constant(0);
    }
    Node n;
    n.op = OP_FAIL;
    return intern(n);
}

// Small whole powers are products, as exact as the power and much cheaper.
int Graph::power(int a, int b) {
    const double e = value(b);
    if (e == 0) return constant(1);
    if (e == 1) return a;
    if (e == 0.5) return make(OP_SQRT, a);
    if (e == std::floor(e) && std::fabs(e) <= 32) {
        int result = -1, square = a;
        for (int k = int(std::fabs(e)); k; k >>= 1) {
            if (k & 1) result = result < 0 ? square : mul(result, square);
            if (k > 1) square = mul(square, square);
        }
        return e > 0 ? result : make(OP_DIV, constant(1), result);
    }
    return -1;
}

int Graph::make(uint32_t op, int a, int b, uint32_t aux) {
    const bool ca = a < 0 || is_constant(a), cb = b < 0 || is_constant(b);
    if (ca && cb) {
        double r;
        if (fold(op, a < 0 ? 0 : value(a), b < 0 ? 0 : value(b), r)) return constant(r);
        if (numbers_only_) {
            error = true;
            return constant(0);
        }
    }
    switch (op) {
    case OP_ADD:
        if (is(a, 0)) return b;
        if (is(b, 0)) return a;
        break;
    case OP_SUB:
        if (is(b, 0)) return a;
        if (is(a, 0)) return make(OP_NEG, b);
        break;
    case OP_MUL:
        if (is(a, 0) || is(b, 0)) return constant(0);
        if (is(a, 1)) return b;
        if (is(b, 1)) return a;
        if (is(a, -1)) return make(OP_NEG, b);
        if (is(b, -1)) return make(OP_NEG, a);
        break;
    case OP_DIV:
        if (is(a, 0)) return constant(0);
        if (is(b, 1)) return a;
        break;
    case OP_NEG:
        if ((*this)[a].op == OP_NEG) return (*this)[a].kid[0];
        break;
    case OP_POW:
        if (is(a, 0)) return a;  // RADIANCE folds 0^x, x = 0 and below 0 included
        if (cb) {
            const int p = power(a, b);
            if (p >= 0) return p;
        }
        break;
    case OP_MIN:
    case OP_MAX:
        if (a == b) return a;
        break;
    default: break;
    }
    Node n;
    n.op = uint8_t(op);
    n.aux = aux;
    if ((op == OP_ADD || op == OP_MUL) && a > b) {
        const int t = a;
        a = b;
        b = t;
    }
    n.kid[0] = a;
    n.kid[1] = b;
    n.kid_count = uint8_t(a < 0 ? 0 : b < 0 ? 1 : 2);
    return intern(n);
}

int Graph::choose(int condition, int yes, int no) {
    if (is_constant(condition)) return value(condition) > 0 ? yes : no;
    if (yes == no) return yes;
    // the larger or the smaller of two values, and the bounded value: p > x ? p : min(x, b) with p <= b
    const Node c = (*this)[condition];
    const bool difference = c.op == OP_SUB, sum = c.op == OP_ADD;
    int p = -1, q = -1;  // condition is p > q
    if (difference) {
        p = c.kid[0];
        q = c.kid[1];
    }
    if (sum && is_constant(c.kid[0])) {
        p = c.kid[1];
        q = constant(-value(c.kid[0]));
    } else if (sum && is_constant(c.kid[1])) {
        p = c.kid[0];
        q = constant(-value(c.kid[1]));
    }
    if (p < 0) {
        p = condition;
        q = constant(0);
    }
    if (p == yes && q == no) return make(OP_MAX, p, q);
    if (p == no && q == yes) return make(OP_MIN, p, q);
    const Node low = (*this)[no];
    if (p == yes && is_constant(p) && low.op == OP_MIN)
        for (int k = 0; k < 2; k++)
            if (low.kid[k] == q && is_constant(low.kid[1 - k]) && value(low.kid[1 - k]) >= value(p))
                return make(OP_MAX, no, p);
    Node n;
    n.op = NODE_IF;
    n.kid_count = 3;
    n.kid[0] = condition;
    n.kid[1] = yes;
    n.kid[2] = no;
    return intern(n);
}

int Graph::lookup(uint32_t op, const std::vector<int>& kids, uint32_t aux, int channels) {
    Node n;
    n.op = uint8_t(op);
    n.aux = aux;
    n.value = channels;
    bool constants = true;
    for (int k : kids) {
        constants = constants && is_constant(k);
        n.kid[n.kid_count++] = k;
    }
    if (constants && op == OP_NOISE)
        return constant(device::cal_noise3_slope(value(kids[0]), value(kids[1]), value(kids[2]), int(aux)));
    if (constants && op == OP_FNOISE)
        return constant(device::cal_fnoise3(value(kids[0]), value(kids[1]), value(kids[2])));
    return intern(n);
}

int Graph::channel(int node, uint32_t k) {
    Node n;
    n.op = NODE_CHANNEL;
    n.aux = k;
    n.kid_count = 1;
    n.kid[0] = node;
    return intern(n);
}

// Is node `id` a min with something not above `limit`, or a max with something not below it (also one inside the
// other)?
static bool within(const Graph& g, int id, uint32_t op, double limit) {
    for (int depth = 0; depth < 2 && (g[id].op == OP_MIN || g[id].op == OP_MAX); depth++) {
        int inner = -1;
        for (int k = 0; k < 2; k++) {
            if (!g.is_constant(g[id].kid[k])) inner = g[id].kid[k];
            else if (g[id].op == op && std::fabs(g.value(g[id].kid[k])) <= std::fabs(limit)) return true;
        }
        if (inner < 0) break;
        id = inner;
    }
    return false;
}

bool may_fail(const Graph& g, const Node& n) {
    switch (n.op) {
    case OP_ASIN:
    case OP_ACOS: return !(within(g, n.kid[0], OP_MIN, 1) && within(g, n.kid[0], OP_MAX, -1));
    case OP_DIV: return !g.is_constant(n.kid[1]) || g.value(n.kid[1]) == 0;
    case OP_POW:
    case OP_SQRT:
    case OP_EXP:
    case OP_LOG:
    case OP_LOG10:
    case OP_FAIL: return true;
    default: return false;
    }
}

bool forgets(const Node& n) {
    return n.op == NODE_IF || n.op == OP_NOISE || n.op == OP_FNOISE || n.op == OP_MIN || n.op == OP_MAX ||
           n.op == OP_POW || (n.op >= OP_SQRT && n.op <= OP_RAND);
}

}  // namespace cal
