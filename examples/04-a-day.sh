#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# The same desk at three hours and under clouds: one line of metrics for each sky.
set -euo pipefail
cd "$(dirname "$0")/scenes/office"
size=${SIZE:-512} frames=${FRAMES:-64}

for sky in 0900 1100 1400 overcast; do
    ptrace -vf view.vf -x $size -y $size -frames $frames materials.rad layout.rad sky_$sky.rad |
        ptaccum -last > day_$sky.hdr
done
vcmetrics day_*.hdr
