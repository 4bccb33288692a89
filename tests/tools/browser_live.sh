# SPDX-License-Identifier: BSD-3-Clause
# The page of luxpipe-live with a ptrace behind it: camera, sliders, regions and the table of edits (browser_live.py).
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics vcview luxpipe-live python3 chromedriver
/usr/bin/python3 -c 'import selenium' 2> /dev/null || skip 'no selenium here'

cp "$TOP"/examples/scenes/office/*.rad "$TOP/examples/scenes/office/view.vf" .
luxpipe-live -vf view.vf -x 64 -y 64 -regions my.regions -edit sky_day.rad -edit blind.rad -metrics Ev,DGPf,TAL,CR \
    materials.rad layout.rad blind.rad sky_day.rad > lines 2> link &
running=$!
for ((k = 0; k < 600; k++)); do [ -s lines ] || sleep .1; done
check 'a scene is looked at, changed and measured' '
    PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 "$TOP/tests/tools/browser_live.py" link lines 64 >&2'
kill $running
wait $running
