#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# The main job, as `make demo` runs it: demo.sh [BIN [OUT]]; without BIN the programs on PATH.
# The office at 14:00 is rendered, summed and measured until DGPf, Ev, the desk's luminance and the screen's contrast
# are known as exactly as asked; vcmetrics then closes the pipe and everything upstream ends.
set -euo pipefail
[ $# = 0 ] || PATH=$(cd "$1" && pwd):$PATH
out=${2:-out}
size=${SIZE:-512}
until=${UNTIL:-'DGPf 0.005, Ev 1%, desk.TAL 2%, screen.CRu 10%'}
mkdir -p "$out" && out=$(cd "$out" && pwd)
cd "$(dirname "$0")/scenes/office"
started=$(date +%s)

echo "The office at 14:00, $size x $size.  Frames run until these are known so exactly: $until"
vcregion -vf view.vf -x "$size" -y "$size" -o "$out/regions.exr" ../../office.regions
ptrace -vf view.vf -x "$size" -y "$size" materials.rad layout.rad sky_1400.rad |
    ptaccum -every "x2/4" -o "$out/office.exr" -o "$out/office.png" -o - |
    vcmetrics -regions "$out/regions.exr" -cr screen=screen_low/screen_high \
        -metrics Ev,DGPf,desk.TAL,CRu,RAMMGu,DGP.px -ci 95 -until "$until" |
    tee "$out/metrics.tsv"
settled=$(date +%s)

# The same picture for other programs (.hdr) and in colours of luminance.
ptaccum "$out/office.exr" -o "$out/office.hdr"
ptaccum "$out/office.exr" -o "$out/falsecolor.png" -tone falsecolor

# Metrics against frames, each with its interval.
# (The script is fixed text and the folder stands nowhere in it: gnuplot would run what is between ` and ` in a name.)
command -v gnuplot > /dev/null && (cd "$out" && gnuplot << 'END'
set terminal pngcairo size 900,1100
set output "metrics.png"
stats "metrics.tsv" skip 1 using 1 nooutput
end = STATS_max
array middle[5]; array reach[5]
do for [k=1:5] {
    stats "metrics.tsv" skip 1 using (column(1) < 8 ? NaN : column(3 * k)) nooutput
    middle[k] = STATS_median; reach[k] = 1.5 * (STATS_max - STATS_min) + 0.02 * abs(STATS_median)
}
stats "metrics.tsv" skip 1 using (abs(column(18))) nooutput  # STATS_max: DGP.px
set xrange [1:end * 1.1]; set logscale x; set grid; set key top right
set style fill transparent solid 0.25 noborder
set arrow from end, graph 0 to end, graph 1 nohead dashtype 2
set label "stop" at end, graph 0.08 right offset -0.5, 0
array words[5]
words[1] = "Light at the eye, lux (Ev)"; words[2] = "Probability of glare (DGPf)"
words[3] = "The desk, cd/m2"; words[4] = "Contrast of the screen, dark over bright"
words[5] = "Contrast of the view (RAMMG): not waited for"
frame(n) = n < 2 ? NaN : n
pixels(k) = k == 2 ? column(18) : 0
set multiplot layout 5, 1 title "The office at 14:00: what is known after so many frames"
do for [k=1:5] {
    first = 3 * k
    set title words[k]
    if (k == 5) { set xlabel "diffuse frames" }
    unset label 2
    if (k == 2) {
        reach[k] = reach[k] + STATS_max
        set label 2 "hidden in pixels (DGP.px)" at end / 2, middle[k] - STATS_max / 2 right
    }
    set yrange [middle[k] - reach[k]:middle[k] + reach[k]]
    plot "metrics.tsv" skip 1 using (frame(column(1))):(column(first)):(column(first) - pixels(k)) with filledcurves \
        lc rgb "gray60" notitle, \
        "" skip 1 using (frame(column(1))):(column(first + 1)):(column(first + 2)) with filledcurves \
        lc rgb "steelblue" title "true value, with 95 % certainty", \
        "" skip 1 using (frame(column(1))):(column(first)) with lines lw 2 lc rgb "steelblue" title "value so far"
}
END
)
echo
echo "Known after $(tail -n 1 "$out/metrics.tsv" | cut -f 1) frames, $((settled - started)) seconds.  In ${2:-out}/:"
cd "$out" && for file in office.hdr office.exr office.png falsecolor.png metrics.tsv metrics.png regions.exr; do
    [ ! -e "$file" ] || echo "$file"  # the plot needs gnuplot
done
