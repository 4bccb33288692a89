#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# frames.sh OUT SEEDS: a table of metrics for each office scene, way of sampling and seed, and a long run of another
# seed as the truth.  Finished tables are kept, so that a stopped study goes on; it takes seed after seed, so that all
# scenes and ways have as many.  SIZE, FRAMES, LONG, SCENES, SAMPLINGS and FIRST (seed) change its cost; TRUTH is the
# long run's way.  A way "focus" samples the regions more (-focus), "focus=5" with that -focus-share.
set -euo pipefail
mkdir -p "$1" && out=$(cd "$1" && pwd)
size=${SIZE:-128} frames=${FRAMES:-256} long=${LONG:-8192} first=${FIRST:-3001}
scenes=${SCENES:-sky_0900 sky_1400 sky_overcast blinds} samplings=${SAMPLINGS:-default plain}
truth=${TRUTH:-default}
here=$PWD
cd ../../examples/scenes/office
[ -s "$out/regions.exr" ] || { bash "$here/regions.sh" "$size" > "$out/regions.txt"
    vcregion -vf view.vf -x "$size" -y "$size" -o "$out/regions.exr" "$out/regions.txt"; }

# Tables of other sizes or of another estimator are not the same study.
made_with="$size x $size, $frames and $long frames, $(ptrace -w- -vf view.vf -x 1 -y 1 -frames 0:0 materials.rad |
    grep -a -o -m 1 'estimator:[0-9]*')"
[ -s "$out/made_with" ] || echo "$made_with" > "$out/made_with"
if [ "$made_with" != "$(< "$out/made_with")" ]; then
    echo "frames.sh: $out: holds tables of $(< "$out/made_with"), not of $made_with" >&2
    exit 1
fi

one() {  # scene, sampling, seed, frames, steps
    local made=$out/$1.$2.$3.tsv files=(materials.rad layout.rad)
    if [ -s "$made" ]; then return; fi
    if [ "$1" = blinds ]; then files+=(blinds.rad sky_1100.rad); else files+=("$1.rad"); fi
    local sampling=()
    case $2 in
        default) ;;
        focus) sampling=(-focus "$out/regions.exr") ;;
        focus=*) sampling=(-focus "$out/regions.exr" -focus-share "${2#focus=}") ;;
        *) sampling=(-sampling "$2") ;;
    esac
    ptrace -w- -ab 5 -vf view.vf -x "$size" -y "$size" -seed "$3" -frames "$4" "${sampling[@]}" "${files[@]}" |
        ptaccum -every "$5" | vcmetrics -W- -regions "$out/regions.exr" -cr screen=low/high \
        -metrics DGP,DGPu,RAMMG,RAMMGu,desk.TAL,CR,CRu > "$made.new"
    mv "$made.new" "$made"
}
for scene in $scenes; do one "$scene" "$truth" 900001 "$long" x2/16; done
for seed in $(seq "$first" $((first + $2 - 1))); do
    for scene in $scenes; do
        for sampling in $samplings; do one "$scene" "$sampling" "$seed" "$frames" 1; done
    done
done
