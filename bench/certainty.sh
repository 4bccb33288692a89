#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# What intervals cost vcmetrics: bench/certainty.sh build/bin [older/bin]
# Processor seconds, the system's included, of a stream of sums of the office (EVERY, x2/16) without intervals, with
# -ci and with -until alone, and the most memory; with a second folder also of its programs.  Each of RUNS (11) runs
# takes turns among all, and is the mean of five.  A share is of the time beside it in the same run: what is shown is
# its median over the runs and the two quartiles between which half of them lie, which tell the machine's noise.
set -eu
new=$(cd "$1" && pwd) old=${2:+$(cd "$2" && pwd)}
top=$(cd "$(dirname "$0")/.." && pwd)
size=${SIZE:-512} frames=${FRAMES:-129} runs=${RUNS:-11} every=${EVERY:-x2/16}
dir=$(mktemp -d "${TMPDIR:-/dev/shm}/certainty-bench.XXXXXX")
trap 'rm -rf "$dir"' EXIT

cd "$top/examples/scenes/office"
"$new/ptrace" -w- -ab 2 -vf view.vf -x "$size" -y "$size" -frames "$frames" materials.rad layout.rad sky_1400.rad |
    "$new/ptaccum" -every "$every" -ff > "$dir/stream"
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
# quantile COLUMN SHARE
quantile() {
    sort -n -k "$1,$1" runs | awk -v k="$1" -v q="$2" '{ v[NR] = $k } END { print v[int(1.5 + q * (NR - 1))] }'
}
sums=$(($(wc -l < out) - 1))
echo "# $size x $size, $sums sums of $((frames - 1)) frames: seconds, share for intervals (quartiles), MB"
for bin in "$new" ${old:+"$old"}; do
    id=$(cksum <<< "$bin" | cut -d ' ' -f 1)
    for way in plain ci until; do
        paste <(grep -E '^[0-9. ]+$' "plain$id") <(grep -E '^[0-9. ]+$' "$way$id") |
            awk '{ print ($4 + $5) / 5, 100 * (1 - ($1 + $2) / ($4 + $5)), $6 / 1024 }' > runs
        printf '%s\t%s\t%.3f\t%.0f %% (%.0f to %.0f)\t%.0f\n' "$bin" "$way" "$(quantile 1 .5)" \
            "$(quantile 2 .5)" "$(quantile 2 .25)" "$(quantile 2 .75)" "$(quantile 3 .5)"
    done
done
