#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# What an hour of a year costs those who read it: bench/hours.sh build/bin [older/bin]
# 60 hours of the office under made-up weather, SIZE x SIZE (64) pixels, with 9 and with 17 frames.  Milliseconds of
# processor time an hour, system's included, on one thread: of `ptaccum -every x2/8`, of `vcmetrics -last` with
# intervals, of both; medians of RUNS.  With a second folder the two take turns.  Then seconds of ptrace for 96 sensors
# and all hours of the year.
set -eu
new=$(cd "$1" && pwd) old=${2:+$(cd "$2" && pwd)}
top=$(cd "$(dirname "$0")/.." && pwd)
size=${SIZE:-64} runs=${RUNS:-7}
dir=$(mktemp -d "${TMPDIR:-/dev/shm}/hours-bench.XXXXXX")
trap 'rm -rf "$dir"' EXIT
export LUXPIPE_THREADS=1
TIMEFORMAT='%U %S'
python3 "$top/studies/year/weather.py" > "$dir/site.epw"
cd "$top/examples/scenes/office"

sum() { { time "$1/ptaccum" -every x2/8 < "$dir/frames" 2> /dev/null > "$dir/sums"; } 2>&1; }
measure() {
    { time "$1/vcmetrics" -W- -last -metrics Ev,DGPf,pixels -ci 95 < "$dir/sums" 2> /dev/null > "$dir/rows"; } 2>&1
}
middle() { sort -g "$1" | awk -v column="$2" '{ v[NR] = $column } END { printf "\t%.2f", v[int((NR + 1) / 2)] }'; }

echo "# $size x $size, $(nproc) cores, load $(cut -d ' ' -f 1 /proc/loadavg): frames, ms of ptaccum, vcmetrics, both"
for frames in 9 17; do
    "$new/ptrace" -w- -wea "$dir/site.epw" -hours '0421 0521 0621 0721 0821 0921 8-18' -vf view.vf -x "$size" \
        -y "$size" -frames $frames materials.rad layout.rad > "$dir/frames" 2> "$dir/log" || { cat "$dir/log"; exit 1; }
    for ((run = 0; run < runs; run++)); do
        for bin in "$new" ${old:+"$old"}; do
            name=new
            [ "$bin" = "$new" ] || name=old
            seconds="$(sum "$bin") $(measure "$bin")"
            awk -v hours="$(awk 'END { print NR - 1 }' "$dir/rows")" '{ n = 1000 / hours
                print n * ($1 + $2), n * ($3 + $4), n * ($1 + $2 + $3 + $4) }' <<< "$seconds" >> "$dir/$name.$frames"
        done
    done
    for name in new ${old:+old}; do
        printf '%s\t%d' "$name" "$frames"
        for column in 1 2 3; do middle "$dir/$name.$frames" $column; done
        echo
    done
done

awk 'BEGIN { for (i = 0; i < 96; i++) print .3 + .45 * (i % 8), .2 + .4 * int(i / 8), .8, 0, 0, 1 }' > "$dir/plan.pts"
for frames in 9 17 33; do
    for bin in "$new" ${old:+"$old"}; do
        { time "$bin/ptrace" -w- -wea "$dir/site.epw" -points "$dir/plan.pts" -frames $frames materials.rad layout.rad \
            > /dev/null 2>&1; } 2>&1 |
            awk -v name="$bin" -v frames=$frames '{ printf "%s\t%d\t%.1f s\n", name, frames, $1 + $2 }'
    done
done
