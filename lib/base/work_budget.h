// SPDX-License-Identifier: BSD-3-Clause
// One budget of work for a whole scene: a few lines of text can ask for more copies than there are atoms (arrays of
// arrays, octrees of octrees), and a reader must end.  Counted are steps: a primitive and a kilobyte of text are
// one each, an opened file, a copy of xform and a placed instance ten.
#pragma once
#include <cstdint>
#include <memory>
#include <string>

namespace base {

class WorkBudget {
public:
    static constexpr uint64_t usual_limit = 100000000;  // about a minute and some gigabytes
    explicit WorkBudget(uint64_t limit = usual_limit) : limit_(limit), left_(limit) {}

    // False: nothing is left.
    bool spend(uint64_t steps) {
        const bool enough = steps <= left_;
        left_ = enough ? left_ - steps : 0;
        return enough;
    }
    [[noreturn]] void fail(const std::string& place) const;  // an Error that names the limit and how to raise it
    void spend(uint64_t steps, const std::string& place) {
        if (!spend(steps)) fail(place);
    }

private:
    uint64_t limit_, left_;
};

// With the limit of $LUXPIPE_WORK, or the usual one.
std::shared_ptr<WorkBudget> work_budget_from_environment();

}  // namespace base
