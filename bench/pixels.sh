#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# DGP over the size of the picture, of whole pixels and of what fills them (docs/decisions/0033-pixels.md):
# pixels.sh OUT [FRAMES [SIZE ...]], with the programs on PATH.  OUT/pixels.tsv and, with gnuplot, OUT/pixels.svg.
set -euo pipefail
mkdir -p "$1" && out=$(cd "$1" && pwd)
frames=${2:-17} sizes=${*:3}
cd "$(dirname "$0")/../examples/scenes"

measure() {  # NAME FOLDER VIEW FILE ...
    local name=$1 folder=$2 view=$3; shift 3
    for size in ${sizes:-64 128 256 512}; do
        (cd "$folder" && ptrace -w- -vf "$view" -x "$size" -y "$size" -frames "$frames" "$@") |
            ptaccum -every x2/16 | vcmetrics -metrics DGPu,DGPf -ci 95 | tail -n 1 |
            awk -v name="$name" -v size="$size" '{ print name "\t" size "\t" $3 "\t" $6 "\t" $7 "\t" $8 }'
    done
}
{
    printf 'view\tsize\tDGPu\tDGPf\tDGPf.lo\tDGPf.hi\n'
    measure office office view.vf materials.rad layout.rad sky_1400.rad
    measure classroom classroom back_row.vf \
        materials.rad room.rad furniture.rad ceiling_lights.rad outside.rad sky_afternoon.rad
    measure gallery gallery east.vf materials.rad room.rad objects.rad sky_noon.rad
} | tee "$out/pixels.tsv"

command -v gnuplot > /dev/null && cd "$out" && gnuplot << 'END'
set terminal svg size 760,340 font "sans-serif,12" background "white"
set output "pixels.svg"
set logscale x 2; set xrange [52:1250]; set yrange [0.29:0.37]; set grid
set xlabel "pixels a side"; set ylabel "daylight glare probability"; set key outside right
rows(name, column) = sprintf("< awk '$1 == \"%s\" { print $2, $%d, $5, $6 }' pixels.tsv", name, column)
plot rows("office", 4) using 1:2:3:4 with yerrorlines lw 2 lc 1 pt 7 ps .6 title "office, DGPf", \
    rows("office", 3) using 1:2 with lines lc 1 dt 2 title "office, DGP", \
    rows("classroom", 4) using 1:2:3:4 with yerrorlines lw 2 lc 2 pt 7 ps .6 title "classroom, DGPf", \
    rows("classroom", 3) using 1:2 with lines lc 2 dt 2 title "classroom, DGP", \
    rows("gallery", 4) using 1:2:3:4 with yerrorlines lw 2 lc 4 pt 7 ps .6 title "gallery, DGPf", \
    rows("gallery", 3) using 1:2 with lines lc 4 dt 2 title "gallery, DGP"
END
