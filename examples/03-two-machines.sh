#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# Frames can be shared out: each depends on its number and the seed alone, so the parts merge to the whole.
set -euo pipefail
cd "$(dirname "$0")/scenes/office"
size=${SIZE:-512}
render() { ptrace -vf view.vf -x $size -y $size -frames $1 materials.rad layout.rad sky_overcast.rad; }

render 0:3 | ptaccum -last -o part1.exr   # here
render 4:7 | ptaccum -last -o part2.exr   # there
ptaccum part1.exr part2.exr -o whole.exr
vcmetrics whole.exr
