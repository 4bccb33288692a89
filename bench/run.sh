#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# The speed claims, measured again: bench/run.sh build/bin.  Rates are per second of processor time, so that other jobs
# on the machine matter less; the numbers in the sources' headers and in docs/ come from these lines.  Sizes are such
# that one quiet core is done in about twenty minutes; each part says what it took, and takes larger ones by itself.
set -eu
bin=$(cd "$1" && pwd) bench=$(cd "$(dirname "$0")" && pwd)
cmake --build "$bin/.." --target bench_programs >/dev/null

failed=0
part() {  # its name, then the command
    local name=$1 before=$SECONDS
    shift
    echo "## $name"
    "$@" || { failed=$?; echo "## $name failed: status $failed"; }
    echo "## $name: $((SECONDS - before)) s"
}
small() { env SIZE=96 FRAMES=128 REFERENCE=384 SEEDS=1 "$bench/sampling.sh" "$bin"; }

for isa in baseline avx2 avx512; do
    program=$bin/bench_traversal_$isa
    [ -x "$program" ] || continue
    if [ $isa != baseline ] && ! grep -q -w "${isa/avx512/avx512vl}" /proc/cpuinfo; then continue; fi
    part "bench_traversal_$isa 20" "$program" 20
    widest=$isa
done
part "bench_traversal_$widest 500" "$bin/bench_traversal_$widest" 500
part bench_scene_load "$bin/bench_scene_load"
part bench_cal_vm "$bin/bench_cal_vm"
part gpu_kernels.sh "$bench/gpu_kernels.sh"
part regions.sh "$bench/regions.sh" "$bin"
part sampling.sh small
part metrics.sh env REFERENCE=384 SEEDS=5 "$bench/metrics.sh" "$bin"
part mitsuba.sh env REFERENCE=512 SEEDS=3 "$bench/mitsuba.sh" "$bin"
part nobias.sh env FRAMES=64 "$bench/nobias.sh" "$bin"
part frames.sh "$bench/frames.sh" "$bin"
part startup.sh env RUNS=3 "$bench/startup.sh" "$bin"
part scale.sh env RUNS=1 TRIANGLES='1000 100000' "$bench/scale.sh" "$bin"
part points.sh env POINTS='100 10000' "$bench/points.sh" "$bin"
exit $failed
