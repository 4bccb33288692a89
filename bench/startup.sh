#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# From exec to the first numbers: bench/startup.sh build/bin [older/bin]
# Processor seconds of one core, the system's included, until vcmetrics has written the line of frame 1, the first
# with diffuse light: the office at 14:00, -ab 5.  A stage's time is that of a run that ends after it, less that of a
# run that ends before it.  A line a size and folder, tab separated: medians of RUNS turns.  With a second folder the
# two take turns; then follow the medians of seconds now over seconds before, of frame 0 to learning and of all.  OUT
# (out/startup) gets startup.svg (docs/efficiency.md) if gnuplot is there.
set -euo pipefail
now=$(cd "$1" && pwd) before=${2:+$(cd "$2" && pwd)}
top=$(cd "$(dirname "$0")/.." && pwd)
runs=${RUNS:-7} sizes=${SIZES:-64 128 256 512} out=${OUT:-$top/out/startup}
mkdir -p "$out" && out=$(cd "$out" && pwd)
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$top/examples/scenes/office"
export LUXPIPE_THREADS=1
TIMEFORMAT='%U %S'

seconds() { { time "$@" > /dev/null 2> "$dir/log"; } 2>&1 || { cat "$dir/log" >&2; exit 1; }; }
trace() {  # folder of programs, side, options
    "$1/ptrace" -w- -device cpu -ab 5 -vf view.vf -x "$2" -y "$2" "${@:3}" materials.rad layout.rad sky_1400.rad
}
pipe() { trace "$1" "$2" -frames 2 | "$1/ptaccum" -every x2/16 | "$1/vcmetrics" -W- -metrics Ev,DGP,DGPf; }
# Seconds of: nothing, the scene without frames, frame 0 alone, with moments, frames 0 and 1, frames 0 to 2, the pipe
turn() {
    seconds "$1/ptrace" -version
    seconds trace "$1" "$2" -M scene
    seconds trace "$1" "$2" -frames 1 -moments-
    seconds trace "$1" "$2" -frames 1
    seconds trace "$1" "$2" -frames 2
    seconds trace "$1" "$2" -frames 3
    seconds pipe "$1" "$2"
}
# Stages of the turns of a size and folder; then start-up (frame 0 to learning) and all.
stages() {
    awk -v OFS='\t' '{ t[(NR - 1) % 7] = $1 + $2 }
        NR % 7 == 0 { frame = t[5] - t[4]
            print t[0], t[1] - t[0], t[2] - t[1], t[3] - t[2], t[4] - t[3] - frame, frame, t[6] - t[4],
                t[4] - t[1] - frame, t[6] }' "$dir/$1"
}
medians() {
    awk -v OFS='\t' -v format="$1" '{ for (i = 1; i <= NF; i++) v[i, NR] = $i }
        END { for (i = 1; i <= NF; i++) {
                  for (j = 1; j <= NR; j++)
                      for (k = j + 1; k <= NR; k++)
                          if (v[i, k] < v[i, j]) { x = v[i, j]; v[i, j] = v[i, k]; v[i, k] = x }
                  printf "\t" format, v[i, int((NR + 1) / 2)]
              }
              print "" }'
}

printf '# %s runs; %s cores, load %s\n' "$runs" "$(nproc)" "$(cut -d ' ' -f 1 /proc/loadavg)"
printf 'side\twhen\texec\tscene\tframe 0\tmoments\tlearning\tframe 1\tsums and numbers\tframe 0 to learning\tall\n' |
    tee "$out/startup.tsv"
for side in $sizes; do
    rm -f "$dir"/*
    for ((run = 0; run < runs; run++)); do
        for name in ${before:+before} now; do turn "${!name}" "$side" >> "$dir/$name"; done
    done
    for name in ${before:+before} now; do printf '%s\t%s%s\n' "$side" "$name" "$(stages $name | medians %.3f)"; done |
        tee -a "$out/startup.tsv"
    [ -z "$before" ] || paste <(stages before) <(stages now) |
        awk -v OFS='\t' '{ print $17 / $8, $18 / $9 }' | medians %.2f | sed "s/^/$side\tnow over before/"
done
command -v gnuplot > /dev/null || exit 0
cd "$out" && gnuplot << 'END'
set terminal svg size 900,360 font 'sans,11' noenhanced background 'white'
set output 'startup.svg'
set datafile separator '\t'
set style data histograms; set style histogram rowstacked; set style fill solid; set boxwidth .8
set ylabel 'processor seconds'; set grid y; set key outside right invert
plot for [i=3:9] 'startup.tsv' using i:xtic(stringcolumn(1).' '.stringcolumn(2)) title columnheader(i)
END
