// SPDX-License-Identifier: BSD-3-Clause
// See work_budget.h.
#include "base/work_budget.h"

#include <cstdlib>

#include "base/error.h"
#include "base/value.h"

namespace base {

void WorkBudget::fail(const std::string& place) const {
    base::fail(place, "the scene takes more than " + std::to_string(limit_) +
                          " steps of work (primitives, copies, instances); LUXPIPE_WORK raises this limit");
}

std::shared_ptr<WorkBudget> work_budget_from_environment(WorkBudget::Check check) {
    const char* value = std::getenv("LUXPIPE_WORK");
    if (!value) return std::make_shared<WorkBudget>(WorkBudget::usual_limit, std::move(check));
    const long limit = to_int(value, "LUXPIPE_WORK");
    if (limit < 1) fail("LUXPIPE_WORK", '"' + std::string(value) + "\" is not above 0");
    return std::make_shared<WorkBudget>(uint64_t(limit), std::move(check));
}

}  // namespace base
