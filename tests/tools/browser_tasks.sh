# SPDX-License-Identifier: BSD-3-Clause
# A designer's nine tasks in the page of luxpipe-live (browser_tasks.py), in a model of .rad files, a folder of Honeybee
# and an .obj file of SketchUp with the tutorial's materials.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics vcview luxpipe-live python3 chromedriver
/usr/bin/python3 -c 'import selenium' 2> /dev/null || skip 'no selenium here'

tasks() {  # MODEL ARGUMENTS
    local model=$1 running k
    shift
    luxpipe-live -x 64 -y 64 -regions my.regions "$@" > lines 2> link &
    running=$!
    for ((k = 0; k < 600; k++)); do [ -s lines ] || sleep .1; done
    check "nine tasks: $model" "
        PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 '$TOP/tests/tools/browser_tasks.py' link 64 $model | tee table >&2"
    tail -n 13 table
    kill $running
    wait $running
    rm my.regions lines
}
cp "$TOP"/examples/scenes/office/*.rad "$TOP/examples/scenes/office/view.vf" .
sed -i "s/12 21 14/12 21 11/" sky_day.rad  # a time with glare
tasks office -vf view.vf materials.rad layout.rad blind.rad sky_day.rad

cd "$TMP" && mkdir exports && cd exports || exit 2
cp -r "$TOP/examples/exports/honeybee" folder && cp "$TOP/examples/exports/sketchup/studio.obj" .
awk '/^```sh$/ { n++; on = 1; next } /^```$/ { on = 0 } on { print > ("block." n) }' "$TOP/docs/tutorial.md"
for made in materials.rad model.rad sky.rad desk.vf; do . "$PWD/$(grep -l " > $made" block.*)"; done
sed -i "s/^!gensky 3 21 14/!gensky 12 21 11/" sky.rad
tasks honeybee folder sky.rad
tasks sketchup -vf desk.vf materials.rad model.rad sky.rad
