#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# references.sh BIN [view ...]: makes blocks/VIEW.tsv with RADIANCE's rtrace, whose programs and library it needs
# (PATH, RAYPATH); BIN holds the built programs (make all).  Samples are independent (-u+), every ray of a pixel
# goes elsewhere in it (-pj 1), and nothing is cached, tested for or cut off: what is left is noise, which the
# scatter of a pixel's rays tells.
set -euo pipefail
bin=$(cd "$1" && pwd) && shift
cd "$(dirname "$0")"
export RAYPATH=.:../vectors:${RAYPATH#.:} LC_ALL=C
side=64 rays=${RAYS:-32}
exact="-u+ -dj 1 -ds 0 -dt 0 -dc 1 -dr 2 -dp 0 -aa 0 -ad 4 -as 0 -lr -12 -lw 1e-6 -st 0 -ss 4"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

mkdir -p blocks
[ $# -gt 0 ] || set -- $(grep -v '^#' views.tsv | cut -f 1)
for name; do
    IFS=$'\t' read -r _ scene options view _ < <(grep "^$name	" views.tsv)
    oconv $scene > "$work/scene.oct"
    vwrays -ff $view -x $side -y $side -pj 1 -c "$rays" |
        rtrace -h -fff $exact $options "$work/scene.oct" | "$bin/blocks" gather $side $side "$rays" > "$work/blocks.tsv"
    mv "$work/blocks.tsv" "blocks/$name.tsv"
done
