# SPDX-License-Identifier: BSD-3-Clause
# Grids of a year from outside: from the weather to autonomy, parts of a year, and what is refused.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics vcyear
{
    printf 'place Here\nlatitude 39.74\nlongitude 105.18\ntime_zone 105\n'
    printf 'site_elevation 1829\nweather_data_file_units 1\n'
    for month in 1 3; do for hour in 5.5 9.5 12.5; do echo "$month 21 $hour 700 90"; done; done
} > y.wea
# A vast black roof with a sensor above it, one below it and one that looks down on the bright ground.
printf 'void plastic p 0 0 5 0 0 0 0 0\np ring roof 0 0 8 0 0 .7 0 0 1 0 900\n' > roof.rad
printf '0 0 .8 0 0 1\n0 0 .6 0 0 1\n0 0 .6 0 0 -1\n' > desk.pts
printf '9 0 2 0 0 1\n' > free.pts
hours() {
    ptrace -w- -hours-apart -points desk.pts -points free.pts -wea y.wea "$@" roof.rad 2> said | ptaccum -every x2 |
        vcmetrics -W- -each
}
hours -frames 9 > all.tsv
hours -ab 0 -frames 4 > sun.tsv

check 'a row for each hour and sensor, of its last picture' '
    head -n 1 all.tsv | grep -qx "sky	grid	point	E	lo	hi	errors	hour"; [ "$(wc -l < all.tsv)" = 25 ]
    sed -n 2p all.tsv | grep -q "^0121_0530	desk	0	0	"; tail -n 1 all.tsv | grep -q "^0321_1230	free	0	"'
check 'those of an hour alone' '
    hours -frames 9 -hours 0321_1230 | cut -f -7 > one.tsv
    grep "^0321_1230" all.tsv | cut -f -7 | cmp - <(tail -n +2 one.tsv)'
check 'with -points the points themselves, hour by hour' '
    ptrace -w- -hours-apart -points desk.pts -wea y.wea -frames 3 roof.rad 2> said | ptaccum -every x2 |
        vcmetrics -W- -each -points desk.pts > rows
    [ "$(grep -c "^[0-9_]*	desk	0	0	0.6	0	0	-1	" rows)" = 6 ]'
check 'autonomy, useful illuminance and direct sun: four of six hours have light, sun on the first sensor alone' '
    vcyear -direct sun.tsv -ase 1000 3 all.tsv > says
    grep -qx "hours     6, 2 dark, 3 sensors" says
    grep -qx "DA        44.4 % of the hours have 300 lx, mean of the sensors" says
    grep -qx "sDA       66.7 % of the sensors have 300 lx in 50 % of the hours" says
    grep -q "^UDI       55.6 % below 100 lx, 0.0 % supplementary, .*44.4 % exceeded$" says
    grep -qx "ASE       33.3 % of the sensors have 1000 lx of sun in more than 3 of 6 hours" says
    [ "$(vcyear -direct sun.tsv -ase 1000 4 all.tsv | grep -c "^ASE       0.0 %")" = 2 ]'
check 'credit for less light, and light in excess' '
    vcyear all.tsv | grep -qx "cDA       44.4 %, hours of less light by their share of it; DAmax 44.4 % have 3000 lx"
    vcyear -each all.tsv | head -n 1 | grep -q "	sun_hours.hi	cDA	cDA.lo	cDA.hi	DAmax	DAmax.lo	DAmax.hi$"'
check 'a row for each month, of grids, sensors and views' '
    vcyear -months all.tsv > months; [ "$(cut -f 1,2,4 months | tr "\t\n" ", ")" = \
        "month,grid,hours Jan,desk,3 Mar,desk,3 Jan,free,3 Mar,free,3 " ]
    [ "$(vcyear -months -each all.tsv | wc -l)" = 9 ]
    printf "sky\tDGP\tDGP.lo\tDGP.hi\tpixels\terrors\n0121_0930\t.3\t.3\t.3\t9999\tDGP=0/8\n" > one.tsv
    vcyear -w- -months one.tsv | tail -n 1 | grep -q "^Jan	-	1	"'
check 'points of LEED, and what LM-83 asks besides' '
    vcyear -leed all.tsv > says
    grep -qx "LEED v4.1 option 1: 3 points, sDA 75.0 % of 4 sensors in 2 spaces" says
    grep -qx "lacks     desk has 6 hours, not the 3650 from 8 to 18" says
    grep -qx "lacks     free has no direct sun (-direct)" says'
