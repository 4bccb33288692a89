#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# Scenes from elsewhere, fetched and made when they are asked for: bench/foreign.sh folder
# Prints a line for each, as bench/before_after.sh takes them:
#   mapfile -t scenes < <(bench/foreign.sh out/foreign); bench/before_after.sh build/bin old/bin "${scenes[@]}"
# Two of Honeybee and one of frads are made by these programs' own calls (bench/foreign.py), from the Python index; the
# office with a mirrored light shelf is RADIANCE's obj/virtual, as it stands on GitHub (RADIANCE_AT: another place).
# What cannot be had is left out, and said.
set -eu
mkdir -p "$1"
folder=$(cd "$1" && pwd) bench=$(cd "$(dirname "$0")" && pwd)
radiance=${RADIANCE_AT:-https://raw.githubusercontent.com/LBNL-ETA/Radiance/master}
eye='-ab 5 -vta -vh 180 -vv 180 -vu 0 0 1'

scene() { printf '%s: %s %s\n' "$folder/$1" "$eye" "$2"; }
left_out() { echo "foreign.sh: $1 is left out" >&2; }
sky() {  # folder: a clear winter day, for scenes that have no sky of their own
    printf '%s\n' '!gensky 12 21 13 +s -a 37.87 -o 122.27 -m 120' \
        'skyfunc glow sky_glow 0 0 4 1 1 1 0' 'sky_glow source sky 0 0 4 0 0 1 180' \
        'skyfunc glow ground_glow 0 0 4 1 .9 .8 0' 'ground_glow source ground 0 0 4 0 0 -1 180' > "$folder/$1/sky.rad"
}

mkdir -p "$folder/light_shelf"
found=yes
for file in environ.rad plainoff.rad hatch.cal; do
    [ -s "$folder/light_shelf/$file" ] ||
        curl -sfL -m 60 "$radiance/obj/virtual/$file" -o "$folder/light_shelf/$file" || found=no
done
if [ $found = yes ]; then scene light_shelf '-vp 3 6 1.3 -vd 0 -1 0 environ.rad plainoff.rad'
else left_out "RADIANCE's light shelf"; fi

python=$folder/venv/bin/python
[ -x "$python" ] || python3 -m venv "$folder/venv"
if "$python" -m pip install -q honeybee-radiance pyradiance numpy >&2 &&
    "$python" -m pip install -q --no-deps frads >&2 && "$python" "$bench/foreign.py" "$folder" >&2; then
    for room in tiny_house louvers south_room; do sky $room; done
    scene tiny_house '-vp 2.5 7 1.2 -vd 0 -1 0 sky.rad room.rad'
    scene louvers '-vp 2.5 6 1.2 -vd 0 -1 0 sky.rad room.rad'
    scene south_room '-vp 3.5 3.5 1.2 -vd 0 -1 0 sky.rad room.rad'
else left_out 'what Python packages make'; fi
