#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# The speed claims, measured again: bench/run.sh build/bin.  Rates are per second of processor time, so that other jobs on
# the machine matter less; the numbers in the sources' headers and in docs/ come from these lines.
set -eu
bin=$1
cmake --build "$bin/.." --target bench_programs >/dev/null
for isa in baseline avx2 avx512; do
    program=$bin/bench_traversal_$isa
    [ -x "$program" ] || continue
    if [ $isa != baseline ] && ! grep -q -w "${isa/avx512/avx512vl}" /proc/cpuinfo; then continue; fi
    for thousands in 20 500; do
        echo "# bench_traversal_$isa $thousands"
        "$program" $thousands
    done
done
