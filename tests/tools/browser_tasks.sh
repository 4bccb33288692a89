# SPDX-License-Identifier: BSD-3-Clause
# A designer's nine tasks in the page of luxpipe-live (browser_tasks.py).
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics vcview luxpipe-live python3 chromedriver
/usr/bin/python3 -c 'import selenium' 2> /dev/null || skip 'no selenium here'

cp "$TOP"/examples/scenes/office/*.rad "$TOP/examples/scenes/office/view.vf" .
sed -i "s/12 21 14/12 21 11/" sky_day.rad  # a time with glare
luxpipe-live -vf view.vf -x 64 -y 64 -regions my.regions \
    materials.rad layout.rad blind.rad sky_day.rad > lines 2> link &
running=$!
for ((k = 0; k < 600; k++)); do [ -s lines ] || sleep .1; done
check 'nine tasks' \
    'PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 "$TOP/tests/tools/browser_tasks.py" link 64 | tee table >&2'
tail -n 13 table
kill $running
wait $running
