# SPDX-License-Identifier: BSD-3-Clause
# The page of luxpipe-live: windows share one design, and failures are said in it (browser_design.py).
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics vcview luxpipe-live python3 chromedriver
/usr/bin/python3 -c 'import selenium' 2> /dev/null || skip 'no selenium here'

cp "$TOP"/examples/scenes/office/*.rad "$TOP/examples/scenes/office/view.vf" .
# It never settles: what must not come with each picture is counted over some.
luxpipe-live -until 'Ev 0.00001%' -vf view.vf -x 64 -y 64 -regions my.regions -edit blind.rad -metrics Ev,DGPf,TAL \
    materials.rad layout.rad blind.rad sky_day.rad > lines 2> link &
running=$!
for ((k = 0; k < 600; k++)); do [ -s lines ] || sleep .1; done
check 'a design outlives reloads, windows, errors and the tracer' '
    export PYTHONDONTWRITEBYTECODE=1
    /usr/bin/python3 "$TOP/tests/tools/browser_design.py" link $running >&2'
kill $running
wait $running
