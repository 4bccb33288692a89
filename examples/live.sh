#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# The office in a browser: look around, move the sun, draw regions, watch glare.   live.sh [folder of the programs]
# Works on a copy of the scene in out/live, which the page may change.
set -eu
tools=$(cd "${1:-build/bin}" && pwd) examples=$(cd "$(dirname "$0")" && pwd)
mkdir -p out/live
cp -n "$examples"/scenes/office/*.rad "$examples/scenes/office/view.vf" "$examples/office.regions" out/live/
cd out/live
exec "$tools/luxpipe-live" -vf view.vf -regions office.regions materials.rad layout.rad blind.rad sky_day.rad
