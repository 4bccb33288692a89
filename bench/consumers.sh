#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# What a frame costs those who read it: bench/consumers.sh build/bin [older/bin].
# 300 frames of the office, 512 x 512, from a program that only repeats them (frame_stream).  Milliseconds of processor
# time, system's included: a frame of `ptaccum -every x2/16` and of `-last`, a picture of vcmetrics; medians of RUNS.
# With a second folder the two take turns.  Then frames a second by the clock, on all processors there are.
set -eu
new=$(cd "$1" && pwd) old=${2:+$(cd "$2" && pwd)}
top=$(cd "$(dirname "$0")/.." && pwd)
size=${SIZE:-512} frames=${FRAMES:-300} runs=${RUNS:-7}
nice cmake --build "$new/.." --target frame_stream > /dev/null
dir=$(mktemp -d "${TMPDIR:-/dev/shm}/consumers-bench.XXXXXX")
trap 'rm -rf "$dir"' EXIT
TIMEFORMAT='%U %S'

cd "$top/examples/scenes/office"
"$new/ptrace" -w- -vf view.vf -x $size -y $size -frames 0:8 materials.rad layout.rad sky_1400.rad > "$dir/few"
"$new/frame_stream" "$dir/few" 40 | "$new/ptaccum" -every 1 2> /dev/null > "$dir/sums"

stream() { "$new/frame_stream" "$dir/few" "$frames"; }
sum() { { time "$1/ptaccum" $2 < <(stream) > /dev/null; } 2>&1; }
measure() { { time "$1/vcmetrics" < "$dir/sums" > /dev/null; } 2>&1; }
middle() { sort -n | awk '{ v[NR] = $1 } END { print v[int((NR + 1) / 2)] }'; }
cost() { awk -v n="$2" '{ print 1000 * ($1 + $2) / n }' "$1" | middle; }

for ((run = 0; run < runs; run++)); do
    for bin in "$new" ${old:+"$old"}; do
        name=new
        [ "$bin" = "$new" ] || name=old
        sum "$bin" "-every x2/16" >> "$dir/$name.often"
        sum "$bin" -last >> "$dir/$name.last"
        measure "$bin" >> "$dir/$name.measure"
    done
done
echo "# $size x $size, $frames frames: ms a frame -every x2/16, ms a frame -last, ms a picture of vcmetrics"
for name in new ${old:+old}; do
    printf '%s\t%.2f\t%.2f\t%.2f\n' $name "$(cost "$dir/$name.often" "$frames")" \
        "$(cost "$dir/$name.last" "$frames")" "$(cost "$dir/$name.measure" 41)"
done
# By the clock, taking turns, too; and the stream alone, which is what the pipe itself can do.
TIMEFORMAT=%R
for ((run = 0; run < runs; run++)); do
    { time stream | cat > /dev/null; } 2>> "$dir/alone"
    for bin in "$new" ${old:+"$old"}; do
        name=new
        [ "$bin" = "$new" ] || name=old
        { time stream | "$bin/ptaccum" -every x2/16 | "$bin/vcmetrics" > /dev/null; } 2>> "$dir/$name.pipe"
    done
done
for name in new ${old:+old} alone; do
    [ $name = alone ] || mv "$dir/$name.pipe" "$dir/$name"
    printf '%s\t%s frames/s\n' $name "$(middle < "$dir/$name" | awk -v n="$frames" '{ printf "%.0f", n / $1 }')"
done
