#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# What a frame and a line of numbers cost, against everything that grows: bench/scale.sh build/bin
# Tab separated lines: what, how many, seconds of a core to begin, microseconds of a core a pixel and frame (ptrace,
# one thread, the office at 14:00, 128 x 128), bytes of ptrace's memory for each, or milliseconds of a core a picture
# (vcmetrics, 512 x 512).
# docs/scale.md has its lines.  RUNS=1 TRIANGLES='1000 100000' is a short one; TRIANGLES=10000000 takes a minute.
set -euo pipefail
bin=$(cd "$1" && pwd)
cmake --build "$bin/.." --target bright_discs large_mesh > /dev/null
office=$(cd "$(dirname "$0")/../examples/scenes/office" && pwd)
runs=${RUNS:-3} frames=${FRAMES:-8} triangles=${TRIANGLES:-1000 10000 100000 1000000}
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$office"
export LUXPIPE_THREADS=1
TIMEFORMAT=%U

seconds() { { time "$@" > /dev/null 2> "$dir/log"; } 2>&1 || { cat "$dir/log" >&2; exit 1; }; }
median() { sort -n | awk '{ v[NR] = $1 } END { print v[int((NR + 1) / 2)] }'; }
# ptrace WHAT HOW_MANY SIZE words...: frame 1 alone, then frame 1 and FRAMES more; the difference is what frames cost.
frame_cost() {
    local what=$1 many=$2 size=$3 run
    shift 3
    set -- -ab 5 -vf view.vf -x "$size" -y "$size" "$@"
    for ((run = 0; run < runs; run++)); do
        first=$(seconds "$bin/ptrace" -w- -device cpu -frames 1:1 "$@")
        all=$(seconds "$bin/ptrace" -w- -device cpu -frames 1:$((frames + 1)) "$@")
        awk -v a="$first" -v b="$all" -v k="$frames" -v n=$((size * size)) \
            'BEGIN { frame = (b - a) / k; print 1e6 * frame / n, a - frame }'
    done > "$dir/costs"
    printf '%s\t%s\t%s\t%s\n' "$what" "$many" "$(cut -d ' ' -f 2 "$dir/costs" | median)" \
        "$(cut -d ' ' -f 1 "$dir/costs" | median)"
}
room='materials.rad layout.rad'

# ptrace words...: bytes at most until the first frame, and when it is there
bytes() {
    [ -p "$dir/frames" ] || mkfifo "$dir/frames"
    "$bin/ptrace" -w- -device cpu -vf view.vf -x 64 -y 64 -frames 1:1000000 "$@" > "$dir/frames" &
    exec 3< "$dir/frames"
    head -c 1 <&3 > /dev/null
    awk '/^Vm(HWM|RSS)/ { printf "%d ", 1024 * $2 }' /proc/$!/status
    exec 3<&-
    wait $!
}
# what, how many, the file that holds them: bytes of each above those of the room alone
memory() {
    echo "$(bytes $room sky_1400.rad)" "$(bytes $room sky_1400.rad "$3")" | awk -v what="$1" -v n="$2" \
        '{ printf "%s\t%s\t%.0f\t%.0f\n", what, n, ($3 - $1) / n, ($4 - $2) / n }'
}

# Lamps of 10 cm under the ceiling, in rows.
lamps() {
    awk -v n="$1" 'BEGIN {
        print "void light lamp_light 0 0 3 50 50 50"; k = int(sqrt(n) + .999)
        for (i = 0; i < n; i++) {
            x = .2 + 3.5 * int(i / k) / k; y = .2 + 5 * (i % k) / k
            printf "lamp_light polygon lamp%d 0 0 12 %g %g 2.75 %g %g 2.75 %g %g 2.75 %g %g 2.75\n", i, x, y,
                x, y + .02, x + .02, y + .02, x + .02, y
        } }'
}

echo "# what, how many, s to begin, us a pixel and frame; $(nproc) cores, load $(cut -d ' ' -f 1 /proc/loadavg)"
for size in ${SIZES:-64 128 256 512}; do frame_cost pixels "$size x $size" "$size" $room sky_1400.rad; done
for n in $triangles; do
    "$bin/large_mesh" "$n" "$dir/heap.rtm" "$dir/heap.oct"  # a heap on the floor behind the desk, for sun and eye
    frame_cost triangles "$n" 128 $room sky_1400.rad "$dir/heap.oct"
    "$bin/large_mesh" "$n" "$dir/heap.oct"  # the same, each a polygon of its own
    frame_cost polygons "$n" 128 $room sky_1400.rad "$dir/heap.oct"
done
echo "# what, how many, bytes of each at most while loading, and after it"
for n in $triangles; do
    "$bin/large_mesh" "$n" "$dir/heap.rtm" "$dir/heap.oct"
    memory triangles "$n" "$dir/heap.oct"
    "$bin/large_mesh" "$n" "$dir/heap.oct"
    memory polygons "$n" "$dir/heap.oct"
done
rm -f "$dir"/heap.*
echo "# what, how many, s to begin, us a pixel and frame"
for ab in 1 2 5 10; do frame_cost bounces $ab 128 -ab $ab $room sky_1400.rad; done
for n in 1 10 100 1000 10000; do
    lamps "$n" > "$dir/lamps.rad"
    frame_cost lamps "$n" 128 $room "$dir/lamps.rad" sky_overcast.rad
done

picture_cost() {  # what, how many, options and picture: of 20 pictures in one run, so that its start does not count
    local what=$1 many=$2 run
    shift 2
    for ((run = 0; run < runs; run++)); do
        one=$(seconds "$bin/vcmetrics" -W- "$@" "$dir/picture.hdr")
        echo "$one $(seconds "$bin/vcmetrics" -W- "$@" $(printf "$dir/picture.hdr %.0s" {0..20}))"
    done | awk '{ print 1000 * ($2 - $1) / 20 }' | median | sed "s/^/$what\t$many\t-\t/"
}
echo "# what, how many, -, ms a picture of 512 x 512"
"$bin/bright_discs" 512 0 > "$dir/picture.hdr"
for n in 1 10 100; do
    awk -v n="$n" 'BEGIN { for (i = 0; i < n; i++) print "r" i, "rect", 130 + 2 * i, 150, 170 + 2 * i, 350 }' \
        > "$dir/r.regions"
    picture_cost regions "$n" -regions "$dir/r.regions"
done
for n in 0 10 100 300; do
    "$bin/bright_discs" 512 "$n" > "$dir/picture.hdr"
    picture_cost sources "$n" -metrics Ev,DGP,RAMMG
done
