#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# Seconds of one core until metrics of the office at 14:00 are right: bench/metrics.sh build/bin [older/bin]
# A line a way of -sampling: median over SEEDS of ptrace's processor seconds, from its start, until each of Ev, DGP, the
# desk's TAL and the screen's CR is within 1 % of the truth and stays so up to FRAMES, then until the first three are;
# `-` where the median seed is not there yet.  Then the rms errors at the last frame in percent.  The truth is the mean
# of REFERENCE frames of another seed (or the picture TRUTH).  With RADIANCE on PATH: seconds of rpict with its cache,
# and its errors.
set -eu
bin=$(cd "$1" && pwd) older=${2:+$(cd "$2" && pwd)}
size=${SIZE:-256} frames=${FRAMES:-32} reference=${REFERENCE:-768} seeds=${SEEDS:-9} truth=${TRUTH:-}
bench=$(cd "$(dirname "$0")" && pwd)
cd "$bench/../examples/scenes/office"
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
export LUXPIPE_THREADS=1
TIMEFORMAT=%U
files=(materials.rad layout.rad sky_1400.rad)
picture=(-vf view.vf -x "$size" -y "$size")

metrics() {
    "$bin/vcmetrics" -W- -regions "$dir/regions.exr" -cr screen=screen_low/screen_high -metrics Ev,DGP,TAL,CR "$@" |
        awk -F '\t' '{ for (i = 1; i <= NF; i++) if (FNR == 1) name[i] = $i
                       else if (name[i] ~ /^(frame|Ev|DGP|desk.TAL|screen.CR)$/) printf "%s\t", $i
                       if (FNR > 1) print "" }'
}
frames() {  # folder of programs, frames, seed, sampling; the seconds go to a file
    { time "$1/ptrace" -w- -device cpu "${picture[@]}" -ab 5 -frames 0:"$2" -seed "$3" ${4:+-sampling "$4"} \
        "${files[@]}" 2> "$dir/log"; } 2> "$dir/seconds"
}
way() {  # name, folder of programs, sampling
    for ((seed = 1; seed <= seeds; seed++)); do
        frames "$2" 0 "$seed" "$3" > "$dir/stream"
        start=$(< "$dir/seconds")
        frames "$2" "$frames" "$seed" "$3" | "$bin/ptaccum" -every x2/4 | metrics > "$dir/run"
        awk -v seed="$seed" -v start="$start" -v end="$(< "$dir/seconds")" -v n="$frames" -v OFS='\t' '
            { print seed, start + (end - start) * $1 / n, $2, $3, $4, $5 }' "$dir/run"
    done > "$dir/runs"
    awk -f "$bench/metrics.awk" -v name="$1" "$dir/truth" "$dir/runs"
}

"$bin/vcregion" -w- "${picture[@]}" -o "$dir/regions.exr" ../../office.regions
if [ -z "$truth" ]; then
    frames "$bin" "$reference" 1001 reuse | "$bin/ptaccum" -last -ff > "$dir/truth.hdr"
    truth=$dir/truth.hdr
fi
metrics "$truth" > "$dir/truth"
echo "# $size x $size, $seeds seeds, $frames frames: s until 1 % (Ev, DGP, TAL, CR; first three); errors, %, at the end"
if command -v rpict oconv > /dev/null; then
    oconv "${files[@]}" > "$dir/scene.oct"
    took=$({ time rpict "${picture[@]}" -ps 1 -ab 5 -aa .15 -ad 1024 -as 256 -ar 128 "$dir/scene.oct" \
        2> "$dir/log" > "$dir/cached.hdr"; } 2>&1)
    metrics "$dir/cached.hdr" | awk -v took="$took" -v OFS='\t' '
        FNR == NR { for (i = 1; i <= 4; i++) truth[i] = $i; next }
        { printf "rpict, cached: %.1f s, errors %%", took
          for (i = 1; i <= 4; i++) printf "\t%+.2f", 100 * ($i / truth[i] - 1); print "" }' "$dir/truth" -
fi
[ -z "$older" ] || way before "$older" ""
for sampling in reuse portals plain; do way $sampling "$bin" $sampling; done
