#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# Speed of vcmetrics, and of evalglare where it is on PATH, in one run: bench/vcmetrics.sh build/bin
#   1. pictures a second on one core of a 512 x 512 float stream of the office, clean and at frame 4
#   2. smoothing (-s), 512 to 2048 pixels a side: four times the pixels, about four times the time
#   3. seconds and memory of one picture with 300 sources, 1024 to 4096 pixels a side
set -eu
bin=$(cd "$1" && pwd)
top=$(cd "$(dirname "$0")/.." && pwd)
cmake --build "$bin/.." --target bright_discs > /dev/null
dir=$(mktemp -d "${TMPDIR:-/dev/shm}/vcmetrics-bench.XXXXXX")
trap 'rm -rf "$dir"' EXIT
PATH=$bin:$PATH
evalglare=$(command -v evalglare || true)

if [ -x "$bin/ptrace" ]; then
    cd "$top/examples/scenes/office"
    scene="materials.rad layout.rad sky_1400.rad"
    ptrace -w- -vf view.vf -x 512 -y 512 -frames 5 $scene | ptaccum -last -ff > "$dir/noisy"
    ptrace -w- -vf view.vf -x 512 -y 512 -frames ${FRAMES:-64} $scene | ptaccum -last -ff > "$dir/clean"
    for picture in clean noisy; do
        for k in $(seq 200); do cat "$dir/$picture"; done > "$dir/stream"
        echo "# $picture office, 200 pictures through a pipe"
        TIMEFORMAT='%R %U %S'
        { time taskset -c 0 "$bin/vcmetrics" < <(cat "$dir/stream") > /dev/null; } 2>&1 |
            awk '{ printf "%.0f pictures/s by the clock, %.0f by processor time\n", 200 / $1, 200 / ($2 + $3) }'
        rm "$dir/stream"
    done
    TIMEFORMAT='%R s wall, %U s processor'
    if [ -n "$evalglare" ]; then
        ptrace -w- -vf view.vf -x 512 -y 512 -frames 5 $scene | ptaccum -last -fc > "$dir/noisy.hdr"
        echo "# evalglare, the noisy office once"
        time "$evalglare" "$dir/noisy.hdr" > /dev/null 2>&1
    fi
fi
TIMEFORMAT='%R s wall, %U s processor'
for size in 512 1024 2048; do
    "$bin/bright_discs" $size 300 > "$dir/discs.hdr"
    echo "# $size x $size, 300 discs, -s"
    time "$bin/vcmetrics" -s -metrics n_sources,DGP "$dir/discs.hdr" | tail -n 1 | cut -f 2-
done
for size in 1024 2048 4096; do
    "$bin/bright_discs" $size 300 > "$dir/discs.hdr"
    echo "# $size x $size, 300 discs, search radius 0.1"
    time "$bin/vcmetrics" -r 0.1 -metrics n_sources,Ev,DGP,RAMMG "$dir/discs.hdr" | tail -n 1 | cut -f 2-
    if [ -n "$evalglare" ] && [ $size -le "${EVALGLARE_SIDE:-1024}" ]; then
        echo "# evalglare (larger sizes: EVALGLARE_SIDE=4096)"
        time "$evalglare" -r 0.1 "$dir/discs.hdr" 2> /dev/null
    fi
done
