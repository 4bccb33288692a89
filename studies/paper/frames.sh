#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# frames.sh OUT SEEDS: a table of metrics for each office scene, way of sampling and seed, and a long run of another
# seed as the truth; what is there is kept.  FRAMES, LONG, SIZE and SCENES change its cost.
set -euo pipefail
mkdir -p "$1" && out=$(cd "$1" && pwd)
size=${SIZE:-128} frames=${FRAMES:-256} long=${LONG:-8192}
here=$PWD
cd ../../examples/scenes/office
[ -s "$out/regions.exr" ] || { bash "$here/regions.sh" "$size" > "$out/regions.txt"
    vcregion -vf view.vf -x "$size" -y "$size" -o "$out/regions.exr" "$out/regions.txt"; }

one() {  # scene, sampling, seed, frames, steps
    local made=$out/$1.$2.$3.tsv files=(materials.rad layout.rad)
    [ -s "$made" ] && return
    if [ "$1" = blinds ]; then files+=(blinds.rad sky_1100.rad); else files+=("$1.rad"); fi
    local sampling=()
    if [ "$2" = plain ]; then sampling=(-sampling plain); fi
    ptrace -w- -vf view.vf -x "$size" -y "$size" -seed "$3" -frames "$4" "${sampling[@]}" "${files[@]}" |
        ptaccum -every "$5" | vcmetrics -W- -regions "$out/regions.exr" -cr screen=low/high \
        -metrics DGP,DGPu,RAMMG,RAMMGu,CR,CRu > "$made.new"
    mv "$made.new" "$made"
}
for scene in ${SCENES:-sky_0900 sky_1400 sky_overcast blinds}; do
    one "$scene" default 900001 "$long" x2/16
    for seed in $(seq 3001 $((3000 + $2))); do
        for sampling in default plain; do one "$scene" "$sampling" "$seed" "$frames" 1; done
    done
done
