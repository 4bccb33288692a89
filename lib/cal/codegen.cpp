// SPDX-License-Identifier: BSD-3-Clause
// From the graph to the VM's words: the graph is walked from the outputs, and every value is computed once, where it is
// first needed; a value needed only in one branch of an `if` is computed there, one needed in both before the jump.
#include "cal/codegen.h"
#include <algorithm>
#include <cmath>
#include <unordered_set>
#include "base/error.h"
#include "cal/words.h"

namespace cal {

namespace {

constexpr size_t max_steps = 200000;
constexpr int max_walk = 3000;  // depth of the graph walk: C++ stack

class ProgramWriter {
public:
    // early: what both sides of a branch may need is computed before it, so that the values it is made of die early
    ProgramWriter(const Graph& graph, const std::string& place, bool early, const Words* first)
        : g_(graph), place_(place), early_(early), where_(graph.size(), -1), words_(place, first) {}

    Words write(const std::vector<int>& outputs) {
        for (size_t i = 0; i < outputs.size(); i++) {
            Step s{OP_OUT};
            s.aux = uint32_t(i);
            operand(outputs[i], s);
            emit(s);
        }
        emit(Step{OP_END});
        return std::move(words_);
    }

private:
    [[noreturn]] void too_large() const { base::fail(place_, "function is too large to compile"); }

    void emit(const Step& s) {
        if (words_.steps() >= max_steps) too_large();
        words_.emit(s);
    }
    int fresh(int count = 1) { return words_.fresh(count); }

    void clear() {
        if (failed_) emit(Step{OP_CLEAR});
        failed_ = false;
    }

    // A constant goes into the instruction, anything else into a register.
    void operand(int id, Step& s) {
        if (g_.is_constant(id)) {
            s.immediate = true;
            s.value = float(g_.value(id));
        } else s.b = value(id);
    }
    int in_register(int id) {
        if (!g_.is_constant(id)) return value(id);
        Step s{OP_MOV};
        s.immediate = true;
        s.value = float(g_.value(id));
        s.d = fresh();
        emit(s);
        return s.d;
    }

    // The virtual register that holds node `id`, computed now unless it is there.
    int value(int id) {
        if (where_[size_t(id)] >= 0) return where_[size_t(id)];
        if (++depth_ > max_walk) too_large();
        const Node& n = g_[id];
        if (forgets(n)) clear();
        const int r = compute(id, n);
        if (may_fail(g_, n)) failed_ = true;
        depth_--;
        if (where_[size_t(id)] < 0) {
            where_[size_t(id)] = r;
            trail_.push_back(id);
        }
        return r;
    }

    int compute(int id, const Node& n) {
        Step s{n.op};
        switch (n.op) {
        case NODE_CONST: return in_register(id);
        case NODE_IF: return branch(n);
        case OP_VAR: s.aux = n.aux; break;
        case NODE_CHANNEL: return value(n.kid[0]) + int(n.aux);
        case OP_NOISE:
        case OP_FNOISE:
        case OP_DATA: {
            std::vector<int> from;
            for (int i = 0; i < n.kid_count; i++) from.push_back(g_.is_constant(n.kid[i]) ? -1 : value(n.kid[i]));
            s.a = fresh(n.kid_count);
            for (int i = 0; i < n.kid_count; i++) {
                Step m{OP_MOV};
                m.d = s.a + i;
                if (from[size_t(i)] >= 0) m.b = from[size_t(i)];
                else {
                    m.immediate = true;
                    m.value = float(g_.value(n.kid[i]));
                }
                emit(m);
            }
            s.aux = n.aux;
            s.d = fresh(n.op == OP_DATA ? int(n.value) : 1);
            emit(s);
            return s.d;
        }
        case OP_TEXT:
            s.a = in_register(n.kid[0]);
            s.b = in_register(n.kid[1]);
            s.aux = n.aux;
            break;
        default: {
            if (n.kid_count == 0) break;
            int a = n.kid[0], b = n.kid_count > 1 ? n.kid[1] : -1;
            if (b >= 0 && g_.is_constant(a) && !g_.is_constant(b) && swapped(n.op, s.op)) std::swap(a, b);
            s.a = in_register(a);
            if (b >= 0) operand(b, s);
            int exponent;
            if (s.op == OP_DIV && s.immediate && std::fabs(std::frexp(s.value, &exponent)) == 0.5f &&
                std::abs(exponent) < 100) {
                s.op = OP_MUL;  // by a power of 2: exact; other quotients must stay (mod(n,d))
                s.value = 1 / s.value;
            }
        }
        }
        s.d = fresh();
        emit(s);
        return s.d;
    }

    static bool swapped(uint32_t op, uint32_t& other) {
        switch (op) {
        case OP_ADD:
        case OP_MUL:
        case OP_MIN:
        case OP_MAX: other = op; return true;
        case OP_SUB: other = OP_RSUB; return true;
        case OP_DIV: other = OP_RDIV; return true;
        case OP_POW: other = OP_RPOW; return true;
        default: return false;
        }
    }

