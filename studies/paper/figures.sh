#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# figures.sh OUT "STAGES" SCENE...: a page of the paper's figures: falsecolor at the stages (2, 5), RAMMG and Ev (3, 4),
# DGP (6), desk and screen (7, 8) against frames, with 95 % intervals where there are any.
set -euo pipefail
out=$(cd "$1" && pwd) stages=$2
shift 2

for scene; do
    for n in $stages; do
        ptaccum "$out/$scene/$n.exr" -o "$out/$scene/$n.png" -tone falsecolor -nolegend -max 5000 -decades 3
    done
done

# Columns of metrics.tsv: frame seconds, then value, lo and hi of each metric.
plot() {  # file, title, column of the value
    (cd "$out" && gnuplot) << END
set terminal pngcairo size 700,420
set output "$1.png"
set title "$2"; set xlabel "diffuse frames"; set logscale x; set grid; set key outside
set style fill transparent solid 0.2 noborder
frame(n) = n < 1 ? NaN : n
plot for [s in "${scenes[*]}"] s."/metrics.tsv" skip 1 using (frame(column(1))):(column($3)) with lines lw 2 title s, \
    for [s in "${scenes[*]}"] s."/metrics.tsv" skip 1 using (frame(column(1))):(column($3 + 1)):(column($3 + 2)) \
    with filledcurves lc rgb "grey" notitle
END
}
scenes=("$@")
figures=(
    "figure_3 RAMMG 12 Figure 3: contrast of the view (RAMMG, as evalglare would see it)"
    "figure_3u RAMMGu 15 Figure 3 without the bias of noise (RAMMGu)"
    "figure_4 Ev 3 Figure 4: light at the eye, lux (Ev)"
    "figure_6 DGP 6 Figure 6: probability of glare (DGP)"
    "figure_6u DGPu 9 Figure 6 without the bias of noise (DGPu)"
    "figure_8 TAL 18 Figure 8: luminance of the desk, cd/m2"
    "figure_8c CR 21 Figure 8: contrast of the screen, dark over bright"
)
for f in "${figures[@]}"; do
    read -r file _ column title <<< "$f"
    if command -v gnuplot > /dev/null; then plot "$file" "$title" "$column" 2> /dev/null; fi
done

echo '<!DOCTYPE html><html lang="en"><meta charset="utf-8"><title>The paper, measured again</title>'
echo '<style>body { font: 14px sans-serif; margin: 2em } td { padding: 2px; text-align: center }</style>'
echo "<h1>Figures 2 and 5: luminance after so many frames, $SIZE x $SIZE, 5 to 5000 cd/m2</h1><table><tr><td>"
for n in $stages; do echo "<td>$n"; done
for scene; do
    echo "<tr><td>$scene"
    for n in $stages; do echo "<td><img src=\"$scene/$n.png\" width=160 alt=\"$scene, frame $n\">"; done
done
echo '</table>'
for f in "${figures[@]}"; do
    read -r file _ _ title <<< "$f"
    echo "<h1>$title</h1><img src=\"$file.png\" alt=\"$title\">"
done
