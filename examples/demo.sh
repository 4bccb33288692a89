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
first = 4  # frame: the bands of earlier ones are wide
stats "metrics.tsv" skip 1 using 1 nooutput
end = STATS_max
seen(c) = column(1) < first ? NaN : column(c)
array low[5]; array high[5]
do for [k=1:5] {  # the last one has no band
    stats "metrics.tsv" skip 1 using (seen(3 * k + (k < 5 ? 1 : 0))) nooutput
    low[k] = STATS_min
    stats "metrics.tsv" skip 1 using (seen(3 * k + (k < 5 ? 2 : 0))) nooutput
    high[k] = STATS_max
}
stats "metrics.tsv" skip 1 using (abs(column(18))) nooutput  # STATS_max: DGP.px
hidden = STATS_max
array limit[3] = [.35, .40, .45]
array class[3] = ["perceptible", "disturbing", "intolerable"]
below(v) = v >= .45 ? .45 : v >= .40 ? .40 : v >= .35 ? .35 : v
above(v) = v < .35 ? .35 : v < .40 ? .40 : v < .45 ? .45 : v
# 1, 2 or 5 of a decimal place, at least v
place(v) = 10 ** floor(log10(v + 1e-9))
step(v) = v > 5 * place(v) ? 10 * place(v) : v > 2 * place(v) ? 5 * place(v) : 2 * place(v)
set xrange [first:end * 1.02]; set logscale x; set xtics (4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048); set grid
set style fill transparent solid 0.25 noborder
array words[5]
words[1] = "Light at the eye, lux (Ev)"; words[2] = "Probability of glare (DGPf)"
words[3] = "The desk, cd/m2"; words[4] = "Contrast of the screen, dark over bright"
words[5] = "Contrast of the view (RAMMG): not waited for"
pixels(k) = k == 2 ? column(18) : 0
set multiplot layout 5, 1 title sprintf("The office at 14:00: what is known after so many frames, of %d", end)
do for [k=1:5] {
    set title words[k]
    set key off
    if (k == 1) { set key top right horizontal }
    if (k == 5) { set xlabel "diffuse frames" }
    unset label; unset arrow
    if (k == 2) {
        set label "hidden in pixels (DGP.px)" at graph .98, first (low[2] + high[2] - hidden) / 2 right
        low[2] = below(low[2] - hidden); high[2] = above(high[2])
        do for [i=1:3] {
            if (limit[i] >= low[2] && limit[i] <= high[2]) {
                set arrow from graph 0, first limit[i] to graph 1, first limit[i] nohead dashtype 2
                set label sprintf("%s from %.2f", class[i], limit[i]) at graph .02, first limit[i] offset 0, -.7
            }
        }
    }
    margin = .12 * (high[k] - low[k]) + 1e-9
    set yrange [low[k] - (k == 2 ? 3 : 1) * margin:high[k] + (k == 1 ? 3 : 1) * margin]
    set ytics step((high[k] - low[k]) / 3)
    plot "metrics.tsv" skip 1 using (seen(1)):(column(3 * k)):(column(3 * k) - pixels(k)) with filledcurves \
        lc rgb "gray60" notitle, \
        "" skip 1 using (seen(1)):(column(3 * k + 1)):(column(3 * k + 2)) with filledcurves \
        lc rgb "steelblue" title "true value, with 95 % certainty", \
        "" skip 1 using (seen(1)):(column(3 * k)) with lines lw 2 lc rgb "steelblue" title "value so far"
}
END
)
echo
echo "Known after $(tail -n 1 "$out/metrics.tsv" | cut -f 1) frames, $((settled - started)) seconds.  In ${2:-out}/:"
cd "$out" && for file in office.hdr office.exr office.png falsecolor.png metrics.tsv metrics.png regions.exr; do
    [ ! -e "$file" ] || echo "$file"  # the plot needs gnuplot
done
