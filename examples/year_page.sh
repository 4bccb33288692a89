#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# The page of a year (vcyear -report) with a plan and the worst hour of each view, from tables of ptrace -wea.
# year_page.sh OUT VIEWS WEATHER 'WEST SOUTH EAST NORTH TOP' TABLE ... -- SCENE ...: OUT/year.html.  VIEWS has a line
# "VIEW= name -vta ..." for each view; the numbers are the room in the plan, and a height below its ceiling.
set -euo pipefail
out=$1 views=$2 weather=$3 size=${PICTURE:-192} tables=()
read -r west south east north top <<< "$4"
shift 4
while [ "$1" != -- ]; do tables+=("$1"); shift; done
shift
command=$(printf '%q ' ptrace -picture -o %s.hdr -x 512 -y 512 -views "$views" -wea "$weather" -hours-apart "$@")
pictures() { # HOUR OUTPUT PTRACE-WORDS
    ptrace -w- -wea "$weather" -hours "$1" -hours-apart -frames 17 "${@:3}" | ptaccum -last -o "$2"
}
mkdir -p "$out/pictures"; rm -f "$out"/pictures/*.exr
while IFS=$'\t' read -r _ view line; do
    hour=${line##* }
    awk -v name="$view" '$2 == name' "$views" > "$out/one.vf"
    pictures "$hour" "$out/pictures/%s.exr" -views "$out/one.vf" -x "$size" -y "$size" "$@" 2> /dev/null
done < <(vcyear -worst 1 "${tables[@]}")
middle=$(awk "BEGIN { print ($west + $east) / 2, ($south + $north) / 2 }")
sides=$(awk "BEGIN { print \"-vh\", $east - $west, \"-vv\", $north - $south }")
pictures "$hour" "$out/plan_%s.exr" -vtl -vd 0 0 -1 -vu 0 1 0 -vp $middle "$top" $sides -x 360 -y 360 "$@" 2> /dev/null
vcyear -report "$out/year.html" -views "$views" -wea "$weather" -plan "$out/plan_$hour.exr" -command "${command% }" \
    $(printf -- '-pictures %s ' "$out"/pictures/*.exr) "${tables[@]}"
