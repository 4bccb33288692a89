#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# What frames cost one core: bench/frames.sh build/bin [older/bin]
# One line a scene and device: processor seconds of frame 0, microseconds a pixel of the frames after it; medians of
# RUNS.  With a second folder the two take turns; then two columns have its time over the
# first's, and a word says whether the last frames have the same bits.
set -eu
new=$(cd "$1" && pwd) old=${2:+$(cd "$2" && pwd)}
top=$(cd "$(dirname "$0")/.." && pwd)
size=${SIZE:-256} frames=${FRAMES:-4} runs=${RUNS:-7} devices=${DEVICES:-cpu}
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
export LUXPIPE_THREADS=1
TIMEFORMAT=%U

words() { awk -F '\t' -v id="$1" -v column="$2" '$1 == id { print $column }' "$top/tests/golden/bits.tsv"; }
# seconds of a core: folder of programs, device, frames, scene; the pixels' checksum goes to a file
seconds() {
    { time "$1/ptrace" -w- -device "$2" -x "$size" -y "$size" -frames "$3" $(words "$4" 3) > "$dir/frames"; } 2>&1
    tail -c $((12 * size * size)) "$dir/frames" | cksum > "$dir/sum$(basename "$(dirname "$1")")"
}
median() { sort -n "$1" | awk '{ v[NR] = $1 } END { print v[int((NR + 1) / 2)] }'; }

echo "# $size x $size, $frames frames, one thread: s of frame 0, us a pixel and frame${old:+, ratios old/new}"
for scene in office_clear_1400 office_blinds_1100 classroom_back_row gallery_east; do
    cd "$top/$(words "$scene" 2)"
    for device in $devices; do
        rm -f "$dir"/*.times
        for ((run = 0; run < runs; run++)); do
            for bin in "$new" ${old:+"$old"}; do
                name=new
                [ "$bin" = "$new" ] || name=old
                seconds "$bin" "$device" 0:0 "$scene" >> "$dir/$name.first.times"
                seconds "$bin" "$device" "1:$frames" "$scene" >> "$dir/$name.rest.times"
                mv "$dir"/sum* "$dir/$name.pixels"
            done
        done
        samples=$(awk -v n="$size" -v k="$frames" 'BEGIN { print n * n * k }')
        rest=$(median "$dir/new.rest.times") first=$(median "$dir/new.first.times")
        awk -v f="$first" -v r="$rest" -v n="$samples" -v s="$scene $device" \
            'BEGIN { printf "%s\t%.3f\t%.3f", s, f, 1e6 * r / n }'
        if [ -n "$old" ]; then
            bits=same
            cmp -s "$dir/old.pixels" "$dir/new.pixels" || bits=other
            awk -v f="$first" -v r="$rest" -v g="$(median "$dir/old.first.times")" \
                -v q="$(median "$dir/old.rest.times")" -v b="$bits" \
                'BEGIN { printf "\t%.2f\t%.2f\t%s", g / f, q / r, b }'
        fi
        echo
    done
done
