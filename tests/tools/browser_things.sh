# SPDX-License-Identifier: BSD-3-Clause
# Things by name in the page of luxpipe-live (browser_things.py): the library, a shade and a blind.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics vcview luxpipe-live python3 chromedriver
/usr/bin/python3 -c 'import selenium' 2> /dev/null || skip 'no selenium here'

cp "$TOP"/examples/scenes/office/*.rad "$TOP"/examples/scenes/office/{view.vf,days.wea} .
sed 's/ blind.rad//' layout.rad > open.rad
printf '# B\374ro\n' > latin.rad  # the page cannot read it
luxpipe-live -vf view.vf -x 64 -y 64 -regions my.regions "$(ptrace -library)/paints.rad" \
    materials.rad open.rad latin.rad sky_day.rad > lines 2> link &
running=$!
for ((k = 0; k < 600; k++)); do [ -s lines ] || sleep .1; done
check 'things have names' '
    PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 "$TOP/tests/tools/browser_things.py" link 64 >&2'
kill $running
wait $running
