#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# regions.sh SIZE: the regions of the paper's sizes, counted in pixels: 94 x 60 = 5640 of the desk (5646 in the paper; a
# quarter of that in pictures below 200 pixels, where the desk has no more), and 8 x 4 = 32 of each half of the monitor.
set -eu
size=$1
width=94 height=60
if [ "$size" -lt 200 ]; then width=47 height=30; fi
top=$((size * 40 / 100)) left=$((size / 2 - width / 2))
low=$((size * 447 / 1000)) high=$((size * 553 / 1000)) row=$((size * 473 / 1000))
echo "desk rect $left $((top - height)) $((left + width)) $top"
echo "low rect $((low - 4)) $row $((low + 4)) $((row + 4))"
echo "high rect $((high - 4)) $row $((high + 4)) $((row + 4))"
