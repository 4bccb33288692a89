#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# From an edit to the first new line of numbers: bench/live.sh build/bin
# The office at 14:00, -ab 5, in the pipe ptrace -watch -control | ptaccum -every x2/16 | vcmetrics.  Tab separated:
# what, pixels a side, median and 95th percentile of RUNS edits in seconds, median of ptrace's processor seconds until
# then; the same medians of a ptrace that starts and writes frames 0 and 1, in turn with the edits; the ratio of both.
# TRIANGLES: of a heap on the floor, in the last row.  The page itself is measured by bench/live_page.py.
set -euo pipefail
bin=$(cd "$1" && pwd)
cmake --build "$bin/.." --target large_mesh > /dev/null
office=$(cd "$(dirname "$0")/../examples/scenes/office" && pwd)
runs=${RUNS:-20} triangles=${TRIANGLES:-1000000}
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cp "$office"/*.rad "$office"/view.vf "$dir"
cd "$dir"
mkfifo ctl
TIMEFORMAT='%R %U %S'

processor_seconds() { awk '{ print ($14 + $15) / 100 }' "/proc/$(< pid)/stat"; }
line_of() {  # edit, frame: the first line of that edit, and from that frame on
    while IFS=$'\t' read -r -u 3 frame _ edit _; do
        [ "$edit" = edit ] || [ "$edit" -lt "$1" ] || [ "$frame" -lt "$2" ] || return 0
    done
    cat log >&2; exit 1
}
middle() { sort -n "$1" | awk -v share="$2" '{ v[NR] = $1 } END { print v[int(share * NR + .999)] }'; }
# what, side, change (a command that makes edit $k), scene files
row() {
    local what=$1 side=$2 change=$3 k
    local words=(-w- -vf view.vf -x "$side" -y "$side" -ab 5 "${@:4}")
    exec 3< <({ "$bin/ptrace" -watch -control ctl "${words[@]}" & echo $! > pid; wait; } 2> log |
        "$bin/ptaccum" -every x2/16 | "$bin/vcmetrics" -ci 95 -metrics Ev,DGP 2>> log)
    line_of 0 2
    : > seconds; : > processor; : > bare; : > bare_processor
    for ((k = 1; k <= runs; k++)); do
        echo pause > ctl
        { time "$bin/ptrace" -frames 2 "${words[@]}" | cat > /dev/null; } 2> time
        awk '{ print $1 }' time >> bare; awk '{ print $2 + $3 }' time >> bare_processor
        echo go > ctl
        line_of $((k - 1)) 4
        before=$(processor_seconds) start=$EPOCHREALTIME
        eval "$change"
        line_of "$k" 0
        awk -v a="$start" -v b="$EPOCHREALTIME" 'BEGIN { print b - a }' >> seconds
        awk -v a="$before" -v b="$(processor_seconds)" 'BEGIN { print b - a }' >> processor
        line_of "$k" 2
    done
    kill "$(< pid)"
    exec 3<&-
    awk -v OFS='\t' -v what="$what" -v side="$side" '{ v[FNR == 1 ? ++f : f] = $1 }
        END { print what, side, v[1], v[2], v[3], v[4], v[5], v[1] / v[4] }' <(middle seconds .5) \
        <(middle seconds .95) <(middle processor .5) <(middle bare .5) <(middle bare_processor .5)
}
save() { cat > new; mv new "$1"; }
material='sed "s/^5 .68 .67 .*/5 .68 .67 .$((500 + k)) 0 0/" "$office/materials.rad" | save materials.rad'
sky='sed "s/-0.802754 0.289724/-0.802754 0.$((290000 + 100 * k))/" "$office/sky_1400.rad" | save sky_1400.rad'
view='echo "view -vp 2 2.$((100 + k)) 1.2" > ctl'

printf 'what\tside\tmedian\t95th\tprocessor\tbare\tbare processor\tratio\n'
for side in ${SIDES:-256 512}; do
    row material "$side" "$material" materials.rad layout.rad sky_1400.rad
    row sky "$side" "$sky" materials.rad layout.rad sky_1400.rad
    row view "$side" "$view" materials.rad layout.rad sky_1400.rad
done
if [ "$triangles" -gt 0 ]; then
    "$bin/large_mesh" "$triangles" heap.rtm heap.oct
    row "material, $triangles triangles" 256 "$material" materials.rad layout.rad heap.oct sky_1400.rad
fi
