#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# sky.sh sunny|overcast HOUR: sky and ground over the office on 21 March, for standard output.
set -euo pipefail
site='-a 42.36 -o 71.06 -m 75'
if [ "$1" = sunny ]; then
    echo "!gendaylit 3 21 $2 $site -W 750 110"
else
    echo "!gensky 3 21 $2 -c $site"
fi
cat << 'SCENE'
skyfunc glow sky_glow 0 0 4 1 1 1 0
sky_glow source sky 0 0 4 0 0 1 180
skyfunc glow ground_glow 0 0 4 1 .9 .75 0
ground_glow source ground_dome 0 0 4 0 0 -1 180
SCENE
