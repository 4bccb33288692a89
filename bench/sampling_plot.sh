#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# sampling_plot.sh scene ...: error_time.svg from the curves of bench/sampling.sh in this folder: trimmed rms error
# (lines) and rms of 8 x 8 blocks (dashes) against processor seconds, a panel a scene.
set -eu
{
    echo "set terminal svg size 900,$((300 * (($# + 1) / 2))) font 'sans,11' noenhanced background 'white'"
    echo "set output 'error_time.svg'"
    echo "set multiplot layout $((($# + 1) / 2)),2"
    echo "set logscale xy; set grid; set xlabel 'processor seconds'; set ylabel 'error / mean'; set key right top"
    for scene; do
        echo "set title '$scene'"
        color=0 plots=
        for way in reuse portals plain rpict cached; do
            color=$((color + 1))
            [ -s "$scene.$way.tsv" ] || continue
            style="linespoints pt 7 ps .3" dashes="lines dt 2"
            case $way in rpict | cached) style="points pt 9 ps 1.2" dashes="points pt 8 ps 1.2" ;; esac
            plots+="${plots:+, }'$scene.$way.tsv' using 2:(\$4 > 0 ? \$4 : 1/0) with $style lc $color title '$way'"
            plots+=", '' using 2:(\$6 > 0 ? \$6 : 1/0) with $dashes lc $color notitle"
        done
        echo "plot $plots"
    done
    echo "unset multiplot"
} | gnuplot
