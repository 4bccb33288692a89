# SPDX-License-Identifier: BSD-3-Clause
# The design is vcview's: windows that come late, change at the same time or change what is no more (vcview_design.py).
. "${TOP:?}/tests/lib.sh"
needs vcview ptaccum mkstream python3

mkstream frames 0 4 | ptaccum -every 1 -o - > sums.str
echo 'first' > a.rad
echo 'second' > b.rad
mkfifo ctl
cat ctl > got & reader=$!
sleep 1000 > ctl & holder=$!
: > link
(cat sums.str; sleep 60) | vcview -control ctl -edit a.rad -edit b.rad > all 2> link &
running=$!
check 'two windows and 200 changes' 'python3 "$TOP/tests/tools/vcview_design.py" link got a.rad b.rad >&2'
kill $reader $holder $running $(jobs -p) 2> /dev/null
