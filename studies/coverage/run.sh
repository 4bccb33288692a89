#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# run.sh BIN OUT: a table of metrics with intervals for each scene and seed, and a long run of other seeds as the truth.
# Frames are kept (3.2 MB a seed and scene), so that a stopped study goes on and another rule can be tried on them.
# SIZE, FIRST, SEEDS, FRAMES and LONG change its cost: two seconds of one core a seed.
set -euo pipefail
bin=$(cd "$1" && pwd) && mkdir -p "$2" && out=$(cd "$2" && pwd)
cd "$(dirname "$0")" && here=$PWD && cd ../../examples/scenes
size=${SIZE:-32} first=${FIRST:-1001} seeds=${SEEDS:-520} frames=${FRAMES:-257} long=${LONG:-65537}
PATH=$bin:$PATH

whole() { "$@" > "$made.new" && mv "$made.new" "$made"; }

# A stream of frames, of sums where it is long, and its table.  In the scene's folder, with its files.
one() {  # name, seed, frames
    local reader=ptaccum
    made=$out/$1/$2.lux
    if [ "$3" -gt 1000 ]; then
        reader=cat
        [ -s "$made" ] || whole sums "$2" "$3"
    else
        [ -s "$made" ] || whole ptrace -w- -x "$size" -y "$size" -ab 3 -seed "$2" -frames "$3" "${files[@]}"
    fi
    local stream=$made
    made=$out/$1/$2.tsv
    [ -s "$made" ] || whole table "$reader" "$stream" "$1"
}
sums() {
    ptrace -x "$size" -y "$size" -ab 3 -seed "$1" -frames "$2" "${files[@]}" | ptaccum -every x2/16 2> /dev/null
}
table() {  # reader, stream, name
    "$1" "$2" 2> /dev/null | vcmetrics -regions "$out/$3/regions.exr" -cr screen=screen_low/screen_high \
        -metrics Ev,DGP,DGPu,RAMMG,RAMMGu,desk.TAL,CR,CRu -ci 95 -W
}

study() {  # name, seed, frames
    case $1 in
        office_1400) cd office; files=(-vf view.vf materials.rad layout.rad sky_1400.rad) ;;
        office_blinds) cd office; files=(-vf view.vf materials.rad layout.rad blinds.rad sky_1100.rad) ;;
        classroom) cd classroom
            files=(-vf back_row.vf materials.rad room.rad furniture.rad ceiling_lights.rad outside.rad
                sky_afternoon.rad) ;;
    esac
    local regions=../../office.regions
    if [ "$1" = classroom ]; then regions=$here/classroom.regions; fi
    mkdir -p "$out/$1"
    [ -s "$out/$1/regions.exr" ] ||
        vcregion "${files[@]:0:2}" -x "$size" -y "$size" -o "$out/$1/regions.exr" "$regions" 2> /dev/null
    one "$@"
    cd ..
}

scenes=${SCENES:-office_1400 office_blinds classroom}
for name in $scenes; do study "$name" 900001 "$long"; done
for seed in $(seq "$first" $((first + seeds - 1))); do
    for name in $scenes; do study "$name" "$seed" "$frames"; done
done
