#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# The speed claims, measured again: bench/run.sh build/bin.  Rates are per second of processor time, so that other jobs
# on the machine matter less; the numbers in the sources' headers and in docs/ come from these lines.
set -eu
bin=$(cd "$1" && pwd)
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
echo "# bench_scene_load"
"$bin/bench_scene_load"
echo "# bench_cal_vm"
"$bin/bench_cal_vm"
"$(dirname "$0")/regions.sh" "$bin"
"$(dirname "$0")/sampling.sh" "$bin"
"$(dirname "$0")/metrics.sh" "$bin"
"$(dirname "$0")/mitsuba.sh" "$bin"
FRAMES=64 "$(dirname "$0")/nobias.sh" "$bin"
"$(dirname "$0")/frames.sh" "$bin"
RUNS=1 TRIANGLES='1000 100000' "$(dirname "$0")/scale.sh" "$bin"