check 'the mean daylight factor, of a sky without an hour' '
    printf "void glow g 0 0 4 1 1 1 0\ng source s 0 0 4 0 0 1 180\n" > even.rad
    ptrace -w- -points desk.pts -points free.pts -frames 9 even.rad roof.rad 2> said | ptaccum -every x2 |
        vcmetrics -W- -each > even.tsv
    vcyear -overcast even.tsv 562.35 all.tsv | grep -A9 "^free" | grep -qE "^DF        100.00 %.* of 562.35 lx outdoors"
    vcyear -overcast even.tsv 562.35 -format csv all.tsv | head -n 1 | grep -q ",DF,DF.lo,DF.hi$"'
check_error 'of all grids' 1 '^vcyear: -overcast: has no grid "free"$' '
    grep -v free even.tsv > part.tsv; vcyear -overcast part.tsv 500 all.tsv'
check_error 'months are counted of hours' 1 '^vcyear: -months: counts no month for -en17037, -sunlight, -overcast and' '
    vcyear -months -leed all.tsv'
check_error 'points of LEED are text' 1 '^vcyear: -leed: is lines of text, without -format and -each$' '
    vcyear -leed -each all.tsv'
check_error 'and of its own limits' 1 '^vcyear: -leed: asks 300 lx in 50 % of the hours and 1000 lx in 250' '
    vcyear -leed -sda 500 50 all.tsv'
check 'hours that share their paths say so, in all formats, and are counted in half-samples' '
    shared() {
        ptrace -w- -seed ${seed:-1} -points desk.pts -points free.pts -wea y.wea -frames 9 roof.rad 2> said |
            ptaccum -every x2 |
            vcmetrics -W- -each "$@"
    }
    shared > shared.tsv; head -n 1 shared.tsv | grep -qx "sky	grid	point	E	lo	hi	errors	paths	hour"
    tail -n 1 shared.tsv | grep -qE "	E=[0-9.e+-]+/[0-9.]+/[A-Za-z0-9_-]{16}/[0-9.]+	[0-9a-f]{8}	[-0-9/]+$"
    vcyear shared.tsv > says; vcyear all.tsv | cmp - says; shared -format jsonl > s.jsonl; vcyear s.jsonl | cmp - says'
check_error 'never as if they were independent' 1 '^vcyear: 0121_0930: has no half-samples, but hours' '
    sed -E "s,/[A-Za-z0-9_-]{16}/[0-9.]+	,	,g" shared.tsv > bare.tsv; vcyear bare.tsv'
check 'parts joined by cat, an hour rendered again' '
    hours -frames 9 -hours 1/2 > a.tsv; hours -frames 9 -hours 2/2 > b.tsv
    vcyear all.tsv > says; cat a.tsv b.tsv | vcyear - | cmp - says; vcyear b.tsv all.tsv | grep -q "^hours     6,"'
check 'numbers as tables: a row a grid, a row a sensor' '
    vcyear -format csv all.tsv | head -n 1 | grep -q "^grid,sensors,hours,dark,DA,DA.lo,DA.hi,sDA,"
    vcyear -each all.tsv > each; [ "$(wc -l < each)" = 5 ]; sed -n 2p each | grep -q "^desk	0	0.66666667	0.66666667	"
    vcyear -sda 1 90 -udi 10 20 30 -format jsonl all.tsv | python3 -c "
