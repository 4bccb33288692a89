#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# Pictures for people against processor time: bench/filtered.sh build/bin
# The office at 14:00 after 10, 30 and 100 frames as it is and filtered, and, where RADIANCE is on PATH, rpict with its
# cache and ptrace for the same seconds of one core.  A line each: what, seconds (-: not asked), then the errors of
# bench/picture_error.cpp against REFERENCE frames of another seed; the first line has half the reference's own.
set -euo pipefail
bin=$(cd "$1" && pwd)
cmake --build "$bin/.." --target picture_error filtered > /dev/null
size=${SIZE:-128} reference=${REFERENCE:-4000}
cd "$(dirname "$0")/../examples/scenes/office"
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
export LUXPIPE_THREADS=1
TIMEFORMAT=%U
scene='materials.rad layout.rad sky_1400.rad'

render() { "$bin/ptrace" -w- -device cpu -vf view.vf -x "$size" -y "$size" "$@" $scene; }
errors() { printf '%s\t%s\t%s\n' "$1" "$2" "$("$bin/picture_error" "$dir/reference.exr" "$3")"; }
half=$((reference / 2))
render -seed 99 -frames 0:$half | "$bin/ptaccum" -last -o "$dir/first.exr"
render -seed 99 -frames $((half + 1)):$reference | "$bin/ptaccum" -last -o "$dir/second.exr"
"$bin/ptaccum" "$dir/first.exr" "$dir/second.exr" -o "$dir/reference.exr"
errors 'half of the reference' - "$dir/first.exr"

render -frames 101 | "$bin/filtered" "$dir/x" 10 30 100 > "$dir/filter_seconds"
for n in 10 30 100; do
    for how in plain filtered; do errors "$n frames, $how" - "$dir/x_${n}_$how.exr"; done
done
command -v rpict > /dev/null || exit 0
seconds=$({ time {
    oconv $scene > "$dir/office.oct"
    rpict -w- -vf view.vf -x "$size" -y "$size" -ps 1 -pj .9 -ab 5 -aa .15 -ad 1024 -as 256 -ar 128 "$dir/office.oct" \
        > "$dir/rpict.hdr" 2> /dev/null
}; } 2>&1)
errors 'rpict -aa .15 -ad 1024 -as 256 -ar 128' "$seconds" "$dir/rpict.hdr"
begin=$({ time render -frames 0:10 > /dev/null; } 2>&1)
more=$({ time render -frames 0:60 > /dev/null; } 2>&1)
n=$(awk -v s="$seconds" -v a="$begin" -v b="$more" 'BEGIN { print int(10 + (s - a) / ((b - a) / 50)) }')
render -frames 0:"$n" | "$bin/filtered" "$dir/y" "$n" > /dev/null
errors "ptrace, $n frames, plain" "$seconds" "$dir/y_${n}_plain.exr"
errors "ptrace, $n frames, filtered" "$seconds" "$dir/y_${n}_filtered.exr"
