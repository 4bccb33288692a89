#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# Glare, illuminance, the desk's luminance and the screen's contrast after every frame, until DGPf, which does not
# depend on the size of the picture, and Ev are known.
set -euo pipefail
cd "$(dirname "$0")/scenes/office"
size=${SIZE:-512}

vcregion -vf view.vf -x $size -y $size -o regions.exr ../../office.regions
ptrace -vf view.vf -x $size -y $size materials.rad layout.rad sky_1400.rad |
    ptaccum |
    vcmetrics -regions regions.exr -cr screen=screen_low/screen_high -metrics Ev,DGPf,TAL,CR \
        -until 'DGPf 1%, Ev 0.5%'
