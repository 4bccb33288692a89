#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# A picture of the office under the sun: 32 frames, summed, for other programs and for people.
set -euo pipefail
cd "$(dirname "$0")/scenes/office"
size=${SIZE:-512} frames=${FRAMES:-32}

ptrace -vf view.vf -x $size -y $size -frames $frames materials.rad layout.rad sky_1400.rad |
    ptaccum -last > office.hdr
ptaccum office.hdr -o office.png -tone photo
