#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# One small scene a feature against rtrace -u+ (tests/golden/suite): blocks of 8 x 8 pixels in standard errors of both.
# By hand, FRAMES (88, of which 56 are above m) and VIEWS (a pattern of names) say how much of it; the table that is
# printed shows what each view would detect.
. "${TOP:?}/tests/lib.sh"
needs ptrace blocks
suite=$TOP/tests/golden/suite
export RAYPATH=.:../vectors FRAMES=${FRAMES:-88}

render() {   # view, scene files, options of light and of view
    cd "$suite"
    ptrace -w- -device cpu -x 64 -y 64 $4 -ss 4 $3 -frames "0:$FRAMES" $2 | blocks compare "blocks/$1.tsv" > "$TMP/row"
    printf '%s\t%s\n' "$1" "$(cat "$TMP/row")" >> "$TMP/table"
}
# The bounds are those of 64 normal deviations: more than 3 beyond 3 in one view of 30000, an rms of 1.37 (chi-
# square, 5 of its standard deviations), one beyond 5.5 in 400000 of 3 * 64.  And noise must leave something to be
# seen.
agrees='{ exit !($2 <= 3 && $3 < 5.5 && $4 < 1.37 && $8 < 4 && $9 < .5 && $10 < 5) }'
export -f render
export TMP suite agrees

columns='view blocks beyond_3 largest rms R_% G_% B_% in_errors sees_% sees_in_a_block_%'
tr ' ' '\t' <<< "$columns" > "$TMP/table"
while IFS=$'\t' read -r view scene light options what; do
    [[ $view =~ ^${VIEWS:-[^#]} ]] || continue
    export view scene light options
    check "$what ($view)" 'render "$view" "$scene" "$light" "$options"; awk "$agrees" "$TMP/row"'
done < "$suite/views.tsv"
cat "$TMP/table" >&2
