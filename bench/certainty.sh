#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# What intervals cost vcmetrics: bench/certainty.sh build/bin [older/bin]
# Processor seconds, the system's included (medians of RUNS, taking turns, each the mean of five), of a stream of sums
# of the office (ptaccum -every x2/16) without intervals, with -ci and with -until alone, and the most memory; with a
# second folder also of its programs.
set -eu
new=$(cd "$1" && pwd) old=${2:+$(cd "$2" && pwd)}
top=$(cd "$(dirname "$0")/.." && pwd)
size=${SIZE:-512} frames=${FRAMES:-129} runs=${RUNS:-5}
dir=$(mktemp -d "${TMPDIR:-/dev/shm}/certainty-bench.XXXXXX")
trap 'rm -rf "$dir"' EXIT

cd "$top/examples/scenes/office"
"$new/ptrace" -w- -ab 2 -vf view.vf -x "$size" -y "$size" -frames "$frames" materials.rad layout.rad sky_1400.rad |
    "$new/ptaccum" -every x2/16 -ff > "$dir/stream"
cd "$dir"
for ((run = 0; run < runs; run++)); do
    for bin in "$new" ${old:+"$old"}; do
        for way in plain ci until; do
            case $way in
                plain) options=() ;;
                ci) options=(-ci 95) ;;
                until) options=(-until 'Ev .0001%') ;;
            esac
            /usr/bin/time -a -o "$way$(cksum <<< "$bin" | cut -d ' ' -f 1)" -f '%U %S %M' \
                bash -c 'for k in 1 2 3 4 5; do "$@" stream > out 2> /dev/null; done' - \
                "$bin/vcmetrics" "${options[@]}" || [ "$way" = until ]
        done
    done
done
echo "# $size x $size, $(($(wc -l < out) - 1)) sums of $((frames - 1)) frames: seconds, share for intervals, MB"
for bin in "$new" ${old:+"$old"}; do
    id=$(cksum <<< "$bin" | cut -d ' ' -f 1)
    for way in plain ci until; do
        awk '/^[0-9. ]+$/ { print ($1 + $2) / 5, $3 }' "$way$id" | sort -n | awk -v way=$way -v bin="$bin" '
            { time[++n] = $1; memory = $2 }
            END { print bin, way, time[int((n + 1) / 2)], memory / 1024 }'
    done | awk '
        $2 == "plain" { plain = $3 }
        { printf "%s\t%s\t%s\t%.0f %%\t%.0f\n", $1, $2, $3, ($3 > 0 ? 100 * (1 - plain / $3) : 0), $4 }'
done
