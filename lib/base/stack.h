// SPDX-License-Identifier: BSD-3-Clause
// Enough stack for what our readers allow (expressions nested a thousand deep), whatever `ulimit -s` says.
#pragma once
#include <functional>

namespace base {

// Calls body here, or, where the stack is limited to less than we need, in a thread with a stack of its own.  body must
// not throw.
void with_enough_stack(const std::function<void()>& body);

}  // namespace base
