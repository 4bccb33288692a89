#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# The speed claims of docs/, measured again: bench/run.sh build/bin.  Rates are per second of processor time, so that
# other jobs on the machine matter less.  Sizes are such that one quiet core is done in about twenty minutes; each part
# says what it took, and takes larger ones by itself.
set -eu
bin=$(cd "$1" && pwd) bench=$(cd "$(dirname "$0")" && pwd)

failed=0
part() {  # its name, then the command
    local name=$1 before=$SECONDS
    shift
    echo "## $name"
    "$@" || { failed=$?; echo "## $name failed: status $failed"; }
    echo "## $name: $((SECONDS - before)) s"
}
small() { env SIZE=96 FRAMES=128 REFERENCE=384 SEEDS=1 "$bench/sampling.sh" "$bin"; }

part gpu_kernels.sh "$bench/gpu_kernels.sh"
part sampling.sh small
part metrics.sh env REFERENCE=384 SEEDS=5 "$bench/metrics.sh" "$bin"
part mitsuba.sh env REFERENCE=512 SEEDS=3 "$bench/mitsuba.sh" "$bin"
part nobias.sh env FRAMES=64 "$bench/nobias.sh" "$bin"
part frames.sh "$bench/frames.sh" "$bin"
part startup.sh env RUNS=3 "$bench/startup.sh" "$bin"
part scale.sh env RUNS=1 TRIANGLES='1000 100000' "$bench/scale.sh" "$bin"
part points.sh env POINTS='100 10000' "$bench/points.sh" "$bin"
exit $failed
