// SPDX-License-Identifier: BSD-3-Clause
// Jumps only go forward, so a value lives from its first to its last mention: registers are given by one scan over
// these intervals.
#include "base/error.h"
#include "cal/ops.h"
#include "cal/steps.h"

namespace cal {

namespace {

// Registers of the VM for the blocks of virtual ones.
class Registers {
public:
    Registers(const Steps& steps, const std::string& place);
    uint32_t operator[](int v) const { return v < 0 ? 0u : uint32_t(place_[block(v)] + (v - int(block(v)))); }

private:
    size_t block(int v) const { return size_t(block_[size_t(v)]); }
    void find_lives();
    void start(size_t block, const std::string& place);
    void release(size_t step);

    const Steps& steps_;
    std::vector<int> block_;                 // of each virtual register: the first register of its block
    std::vector<int> first_, last_, place_;  // of each block: steps that mention it, its register
    std::vector<std::vector<size_t>> ends_;  // blocks that end at each step
    std::vector<char> used_;                 // registers of the VM
};

Registers::Registers(const Steps& steps, const std::string& place)
    : steps_(steps),
      block_(steps.width.size()),
      first_(steps.width.size(), -1),
      last_(first_),
      place_(first_),
      ends_(steps.list.size()),
      used_(CAL_REGISTERS, 0) {
    find_lives();
    for (size_t i = 0; i < steps.list.size(); i++) {
        // what ends here is free for the destination, except for blocks read while written
        const Step& s = steps.list[i];
        std::vector<size_t> starting;
        for (int v : {s.a, s.b, s.c, s.d})
            if (v >= 0 && first_[block(v)] == int(i)) starting.push_back(block(v));
        if (s.op != OP_DATA) release(i);
        for (size_t b : starting)
            if (place_[b] < 0) start(b, place);
        release(i);
    }
}

void Registers::find_lives() {
    for (size_t v = 0, head = 0; v < block_.size(); v++) {
        if (steps_.width[v] > 0) head = v;
        block_[v] = int(head);
    }
    for (size_t i = 0; i < steps_.list.size(); i++)
        for (int v : {steps_.list[i].a, steps_.list[i].b, steps_.list[i].c, steps_.list[i].d}) {
            if (v < 0) continue;
            if (first_[block(v)] < 0) first_[block(v)] = int(i);
            last_[block(v)] = int(i);
        }
}

// The first free registers side by side.
void Registers::start(size_t block, const std::string& place) {
    const int width = steps_.width[block];
    int at = 0;
    for (; at + width <= CAL_REGISTERS; at++) {
        int k = 0;
        while (k < width && !used_[size_t(at + k)]) k++;
        if (k == width) break;
    }
    if (at + width > CAL_REGISTERS) base::fail(place, "function needs too many intermediate values");
    place_[block] = at;
    for (int k = 0; k < width; k++) used_[size_t(at + k)] = 1;
    ends_[size_t(last_[block])].push_back(block);
}

void Registers::release(size_t step) {
    for (size_t b : ends_[step])
        for (int k = 0; k < steps_.width[b]; k++) used_[size_t(place_[b] + k)] = 0;
    ends_[step].clear();
}

}  // namespace

uint32_t assemble(const Steps& steps, const std::string& place, Code& code) {
    const Registers reg(steps, place);
    // Jumps are patched when the positions are known.
    const uint32_t entry = uint32_t(code.words.size());
    std::vector<uint32_t> position(steps.list.size() + 1);
    std::vector<std::pair<size_t, int>> patches;
    for (size_t i = 0; i < steps.list.size(); i++) {
        const Step& s = steps.list[i];
        position[i] = uint32_t(code.words.size());
        uint32_t word = s.op | reg[s.d] << 8 | reg[s.a] << 16 | reg[s.b] << 24;
        if (s.op == OP_OUT) word = s.op | s.aux << 8 | reg[s.b] << 24;
        if (s.op == OP_VAR) word = s.op | reg[s.d] << 8 | s.aux << 16;
        if (s.op == OP_NOISE) word = s.op | reg[s.d] << 8 | reg[s.a] << 16 | s.aux << 24;
        if (s.immediate) word |= 128u;
        code.words.push_back(word);
        if (s.immediate) code.words.push_back(as_uint_(s.value));
        if (s.op == OP_SEL) code.words.push_back(reg[s.c]);
        if (s.op == OP_DATA || s.op == OP_TEXT) code.words.push_back(s.aux);
        if (s.target >= 0) {
            patches.emplace_back(code.words.size(), s.target);
            code.words.push_back(0);
        }
    }
    for (const auto& p : patches) code.words[p.first] = position[size_t(p.second)] - uint32_t(p.first) - 1;
    return entry;
}

}  // namespace cal
