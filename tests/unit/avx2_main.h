// SPDX-License-Identifier: BSD-3-Clause
// main of tests that are compiled twice, also for AVX2: skips (77) where the processor has none.
#pragma once
#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>
#include <cstdio>

int main(int argc, char** argv) {
#ifdef __AVX2__
    if (!__builtin_cpu_supports("avx2")) {
        std::puts("skipped: this processor has no AVX2");
        return 77;
    }
#endif
    return doctest::Context(argc, argv).run();
}
