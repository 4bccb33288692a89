# SPDX-License-Identifier: BSD-3-Clause
# Two browsers on one design (browser_two.py).  200 changes: TRIES=200.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics vcview luxpipe-live python3 chromedriver
/usr/bin/python3 -c 'import selenium' 2> /dev/null || skip 'no selenium here'

cp "$TOP"/examples/scenes/office/*.rad "$TOP/examples/scenes/office/view.vf" .
view='-vf view.vf -x 32 -y 32 -seed 5'
luxpipe-live $view -regions my.regions -metrics Ev,DGPf -edit blind.rad -edit sky_day.rad \
    materials.rad layout.rad blind.rad sky_day.rad > lines 2> link &
running=$!
for ((k = 0; k < 600; k++)); do [ -s lines ] || sleep .1; done
check 'two browsers have one design' \
    'PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 "$TOP/tests/tools/browser_two.py" link lines ${TRIES:-5} 7 "$view" >&2'
kill $running
wait $running
