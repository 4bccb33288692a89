// SPDX-License-Identifier: BSD-3-Clause
// One budget of work for a whole scene: a few lines of text can ask for more copies than there are atoms (arrays of
// arrays, octrees of octrees), and a reader must end.  Counted are steps: a primitive and a kilobyte of text are
// one each, an opened file, a copy of xform and a placed instance ten.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace base {

// What a check throws when nobody wants the scene any more.
struct GivenUp {};

class WorkBudget {
public:
    static constexpr uint64_t usual_limit = 100000000;  // about a minute and some gigabytes
    // check: is called while the work goes on, and throws GivenUp where it need not.
    using Check = std::function<void()>;
    explicit WorkBudget(uint64_t limit = usual_limit, Check check = {})
        : limit_(limit), left_(limit), check_(std::move(check)) {}

    // Of work that is not counted.
    void check() const {
        if (check_) check_();
    }
    // False: nothing is left.
    bool spend(uint64_t steps) {
        if ((since_check_ += steps) >= steps_a_check) since_check_ = 0, check();
        const bool enough = steps <= left_;
        left_ = enough ? left_ - steps : 0;
        return enough;
    }
    [[noreturn]] void fail(const std::string& place) const;  // an Error that names the limit and how to raise it
    void spend(uint64_t steps, const std::string& place) {
        if (!spend(steps)) fail(place);
    }

private:
    static constexpr uint64_t steps_a_check = 1000;  // some milliseconds
    uint64_t limit_, left_, since_check_ = 0;
    Check check_;
};

// With the limit of $LUXPIPE_WORK, or the usual one.
std::shared_ptr<WorkBudget> work_budget_from_environment(WorkBudget::Check check = {});

}  // namespace base