import json, sys
row = json.loads(sys.stdin.readline())
assert row[\"sDA\"] == 0 and abs(row[\"UDI_exceeded\"] - 4 / 9) < 1e-6 and row[\"ASE\"] is None"'
check 'maps of each grid: autonomy, useful illuminance, hours of sun' '
    vcyear -direct sun.tsv -plot plan.svg -points desk.pts -points free.pts all.tsv > says
    for text in desk free "DA of 300 lx, % of hours; line: 50; hatched: undecided" "Sun of 1000 lx, hours"; do
        grep -q ">$text" plan.svg
    done
    vcyear -plot plan.png -points free.pts -points desk.pts all.tsv > says; head -c 4 plan.png | grep -q PNG'
check 'a folder for Honeybee: columns of lit hours, rows of sensors, as text and as arrays; all hours in the schedule' '
    vcyear -direct sun.tsv -honeybee hb all.tsv > says
    [ "$(tr "\n" " " < hb/sun-up-hours.txt)" = "489.5 492.5 1905.5 1908.5 " ]
    [ "$(grep -n 1 hb/schedule.txt | tr "\n" " ")" = "486:1 490:1 493:1 1902:1 1906:1 1909:1 " ]
    [ "$(wc -l < hb/schedule.txt)" = 8760 ]
    python3 - <<END
import ast, json, struct
def array(path):
    data = open(path, "rb").read()
    assert data[:8] == b"\x93NUMPY\x01\x00" and data[-1:] != b"\n"
    size = 10 + struct.unpack("<H", data[8:10])[0]
    head = ast.literal_eval(data[10:size].decode())
    assert size % 64 == 0 and head["descr"] == "<f4" and not head["fortran_order"], head
    rows, columns = head["shape"]
    assert len(data) == size + 4 * rows * columns
    return [struct.unpack(f"<{columns}f", data[size + 4 * columns * k:][:4 * columns]) for k in range(rows)]
info = json.load(open("hb/grids_info.json"))
assert [(g["full_id"], g["count"]) for g in info] == [("desk", 3), ("free", 1)]
total = array("hb/__static_apertures__/default/total/desk.npy")
sun = array("hb/__static_apertures__/default/direct/desk.npy")
table = [row.split("\t") for row in open("all.tsv")]
hours = ["0121_0930", "0121_1230", "0321_0930", "0321_1230"]
for k, row in enumerate(total):
    for hour, lux in zip(hours, row):
        is_ = next(float(r[3]) for r in table if r[:3] == [hour, "desk", str(k)])
        assert abs(lux - is_) <= 1e-6 * is_, (hour, k, lux, is_)
assert all(0 < s < t for s, t in zip(sun[0], total[0])) and not any(sun[1] + sun[2])
text = [[float(x) for x in line.split("\t")] for line in open("hb/desk.ill")]
assert all(abs(a - b) <= 1e-5 * b for x, y in zip(text, total) for a, b in zip(x, y))
END'
check_error 'maps need all points' 1 '^vcyear: -plot: needs the points of "free": -points FILE$' '
    vcyear -plot plan.svg -points desk.pts all.tsv'
check_error 'and no others' 1 '^vcyear: free.pts: has 2 points, the table 1 sensors$' '
    mkdir other; cat free.pts free.pts > other/free.pts; cd other
    vcyear -plot plan.svg -points free.pts ../all.tsv'
check_error 'sensors of another table' 1 '^vcyear: -direct: has no grid "desk"$' '
    grep -v desk sun.tsv > other.tsv; vcyear -direct other.tsv all.tsv'
check_error 'other sensors' 1 '^vcyear: -direct: has other sensors in desk than the table$' '
    grep -v "desk	2" sun.tsv > other.tsv; vcyear -direct other.tsv all.tsv'
check_error 'limits that fall' 1 '^vcyear: -udi: its illuminances rise$' 'vcyear -udi 100 3000 300 all.tsv'
check_error 'a sensor has no worst view' 1 '^vcyear: -worst: is of views, not of sensors$' 'vcyear -worst 3 all.tsv'
check_error 'a sensor of a grid that is no file name' 1 '^vcyear: -honeybee: ".desk" cannot be the name of a file$' '
    sed "s,desk,.desk," all.tsv > other.tsv; vcyear -honeybee folder other.tsv || test -e folder'
check_error 'direct sun of other hours' 1 '^vcyear: -direct: does not have the hours of the table$' '
    grep -v ^0121_0930 sun.tsv > other.tsv; vcyear -direct other.tsv -honeybee folder all.tsv'
printf 'sky\tDGP\tDGP.lo\tDGP.hi\tpixels\terrors\n0121_0930\t.3\t.3\t.3\t9999\tDGP=0/8\n' > view.tsv
check_error 'a view has no sensors' 1 '^vcyear: -each: is of sensors .vcmetrics -each., not of views$' '
    vcyear -each view.tsv'
check_error 'both in one' 1 '^vcyear: view.tsv: views and sensors are counted apart$' 'vcyear view.tsv all.tsv'
