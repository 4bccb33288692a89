# SPDX-License-Identifier: BSD-3-Clause
# Camera, sliders and edits in the page of vcview (browser_model.py), where Chromium and selenium are.
. "${TOP:?}/tests/lib.sh"
needs vcview ptaccum ptrace python3 chromedriver
/usr/bin/python3 -c 'import selenium' 2> /dev/null || skip 'no selenium here'

cd "$TOP/examples/scenes/office" || exit 2
ptrace -vf view.vf -x 64 -y 64 -frames 2 materials.rad layout.rad sky_1400.rad | ptaccum -every 1 > "$TMP/sums.str"
cd "$TMP" || exit 2
printf '# a sky\n!gensky 12 21 14 +s -a 42.36 -o 71.06 -m 75 -g .2\n' > sky.rad
# three edits after the start: no difference told, worse, better
table() {
    echo 'frame seconds edit' \
        'Ev Ev.lo Ev.hi Ev.d Ev.d.lo Ev.d.hi DGP DGP.lo DGP.hi DGP.d DGP.d.lo DGP.d.hi settled a<b>&"c.TAL'
    for frame in 0 1 2; do echo "$frame 1 0 2000 1900 2100 nan nan nan .30 .29 .31 nan nan nan 0 5"; done
    for frame in 0 1 2; do echo "$frame 2 1 2001 1900 2100 1 -5 7 .301 .29 .31 .001 -.002 .004 0 5"; done
    for frame in 0 1 2; do echo "$frame 3 2 1900 1850 1950 -101 -110 -90 .35 .34 .36 .049 .04 .06 0 5"; done
    for frame in 0 1 2; do
        echo "$frame 4 3 2200 2150 2250 300 280 320 .30 .29 .31 -.05 -.06 -.04 $((frame / 2)) 5"
    done
}
table | tr ' ' '\t' > table
mkfifo ctl
cat ctl > got & reader=$!
sleep 1000 > ctl & holder=$!
: > link
vcview -stay -control ctl -edit sky.rad -- sh -c 'cat > /dev/null; cat table' < sums.str > lines 2> link &
running=$!
for ((k = 0; k < 50; k++)); do [ "$(wc -l < lines)" = 13 ] || sleep .2; done
check 'camera, sliders, edits' '
    PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 "$TOP/tests/tools/browser_model.py" link got 64 >&2'
kill $running $holder $reader
