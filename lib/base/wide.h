// SPDX-License-Identifier: BSD-3-Clause
// WIDE_LOOP before a function: its loops over all pixels take the widest lanes of the processor that runs them, those
// of WIDEST_LOOP also AVX-512's.  The bits do not depend on the lanes.  (Sanitizers start before such a choice can be
// made; Windows and macOS cannot make it.)
#pragma once

#if defined(__x86_64__) && defined(__ELF__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define WIDE_LOOP __attribute__((target_clones("avx2", "default")))
#define WIDEST_LOOP __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define WIDE_LOOP
#define WIDEST_LOOP
#endif
