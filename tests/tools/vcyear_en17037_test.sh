# SPDX-License-Identifier: BSD-3-Clause
# EN 17037 from outside: a room's daylight provision from a weather file and a table by hand, and what is refused.
. "${TOP:?}/tests/lib.sh"
needs vcyear
python3 "$TOP/tests/tools/room_year.py" room > room.tsv
check 'the level, and what lacks to the next one' '
    vcyear -en17037 site.wea room.tsv > says
    level="300 lx on 50.0 %, 100 lx on 95.0 % of the sensors in half of 4380 daylight hours"
    grep -qx "provision EN 17037 minimum: $level" says
    grep -qx "lacks     for medium: 500 lx on 0.0 % where 50 % are asked, 300 lx on 50.0 % where 95 % are asked" says'
check 'as a row' '
    vcyear -en17037 site.wea -format csv room.tsv > row
    head -n 1 row | grep -q "DAmax.hi,to_come,provision,provision.best,"
    tail -n 1 row | grep -q ",minimum,minimum,minimum,0.95,0.95,0.95,0.5,0.5,0.5,0,0,0,0,0,0$"'
check 'each sensor with its share of the daylight hours' '
    vcyear -en17037 site.wea -each room.tsv > each; head -n 1 each | grep -q "	daylight_100	.*	daylight_750.hi$"
    sed -n 2p each | grep -q "	0.5	0.5	0.5	0.5	0.5	0.5	0	0	0	0	0	0$"'
check 'below a rooflight the target is on 95 %' '
    vcyear -en17037 site.wea -rooflight room.tsv > says; grep -q "^provision EN 17037 none: 300 lx on 50.0 % of" says'
check 'with shades that a schedule shuts in the sixth bright hour nothing reaches half of the hours' '
    { sed "1s/$/	state/; 2,\$s/$/	open/" room.tsv; sed "1d; s/$/	shut/" room.tsv; } |
        awk "BEGIN { OFS = FS = \"	\" } \$7 == \"shut\" { \$4 = \$5 = \$6 = 0 } { print }" > states.tsv
    cut -f 1 room.tsv | sort -u | sed -n "/_1430/s/$/ shut/p" > shut.txt
    vcyear -w- -en17037 site.wea -shades "schedule shut.txt" states.tsv > says
    grep -q "^provision EN 17037 none: 300 lx on 0.0 %, 100 lx on 0.0 % of" says
    vcyear -w- -en17037 site.wea -state open states.tsv | grep -q "^provision EN 17037 minimum: 300 lx on 50.0 %"'
check_error 'sunlight is of one state' 1 '^vcyear: -sunlight: is of one state of shades: -state says which$' '
    vcyear -w- -sunlight site.wea 11 -shades "schedule shut.txt" states.tsv'
check_error 'office hours alone are not enough' 1 \
    '^vcyear: room: lacks [0-9]* of the 4380 hours that have the most diffuse light in site.wea, 0101_' '
    grep -vE "_(08|15|16)30" room.tsv > part.tsv; vcyear -w- -en17037 site.wea part.tsv'
check_error 'nor is a part of a year' 1 '^vcyear: part.wea: has 10 days of hours; EN 17037 counts those of a year$' '
    head -n 246 site.wea > part.wea; vcyear -w- -en17037 part.wea room.tsv'
printf 'sky\tDGP\tDGP.lo\tDGP.hi\tpixels\terrors\n0121_0930\t.3\t.3\t.3\t9999\tDGP=0/8\n' > view.tsv
check_error 'a view has no plane' 1 '^vcyear: -en17037: is of sensors .vcmetrics -each., not of views$' '
    vcyear -en17037 site.wea view.tsv'
check_error 'a rooflight of what' 1 '^vcyear: -rooflight: is of -en17037$' 'vcyear -rooflight room.tsv'
