# SPDX-License-Identifier: BSD-3-Clause
# luxpipe-live: the plan beside the picture has the numbers and the map of batch runs of the model that the page has.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics vcview luxpipe-live python3
cp "$TOP"/examples/scenes/office/* .
mkdir t; export TMPDIR=$PWD/t
seq 40 | awk '{ print .3 + $1 % 8 * .45, .4 + int($1 / 8) * .9, .76, 0, 0, 1 }' > desk.pts
printf '1 1 .1 0 0 1\n2 1 .1 0 0 1\n' > floor.pts
options='-x 16 -y 16 -frames 9' view='-vf view.vf' scene='materials.rad layout.rad sky_day.rad'

begin() { luxpipe-live $view $options $scene "$@" > lines 2> said & live=$!; await '[ $(wc -l < lines) -gt 4 ]'; }
await() { for i in $(seq 1200); do eval "$1" && return; sleep .05; done; echo "in vain: $1"; cat said; return 1; }
end() { kill $live; status=0; wait $live || status=$?; [ $status = 0 ]; [ -z "$(ls t)" ]; }
ask() { python3 "$TOP/tests/tools/ask.py" "$@"; }  # METHOD PATH [body]
state() { ask GET "/next?picture=99999&line=99999" | grep -ao '"plan":{[^}]*}' > state; }
of_state() { grep -ao "\"$1\":[^,}]*" state | cut -d : -f 2; }
# EDIT: the plan with all frames of that edit, which no later one is to follow
whole() {
    await "state; ask GET /plan?picture=\$(of_state number) > plan; grep -q '\"frame\": 8, .*\"edit\": $1,' plan"
    await "state; [ \"\$(of_state waits)\" = false ]"; [ "$(of_state edit)" -le "$1" ]
}
# numbers and map of that plan, without the seconds
told() { python3 -c 'import json; p = json.load(open("plan")); print({k: v for k, v in p["numbers"].items() if k not in
    ("seconds", "edit")}); print(p["map"], end="")' > told; }
batch() {  # LIMIT file ...: a run of these files
    ptrace $options $points "${@:2}" 2> /dev/null | ptaccum -every x2/16 -batches 16 -o sum.exr
    vcmetrics -ci 95 $points -metrics mean,min,median,U0,share$1 -format jsonl -over map.svg sum.exr > row
    python3 -c 'import json; print({k: v for k, v in json.load(open("row")).items() if k != "seconds"})'
    cat map.svg
}

points='-points desk.pts -points floor.pts'
check 'numbers and map are those of a batch run' '
    begin $points; whole 0; told; batch 300 $scene | cmp - told; grep -q "from\|line: 300" told
    ask POST "/plan?limit=2000"; state; [ "$(of_state limit)" = 2000 ]
    whole 0; told; batch 2000 $scene | cmp - told; grep -q "line: 2000" told
    for wrong in 0 -1 nan 1e9 3x ""; do not ask POST "/plan?limit=$wrong"; done; [ "$(of_state limit)" = 2000 ]
    sed "s/^5 .68 .67 .../5 .1 .1 .1/" materials.rad > dark.rad
    ask POST "/overlay?n=1&version=0" "$(cat dark.rad)"
    whole 1; told; batch 2000 dark.rad layout.rad sky_day.rad | cmp - told
    ask POST "/undo?state=$(ask GET /next | grep -ao "steps.:.[0-9]*" | cut -d [ -f 2)"
    whole 2; told; batch 2000 $scene | cmp - told
    ask POST /control "view -vp 2 2.5 1.2"; await "cut -f 3 lines | grep -qx 3"; state; [ "$(of_state edit)" = 2 ]
    sed "s/ 14 / 9 /" sky_day.rad > new; mv new sky_day.rad
    whole 3; told; batch 2000 $scene | cmp - told; end'
check 'a change of a file of points begins the plan anew; a mistake in it is said, and the plan waits for its mending' '
    begin $points; whole 0; cp desk.pts good; sed 1,9d good > new; mv new desk.pts
    whole 1; told; batch 300 $scene | cmp - told
    echo "1 2 3" >> desk.pts; await "grep -q desk.pts:32: said"
    await "state; [ \"\$(of_state waits)\" = true ]"; not ask GET "/plan?picture=$(of_state number)"
    ask GET "/next?picture=99999" | grep -aq "messages.:.*desk.pts:32: .*current.:[1-9]"
    sed 1,9d good > new; mv new desk.pts; whole 1; told; batch 300 $scene | cmp - told
    mv good desk.pts; whole 2; told; batch 300 $scene | cmp - told; end'
check 'points among the scene are no part of it; without points there is no plan' '
    cp desk.pts desk.PTS; begin desk.PTS
    ask GET "/next?picture=99999" > news; not grep -aq "plan.:null" news; whole 0; end
    begin; ask GET "/next?picture=99999" > news; grep -aq "plan.:null" news; not ask POST "/plan?limit=5"; end'
check 'a folder of Honeybee has its points' '
    cp -r "$TOP/examples/exports/honeybee" model; mkdir -p "model/grid/floor 1"
    cp desk.pts "model/grid/floor 1/room.PTS"; view= scene="model sky_day.rad"
    begin; whole 0; grep -q "floor_1_room.mean" plan; end; rm -r model/grid/floor*; touch model/grid/.x.pts
    begin; ask GET "/next?picture=99999" > news; grep -aq "plan.:null" news; end'
check 'a mistake in a file of points is one line, and the picture goes on' '
    printf "1 1 1 0 0 1\n1 1 1 0 0\n" > bad.pts; begin bad.pts
    await "state; [ \"\$(of_state ended)\" = true ]"; [ "$(of_state number)" = 0 ]
    await "tail -1 lines | grep -q ^8"; grep "^ptrace: " said > mistakes; cat mistakes
    [ "$(cat mistakes)" = "ptrace: bad.pts:2: a point is x y z dx dy dz, six numbers, not 5" ]
    ask GET "/next?picture=99999" | grep -aq "messages.:.*bad.pts:2: .*current.:[1-9]"; end'
