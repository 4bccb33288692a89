#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# run.sh BIN OUT: a table of metrics with intervals for each scene and seed, and a long run of other seeds as the truth.
# What is there already is kept, so that a stopped study goes on.  SIZE, SEEDS, FRAMES and LONG change its cost.
set -euo pipefail
bin=$(cd "$1" && pwd) && mkdir -p "$2" && out=$(cd "$2" && pwd)
cd "$(dirname "$0")/../../examples/scenes"
size=${SIZE:-32} seeds=${SEEDS:-520} frames=${FRAMES:-181} long=${LONG:-8192}
PATH=$bin:$PATH

study() {  # name, folder, view, regions, files
    local name=$1 view=$3 metrics=Ev,DGP,DGPu,RAMMG,RAMMGu regions=() seed
    mkdir -p "$out/$name"
    cd "$2"
    if [ -n "$4" ]; then
        vcregion -vf "$view" -x "$size" -y "$size" -o "$out/$name/regions.exr" "$4" 2> /dev/null
        regions=(-regions "$out/$name/regions.exr" -cr screen=screen_low/screen_high)
        metrics+=,desk.TAL,screen.CR,screen.CRu
    fi
    one() {  # seed, frames, file
        [ -s "$3" ] && return
        ptrace -vf "$view" -x "$size" -y "$size" -seed "$1" -frames $(($2 + 1)) "${files[@]}" 2> /dev/null |
            ptaccum -every x2/4 | vcmetrics "${regions[@]}" -metrics $metrics -ci 95 > "$3.new"
        mv "$3.new" "$3"
    }
    local files=("${@:5}")
    one 1000000 "$long" "$out/$name/long.tsv"
    for seed in $(seq "$seeds"); do one "$seed" "$frames" "$out/$name/$seed.tsv"; done
    cd ..
}

scenes=${SCENES:-office_1400 office_blinds classroom}
case " $scenes " in *" office_1400 "*)
    study office_1400 office view.vf ../../office.regions materials.rad layout.rad sky_1400.rad ;; esac
case " $scenes " in *" office_blinds "*)
    study office_blinds office view.vf ../../office.regions materials.rad layout.rad blinds.rad sky_1100.rad ;; esac
case " $scenes " in *" classroom "*)
    study classroom classroom back_row.vf "" \
        materials.rad room.rad furniture.rad ceiling_lights.rad outside.rad sky_afternoon.rad ;; esac
