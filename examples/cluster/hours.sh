#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# hours.sh K OF OUT: the K-th of OF shares (from 0) of the HOURS of WEATHER at the office's desk, written to OUT/K.tsv.
# A share that is stopped leaves nothing and can be made again, here or elsewhere: the same numbers.
set -euo pipefail
k=$1 of=$2 out=$3 weather=$(realpath "${WEATHER:?an EPW or WEA file}")
mkdir -p "$out"
out=$(cd "$out" && pwd)
[ ! -e "$out/$k.tsv" ] || exit 0
cd "$(dirname "${BASH_SOURCE[0]}")/../scenes/office"
ptrace -vf view.vf -x "${SIZE:-64}" -y "${SIZE:-64}" -wea "$weather" -hours "${HOURS:-Mo-Fr 8-18} $((k + 1))/$of" \
    -frames "${FRAMES:-17}" materials.rad layout.rad | ptaccum -every x2/8 |
    vcmetrics -metrics Ev,DGPf,DGP.px,DGPf.px,pixels -ci 95 -last | cut -f 1,3- > "$out/.$k.tsv"
mv "$out/.$k.tsv" "$out/$k.tsv"
