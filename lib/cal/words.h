// SPDX-License-Identifier: BSD-3-Clause
// The words of a program of the register VM (kernels/cal/cal_vm.h), from steps over values.
// A program is written twice: the first time says which step mentions a value last, the second time gives it a register
// until then.  Jumps only go forward, so a value lives from its first to its last mention.
#pragma once
#include <cstdint>
#include <string>
#include <vector>
#include "base/error.h"
#include "cal/ops.h"

namespace cal {

// One instruction over values, which are numbered as they come; -1 = none.
struct Step {
    uint32_t op;
    int d = -1, a = -1, b = -1, c = -1;  // c: OP_SEL
    bool immediate = false;              // b is `value`
    float value = 0;
    uint32_t aux = 0;  // raw destination, b field or table, by operation
};

class Words {
public:
    // first: the first writing of the same program; null: this is it, and registers are 0.
    Words(const std::string& place, const Words* first)
        : place_(place), first_(first ? &first->values_ : nullptr), free_(CAL_REGISTERS, 'f') {}
    const std::vector<uint32_t>& list() const { return words_; }
    size_t steps() const { return steps_; }

    // A value, or several side by side.
    int fresh(int count = 1) {
        const int first = int(values_.size());
        for (int i = 0; i < count; i++) values_.push_back({first, size_t(count)});
        return first;
    }
    void emit(const Step& s) {
        ++steps_;
        const uint32_t a = in_vm(s.a), b = in_vm(s.b), c = in_vm(s.c);
        // what ends here is free for the destination, except for blocks read while written
        if (s.op != OP_DATA)
            for (const int v : {s.a, s.b, s.c}) end(v);
        const uint32_t d = s.op == OP_OUT ? s.aux : in_vm(s.d);
        if (s.op == OP_DATA) end(s.a);
        end(s.d);
        last_ = words_.size(), written_ = s.d;
        words_.push_back(s.op | d << 8 | (s.op == OP_VAR ? s.aux : a) << 16 | (s.op == OP_NOISE ? s.aux : b) << 24 |
                         (s.immediate ? 128u : 0u));
        if (s.immediate) words_.push_back(as_uint_(s.value));
        if (s.op == OP_SEL) words_.push_back(c);
        if (s.op == OP_DATA || s.op == OP_TEXT) words_.push_back(s.aux);
    }
    // The last step, if it writes `from`, writes `to` in its place; false: it does not.
    bool redirect(int from, int to) {
        if (written_ != from) return false;
        words_[last_] = (words_[last_] & ~0xff00u) | in_vm(to) << 8;
        return true;
    }
    // Gives the place of the distance, which land() fills in.
    size_t jump(uint32_t op, int condition = -1) {
        emit({op, -1, condition});
        words_.push_back(0);
        return words_.size() - 1;
    }
    void land(size_t jump) { words_[jump] = uint32_t(words_.size() - jump - 1); }

private:
    struct Value {
        int block;  // the first of those side by side
        size_t width;
        size_t last = 0;                // step that mentions it
        size_t at = std::string::npos;  // the VM's register
    };
    // The register of a value that the present step mentions.
    uint32_t in_vm(int v) {
        if (v < 0) return 0;
        const int block = values_[size_t(v)].block;
        Value& x = values_[size_t(block)];
        x.last = steps_;
        if (!first_) return 0;
        if (x.at == std::string::npos) {
            x.at = free_.find(std::string(x.width, 'f'));
            if (x.at == std::string::npos) base::fail(place_, "function needs too many intermediate values");
            free_.replace(x.at, x.width, x.width, 'u');
        }
        return uint32_t(x.at) + uint32_t(v - block);
    }
    void end(int v) {
        if (v < 0 || !first_) return;
        const size_t block = size_t(values_[size_t(v)].block);
        const Value& x = values_[block];
        if ((*first_)[block].last == steps_) free_.replace(x.at, x.width, x.width, 'f');
    }

    const std::string& place_;
    const std::vector<Value>* const first_;
    std::vector<Value> values_;
    std::string free_;  // registers: f free, u used
    std::vector<uint32_t> words_;
    size_t steps_ = 0, last_ = 0;  // so far; where the last one stands
    int written_ = -1;             // by it
};

}  // namespace cal
