#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# DGP over the size of the picture, of whole pixels and of what fills them, in ten views and in generated rooms
# (docs/decisions/0033-pixels.md): pixels.sh OUT [SIZE/FRAMES ...], with the programs on PATH.  OUT/pixels.tsv and, with
# gnuplot, OUT/pixels.svg.  The sizes of the page take an hour of a core, most of it at 2048 x 2048.
set -euo pipefail
mkdir -p "$1" && out=$(cd "$1" && pwd)
sizes=${*:2}
cd "$(dirname "$0")/.."
rooms=$PWD/studies/coverage/make_room.py scenes=$PWD/examples/scenes

# A corridor at night with forty lamps of 9 cm, and a room whose dark blind lets a thousandth of the sun through.
plates() { awk '{ print $1 " polygon face_" NR " 0 0 12 " $2, $3, $4, $5, $6, $7, $8, $9, $10, $11, $12, $13 }'; }
{
    printf 'void plastic %s 0 0 5 %s %s %s 0 0\n' grey .3 .3 .28 white .7 .7 .68
    echo 'void light lamp 0 0 3 220 210 180'
    plates << 'END'
grey 0 0 0 2.2 0 0 2.2 24 0 0 24 0
white 0 0 2.6 0 24 2.6 2.2 24 2.6 2.2 0 2.6
white 0 0 0 0 24 0 0 24 2.6 0 0 2.6
white 2.2 0 0 2.2 0 2.6 2.2 24 2.6 2.2 24 0
white 0 24 0 2.2 24 0 2.2 24 2.6 0 24 2.6
white 0 0 0 0 0 2.6 2.2 0 2.6 2.2 0 0
END
    awk 'BEGIN { for (k = 0; k < 20; k++) for (x = .5; x < 2; x += 1.2)
        print "lamp sphere lamp_" k "_" x " 0 0 4 " x, 1.1 + 1.15 * k, "2.5 .045" }'
} > "$out/corridor.rad"
{
    printf 'void plastic %s 0 0 5 %s %s %s 0 0\n' wall .5 .5 .48 floor .25 .22 .2
    printf 'void glass %s 0 0 3 %s %s %s\n' clear .7 .7 .7 dark .0011 .0011 .0011
    plates << 'END'
floor 0 0 0 4 0 0 4 5 0 0 5 0
wall 0 0 3 0 5 3 4 5 3 4 0 3
wall 0 0 0 0 5 0 0 5 3 0 0 3
wall 4 0 0 4 0 3 4 5 3 4 5 0
wall 0 5 0 4 5 0 4 5 3 0 5 3
wall 0 0 0 0 0 .8 4 0 .8 4 0 0
wall 0 0 2.8 0 0 3 4 0 3 4 0 2.8
wall 0 0 .8 0 0 2.8 .3 0 2.8 .3 0 .8
wall 3.7 0 .8 3.7 0 2.8 4 0 2.8 4 0 .8
clear .3 0 .8 .3 0 1.1 3.7 0 1.1 3.7 0 .8
dark .3 0 1.1 .3 0 2.8 3.7 0 2.8 3.7 0 1.1
END
} > "$out/dark_pane.rad"
eye() { echo "rvu -vta -vp $1 -vd $2 -vu 0 0 1 -vh 180 -vv 180"; }
eye '1.1 3 1.55' '0 1 0' > "$out/corridor.vf"
eye '2 3 1.2' '0 -1 0' > "$out/dark_pane.vf"

# A quarter of DGP, which is then not cut at 1, where the sun is in view: measure NAME QUARTER FOLDER VIEW FILE ...
measure() {
    local name=$1 scale=$2 folder=$3 view=$4 cell words=(); shift 4
    [ "$scale" = 1 ] || words=(-w 2 1 1.87 2 1 1.4675e-5 .023 .03975)
    for cell in ${sizes:-64/65 128/33 256/17 512/5 1024/5 2048/5}; do
        (cd "$folder" && ptrace -w- -ab 5 -vf "$view" -x "${cell%/*}" -y "${cell%/*}" -frames "${cell#*/}" "$@") |
            ptaccum -every x2/16 | vcmetrics -W- "${words[@]}" -metrics DGPu,DGPf -ci 95 | tail -n 1 |
            awk -v name="$name" -v size="${cell%/*}" -v k="$scale" \
                '{ print name "\t" size "\t" k * $3 "\t" k * $6 "\t" k * $7 "\t" k * $8 }'
    done
}
office="materials.rad layout.rad"
{
    printf 'view\tsize\tDGPu\tDGPf\tDGPf.lo\tDGPf.hi\n'
    for sky in 1400 0900 overcast; do
        measure office_$sky 1 "$scenes/office" view.vf $office sky_$sky.rad
    done
    measure office_1100 4 "$scenes/office" view.vf $office sky_1100.rad
    for sky in 1100 overcast; do
        measure blinds_$sky 1 "$scenes/office" view.vf $office blinds.rad sky_$sky.rad
    done
    measure classroom 1 "$scenes/classroom" back_row.vf \
        materials.rad room.rad furniture.rad ceiling_lights.rad outside.rad sky_afternoon.rad
    measure gallery 1 "$scenes/gallery" east.vf materials.rad room.rad objects.rad sky_noon.rad
    measure corridor 1 "$out" corridor.vf corridor.rad
    measure dark_pane 1 "$out" dark_pane.vf dark_pane.rad "$scenes/office/sky_1100.rad"
    for draw in 1040 1041 1042 1043; do
        python3 -B "$rooms" $draw "$out/$draw"
        measure room_$draw 1 "$out/$draw" view.vf room.rad sky.rad
    done
} | tee "$out/pixels.tsv"

command -v gnuplot > /dev/null && cd "$out" && gnuplot << 'END'
set terminal svg size 760,340 font "sans-serif,12" background "white"
set output "pixels.svg"
set logscale x 2; set xrange [52:2500]; set yrange [0.22:0.37]; set grid
set xlabel "pixels a side"; set ylabel "daylight glare probability"; set key outside right
rows(name, column) = sprintf("< awk '$1 == \"%s\" { print $2, $%d, $5, $6 }' pixels.tsv", name, column)
array names[4] = ["office_1400", "classroom", "gallery", "dark_pane"]
array words[4] = ["office", "classroom", "gallery", "dark blind"]
plot for [k=1:4] rows(names[k], 4) using 1:2:3:4 with yerrorlines lw 2 lc k pt 7 ps .6 title words[k].", DGPf", \
    for [k=1:4] rows(names[k], 3) using 1:2 with lines lc k dt 2 title words[k].", DGP"
END
