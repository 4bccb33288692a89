# SPDX-License-Identifier: BSD-3-Clause
# The plan beside the picture in the page of luxpipe-live (browser_plan.py).
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics vcview luxpipe-live python3 chromedriver
/usr/bin/python3 -c 'import selenium' 2> /dev/null || skip 'no selenium here'

cp "$TOP"/examples/scenes/office/*.rad "$TOP/examples/scenes/office/view.vf" .
seq 40 | awk '{ print .3 + $1 % 8 * .45, .4 + int($1 / 8) * .9, .76, 0, 0, 1 }' > desk.pts
printf '1 1 .1 0 0 1\n2 1 .1 0 0 1\n' > '<b>&.pts'
luxpipe-live -vf view.vf -x 32 -y 32 -regions my.regions materials.rad layout.rad sky_day.rad \
    desk.pts '<b>&.pts' > lines 2> link &
running=$!
for ((k = 0; k < 600; k++)); do [ -s lines ] || sleep .1; done
check 'a plan is looked at while the model changes' '
    PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 "$TOP/tests/tools/browser_plan.py" link >&2'
kill $running
wait $running