    bool ready(int id) const { return g_.is_constant(id) || where_[size_t(id)] >= 0; }

    // Everything `id` computes for certain (through conditions, not through branches), and, if asked, all it might.
    void collect(int id, bool all, std::unordered_set<int>& set) const {
        std::vector<int> todo{id};
        while (!todo.empty()) {
            const int k = todo.back();
            todo.pop_back();
            if (ready(k) || !set.insert(k).second) continue;
            const Node& n = g_[k];
            const int kids = n.op == NODE_IF && !all ? 1 : n.kid_count;
            for (int i = 0; i < kids; i++) todo.push_back(n.kid[i]);
        }
    }

    size_t size_of(int id) const {
        std::unordered_set<int> set;
        collect(id, true, set);
        return set.size();
    }

    int branch(const Node& n, int into = -1) {
        const int condition = value(n.kid[0]);
        hoist(n.kid[1], n.kid[2], false);
        if (early_ || words_.steps() > 64 * (g_.size() + 16)) hoist(n.kid[1], n.kid[2], true);  // shared further below
        const int result = into >= 0 ? into : fresh();
        if (ready(n.kid[1]) && ready(n.kid[2])) {
            Step s{OP_SEL};
            s.a = in_register(n.kid[1]);
            s.b = in_register(n.kid[2]);
            s.c = condition;
            s.d = result;
            emit(s);
            return s.d;
        }
        const bool failed = failed_;
        const size_t unless = words_.jump(OP_JUMP_UNLESS, condition);
        // early: the shorter side first, so that what it alone needs has ended before the longer one
        const bool turned = early_ && size_of(n.kid[2]) < size_of(n.kid[1]);
        const size_t over = turned ? words_.jump(OP_JUMP) : unless;
        if (turned) words_.land(unless);
        arm(n.kid[turned ? 2 : 1], result);
        const size_t to_end = words_.jump(OP_JUMP);
        const bool failed_first = failed_;
        failed_ = failed;
        words_.land(over);
        arm(n.kid[turned ? 1 : 2], result);
        words_.land(to_end);
        failed_ = failed_ || failed_first;
        return result;
    }

    // One side of a branch: what it computes is forgotten afterwards.
    void arm(int id, int result) {
        const size_t mark = trail_.size();
        if (early_ && !ready(id) && g_[id].op == NODE_IF) {
            if (++depth_ > max_walk) too_large();
            clear();  // an `if` forgets
            branch(g_[id], result);
            depth_--;
            forget(mark);
            return;
        }
        const bool own_step = !ready(id) && g_[id].op != NODE_IF && g_[id].op != NODE_CHANNEL && g_[id].op != OP_DATA;
        Step m{OP_MOV};
        operand(id, m);
        m.d = result;
        if (!own_step || !words_.redirect(m.b, result)) emit(m);  // else its last step writes the result itself
        forget(mark);
    }

    void forget(size_t mark) {
        for (; trail_.size() > mark; trail_.pop_back()) where_[size_t(trail_.back())] = -1;
    }

    // Computes before a jump what both sides need.  Speculative values must not leave an error behind.
    void hoist(int yes, int no, bool speculative) {
        std::unordered_set<int> a, b;
        collect(yes, speculative, a);
        collect(no, speculative, b);
        std::vector<int> both;
        for (int id : a)
            if (b.count(id) && g_[id].op != OP_FAIL) both.push_back(id);
        std::sort(both.begin(), both.end());  // kids before parents, the same order every time
        int state = -1;
        const bool failed = failed_;
        if (speculative && !both.empty()) {
            Step keep{OP_KEEP};
            keep.d = state = fresh();
            emit(keep);
        }
        for (int id : both) value(id);
        if (state >= 0) {
            Step restore{OP_RESTORE};
            restore.a = state;
            emit(restore);
            failed_ = failed;
        }
    }

    const Graph& g_;
    const std::string& place_;
    const bool early_;
    std::vector<int> where_;  // node -> value, -1
    std::vector<int> trail_;  // nodes computed, in order
    Words words_;
    bool failed_ = false;  // an error may be pending here
    int depth_ = 0;
};

}  // namespace

uint32_t generate(const Graph& graph, const std::vector<int>& outputs, const std::string& place, Code& code) {
    if (outputs.size() > CAL_OUTPUTS) base::fail(place, "too many function values");
    const auto words = [&](bool early) {
        const Words first = ProgramWriter(graph, place, early, nullptr).write(outputs);
        return ProgramWriter(graph, place, early, &first).write(outputs).list();
    };
    std::vector<uint32_t> list;
    try {
        list = words(false);
    } catch (const base::Error&) {  // too few registers, as in a sum of many terms by an accumulator
        list = words(true);
    }
    code.words.insert(code.words.end(), list.begin(), list.end());
    return uint32_t(code.words.size() - list.size());
}

}  // namespace cal
