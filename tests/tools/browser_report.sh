# SPDX-License-Identifier: BSD-3-Clause
# A report in a browser (browser_report.py): read from a file, narrow, and on paper.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics python3 chromedriver
/usr/bin/python3 -c 'import selenium' 2> /dev/null || skip 'no selenium here'

cp "$TOP"/examples/scenes/office/*.rad "$TOP/examples/scenes/office/view.vf" "$TOP/examples/office.regions" .
scene=(materials.rad layout.rad sky_1400.rad)
ptrace -vf view.vf -x 64 -y 64 -frames 0:4 "${scene[@]}" | ptaccum -every 1 |
    vcmetrics -regions office.regions -report report.html "${scene[@]/#/-scene=}" > lines 2> said
check 'a report is read and printed' '
    PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 "$TOP/tests/tools/browser_report.py" report.html >&2'
