# SPDX-License-Identifier: BSD-3-Clause
# mk/luxpipe.mk and the facade study made by it, small: whole, interrupted and resumed, and only what has changed.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics make
mkdir -p studies examples
cp -r "$TOP/studies/facade" studies && cp -r "$TOP/examples/scenes" examples && cp -r "$TOP/mk" .
cd studies/facade || exit 2
small=("BIN=$BIN" SIZE=16 FRAMES=2 'HOURS=09 12' 'ANGLES=0 35' VIEWS=desk)
study() { make "${small[@]}" "$@"; }
pictures_made() { grep -c -e '-last -o' "$1" || true; }

check 'the study makes each picture once, a table and a page' '
    study OUT=whole > log; [ "$(pictures_made log)" = 8 ]; [ "$(wc -l < whole/table.tsv)" = 9 ]
    head -n 1 whole/table.tsv | grep -qx "view.blind.sky.hour.Ev.Ev.lo.Ev.hi.DGPf.DGPf.lo.DGPf.hi.RAMMG.*"
    grep -q "^desk.35.sunny.09.[0-9.]*.[0-9.na]*.[0-9.na]*.0[.][0-9]" whole/table.tsv
    grep -q "desk_35_sunny_09.png" whole/report.html; [ "$(ls whole/*.png | wc -l)" = 8 ]'
check 'a second make does nothing' 'study OUT=whole | grep -q "Nothing to be done"'
check 'interrupted and resumed: the same table, no picture twice' '
    make "${small[@]}" OUT=part > log1 & p=$!  # not in a function: make itself is to be ended
    until ls part/*.tsv > some 2>&1; do sleep .1; done
    kill $p; wait $p || true
    not test -e part/table.tsv; before=$(ls part/desk_*.exr | grep -vc part[.]exr); [ "$before" -lt 8 ]
    study OUT=part > log2; [ $((before + $(pictures_made log2))) = 8 ]; cmp part/table.tsv whole/table.tsv'
check 'a part of the scene that has changed makes exactly its pictures again' '
    sleep 1; touch whole/blinds_35.rad; study OUT=whole > log; [ "$(pictures_made log)" = 4 ]
    not grep -q "blinds_0.rad.*-last -o" log; study OUT=whole | grep -q "Nothing to be done"
    touch ../../examples/scenes/office/furniture.rad; study OUT=whole > log; [ "$(pictures_made log)" = 8 ]'
check 'other words, too' 'study OUT=whole FRAMES=1 > log; [ "$(pictures_made log)" = 8 ]'

cat > Rules << 'RULES'
FRAMES = 3
SIZE = 16
include ../../mk/luxpipe.mk
scene := -vf desk.vf $(addprefix ../../examples/scenes/office/,materials.rad layout.rad sky_1400.rad)
$(eval $(call luxpipe_picture,o/unsettled,$(scene)))
all: $(luxpipe_metrics)
RULES
check_exit 'a picture whose rule never held is not made (status 4)' 2 '
    make -f Rules all UNTIL="Ev 0.0000001%" 2> said ||
        { s=$?; grep -q "Error 4" said; test ! -e o/unsettled.exr; exit $s; }'
check 'unless it is wanted as it is' 'make -f Rules all UNTIL="Ev 0.0000001%" UNSETTLED=yes; test -s o/unsettled.tsv'
