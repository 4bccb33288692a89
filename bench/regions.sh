#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# 100 regions of all kinds at 1024 x 1024: under a second without a scene, under three with the office.
# bench/regions.sh build/bin prints seconds (wall, processor) for each.
set -eu
bin=$(cd "$1" && pwd)
cd "$(dirname "$0")/../examples/scenes/office"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
kinds() {   # scene queries as the fifth kind, or discs
    awk -v scene="$1" 'BEGIN { srand(1); for (i = 0; i < 100; i++) {
        a = rand(); b = rand(); c = rand(); s = .2 + .4 * rand(); name = "r" i; kind = i % 5
        if (kind == 0) print name, "circle", 2 * a - 1, -.3 - b, c - .5, 2 + 50 * s
        if (kind == 1) {
            x = .5 + 2.5 * a; z = 1.3 + .4 * b; y = .5 + c
            print name, "polygon3d", x, y, z, x + s, y, z, x + s, y, z + s, x, y, z + s
        }
        if (kind == 2) print name, "rect fraction", a / 2, b / 2, a / 2 + .2, b / 2 + .2
        if (kind == 3) print name, "disc3d", 1.5 + a, .5 + b, 1.4 + .4 * c, "0 1 .3", s
        zone = "zone position " 1 + a " " 2.5 + b
        if (kind == 4) print name, scene ? (i % 2 ? "modifier wall_paint" : "surface top.*") : zone
    } }'
}
kinds 0 > "$work/shapes"
kinds 1 > "$work/named"
TIMEFORMAT='%R %U'
echo "# vcregion, 100 regions, 1024 x 1024: seconds (wall, processor) without a scene, with the office"
time "$bin/vcregion" -w- -vf view.vf -x 1024 -y 1024 -o "$work/m.exr" "$work/shapes"
time "$bin/vcregion" -w- -vf view.vf -x 1024 -y 1024 -o "$work/m.exr" "$work/named" materials.rad layout.rad
