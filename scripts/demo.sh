#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# The main job, as `make demo` runs it: demo.sh BIN OUT
# The office at 14:00 is rendered, summed and measured until DGP, Ev, the desk's luminance and the screen's contrast
# have settled over two doublings of the number of frames; vcmetrics then closes the pipe and everything upstream ends.
set -euo pipefail
cd "$(dirname "$0")/.."
bin=$(cd "${1:-build/bin}" && pwd) out=${2:-out}
size=${SIZE:-512}
until=${UNTIL:-'DGP 1%, Ev 0.5%, desk.TAL 1%, screen.CR 3%'}
mkdir -p "$out" && out=$(cd "$out" && pwd)
PATH=$bin:$PATH
cd examples/scenes/office
started=$(date +%s)

echo "The office at 14:00, $size x $size.  Frames run until $until over two doublings of their number:"
vcregion -vf view.vf -x "$size" -y "$size" -o "$out/regions.exr" ../../office.regions
ptrace -vf view.vf -x "$size" -y "$size" materials.rad layout.rad sky_1400.rad |
    ptaccum -every "x2/4" -o "$out/office.exr" -o - |
    vcmetrics -regions "$out/regions.exr" -cr screen=screen_low/screen_high -until "$until" -window 8 |
    tee "$out/metrics.tsv"
settled=$(date +%s)

# The same picture for other programs (.hdr) and for people (.png).
ptaccum "$out/office.exr" -o "$out/office.hdr"
ptaccum "$out/office.exr" -o "$out/office.png" -tone photo
ptaccum "$out/office.exr" -o "$out/falsecolor.png" -tone falsecolor

# Metrics against frames, each relative to its last value.
# (The script is fixed text and the folder stands nowhere in it: gnuplot would run what is between ` and ` in a name.)
command -v gnuplot > /dev/null && (cd "$out" && gnuplot << 'END'
set terminal pngcairo size 900,600
set output "metrics.png"
set title "The office at 14:00: metrics against frames"
set xlabel "diffuse frames"; set ylabel "value / last value"
set logscale x; set key outside right; set grid
stats "metrics.tsv" skip 1 nooutput
n = STATS_columns
array last[n]
do for [i=3:n] { stats "metrics.tsv" skip 1 using (last[i] = column(i)) nooutput }
plot for [i=3:n] "metrics.tsv" using (column(1) < 1 ? NaN : column(1)):(column(i) / last[i]) \
    with lines lw 2 title columnheader(i) noenhanced
END
)
echo
echo "Settled after $(tail -n 1 "$out/metrics.tsv" | cut -f 1) frames, $((settled - started)) seconds.  In ${2:-out}/:"
cd "$out" && ls office.hdr office.exr office.png falsecolor.png metrics.tsv metrics.png regions.exr
