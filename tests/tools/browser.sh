# SPDX-License-Identifier: BSD-3-Clause
# The page of vcview in a browser (browser.py), where Chromium and selenium are.
. "${TOP:?}/tests/lib.sh"
needs vcview ptaccum ptrace vcmetrics mkstream python3 chromedriver
/usr/bin/python3 -c 'import selenium, PIL' 2> /dev/null || skip 'no selenium or no Pillow here'

cd "$TOP/examples/scenes/office" || exit 2
ptrace -vf view.vf -x 64 -y 64 -frames 6 materials.rad layout.rad sky_1400.rad | ptaccum -every 1 > "$TMP/sums.str"
cd "$TMP" || exit 2
ptaccum -tone falsecolor -nolegend -filter none -o last.png sums.str
/usr/bin/python3 -c 'from PIL import Image
open("pixels", "wb").write(Image.open("last.png").convert("RGB").tobytes())'
vcmetrics -sources -outlines -format jsonl < sums.str | grep -E '"frame": ?5,' > sources
mkdir saved
: > link
vcview -stay -- vcmetrics -metrics Ev,DGP -ci 95 < sums.str > lines 2> link &
running=$!
for ((k = 0; k < 50; k++)); do [ "$(wc -l < lines)" = 7 ] || sleep .2; done
check 'the page shows what the programs wrote' '
    PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 "$TOP/tests/tools/browser.py" link sums.str lines pixels sources \
        saved >&2'
kill $running
check 'saved pictures have the floats and the bytes that they should' '
    ptaccum -last -o last.exr sums.str; [ "$(mkstream differ last.exr saved/luxpipe.exr)" = 0 ]
    ptaccum -last < sums.str | tail -c 4096 > want; tail -c 4096 saved/luxpipe.hdr | cmp - want
    vcmetrics -metrics Ev saved/luxpipe.exr > ev; grep -q luxpipe.exr ev'
check 'saved numbers are the lines, as CSV' 'tr "\t" , < lines | cmp - saved/luxpipe.csv'
check 'saved plots are a drawing of their own, the picture is large' '
    /usr/bin/python3 -c "
import xml.etree.ElementTree as xml
from PIL import Image
root = xml.parse(\"saved/luxpipe.svg\").getroot()
assert len([p for p in root.iter() if p.get(\"class\") == \"curve\"]) == 2
assert Image.open(\"saved/luxpipe.png\").size == (1024, 1024)"'
