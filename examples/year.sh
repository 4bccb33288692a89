#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# A year at a desk until its class is decided: small pictures of all hours, which share their paths, then rounds of
# larger ones of the hours that vcyear -next names, each by itself.
# year.sh OUT WEATHER HOURS ROUNDS [PTRACE-WORDS]; the words are a view and a scene.
set -euo pipefail
out=${1:-year} weather=${2:?an EPW or WEA file} hours=${3:-Mo-Fr 8-18} rounds=${4:-20} size=${SIZE:-64}
office=$(dirname "$0")/scenes/office
[ $# -gt 4 ] || set -- "${@:1:4}" -vf "$office/view.vf" "$office/materials.rad" "$office/layout.rad"
mkdir -p "$out"

table() { # FRAMES LARGER HOURS PTRACE-WORDS: a table on the standard output
    ptrace -x $(($2 * size)) -y $(($2 * size)) -wea "$weather" -hours "$3" -frames "$1" "${@:4}" |
        ptaccum -every x2/8 | vcmetrics -metrics Ev,DGPf,DGP.px,DGPf.px,pixels -ci 95 -last
}

[ -e "$out/0.tsv" ] || { table 17 1 "$hours" "${@:5}" > "$out/0.part" && mv "$out/0.part" "$out/0.tsv"; }
for ((round = 1; round <= rounds; ++round)); do
    vcyear -next "$out"/*.tsv > "$out/next"
    groups=$(tail -n +2 "$out/next" | cut -f 2,3 | sort -u)
    [ -n "$groups" ] || break
    while read -r frames larger; do
        awk -v f="$frames" -v l="$larger" '$2 == f && $3 == l' "$out/next" > "$out/hours"
        echo "round $round: $(wc -l < "$out/hours") hours, $frames frames of $((larger * size)) x $((larger * size))"
        table "$frames" "$larger" "@$out/hours" -hours-apart "${@:5}" > "$out/part"
        mv "$out/part" "$out/$(ls "$out"/*.tsv | wc -l).tsv"
    done <<< "$groups"
done
vcyear "$out"/*.tsv
