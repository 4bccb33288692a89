# SPDX-License-Identifier: BSD-3-Clause
# Regions drawn in the page of vcview arrive in the file, in masks and in columns (browser_regions.py), where Chromium
# and selenium are.
. "${TOP:?}/tests/lib.sh"
needs vcview ptaccum ptrace vcmetrics vcregion python3 chromedriver
/usr/bin/python3 -c 'import selenium' 2> /dev/null || skip 'no selenium here'

cd "$TOP/examples/scenes/office" || exit 2
ptrace -vf view.vf -x 128 -y 128 -frames 2 materials.rad layout.rad sky_1400.rad | ptaccum -every 1 > "$TMP/sums.str"
cd "$TMP" || exit 2
cat > my.regions << 'END'
# the first line is a comment
desk   polygon3d 1.1 1.7 .75  2.9 1.7 .75
       2.9 2.5 .75  1.1 2.5 .75     # a line and its continuation
# between
task   circle 0 -1 -.5 40
band   zone position 1 3 & !desk
round  sphere3d 2 1 1.2 .2
wood   surface desk*                # only a scene knows
END
: > link
vcview -stay -regions my.regions -- vcmetrics -metrics Ev < sums.str > lines 2> link &
running=$!
for ((k = 0; k < 50; k++)); do [ "$(wc -l < lines)" = 3 ] || sleep .2; done
check 'regions by pointer and keys' '
    PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 "$TOP/tests/tools/browser_regions.py" link my.regions 128 >&2'
kill $running
sed -i /^wood/d my.regions
check 'what was drawn is a mask and a column' '
    ptaccum -last < sums.str > one.hdr
    vcregion -vf one.hdr -x 128 -y 128 -list my.regions > list; grep -q "^region3" list
    vcmetrics -regions my.regions -metrics TAL one.hdr | head -n 1 | grep -q region3.TAL'
