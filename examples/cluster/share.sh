#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# share.sh K OF OUT: the K-th of OF shares (from 0) of the office's FRAMES frames, written to OUT/K.exr.
# A share that is stopped leaves nothing and can be made again, here or elsewhere: the same bits.
set -euo pipefail
k=$1 of=$2 out=$3 frames=${FRAMES:-256} size=${SIZE:-512}
mkdir -p "$out"
out=$(cd "$out" && pwd)
cd "$(dirname "${BASH_SOURCE[0]}")/../scenes/office"
ptrace -vf view.vf -x "$size" -y "$size" -frames $((k * frames / of)):$(((k + 1) * frames / of - 1)) \
    materials.rad layout.rad sky_1400.rad | ptaccum -last -o "$out/.$k.exr"
mv "$out/.$k.exr" "$out/$k.exr"
