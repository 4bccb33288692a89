// SPDX-License-Identifier: BSD-3-Clause
// An error of the input is what a reader should give; anything else is a find.  Warnings are silent.
#pragma once
#include "base/error.h"
#include "base/warnings.h"

template <class Read>
void try_to(Read read) {
    base::set_warning_sink({});
    try {
        read();
    } catch (const base::Error&) {}
    base::take_warnings();
}
