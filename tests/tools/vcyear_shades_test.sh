# SPDX-License-Identifier: BSD-3-Clause
# Shades that move, from the scene to the year: tables of states, rules, and what they come to.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics vcyear python3
{
    printf 'place Here\nlatitude 39.74\nlongitude 105.18\ntime_zone 105\n'
    printf 'site_elevation 1829\nweather_data_file_units 1\n'
    for hour in 5.5 9.5 12.5 15.5; do echo "3 21 $hour 700 90"; done
    echo '3 22 12.5 0 90'
} > y.wea
# A roof that moves above two sensors: away, or above the first one, or above both.
printf 'void plastic p 0 0 5 0 0 0 0 0\n' > paint.rad
printf 'p polygon half 0 0 12 -9 -9 1  1 -9 1  1 9 1  -9 9 1\n' > half.rad
printf 'p polygon whole 0 0 12 -90 -90 1  90 -90 1  90 90 1  -90 90 1\n' > whole.rad
printf '0 0 .9 0 0 1\n5 0 .9 0 0 1\n' > desk.pts
states=(-state open -state half=half.rad -state whole=whole.rad)
tables() {
    ptrace -w- -points desk.pts -wea y.wea -frames 5 "${states[@]}" "$@" paint.rad 2> said | ptaccum -every x2 |
        vcmetrics -W- -each
}
tables > all.tsv; tables -ab 0 > sun.tsv
shade() { vcyear -w- -direct sun.tsv "$@" all.tsv; }

check 'LM-83: shades are as open as leaves sun to so few sensors' '
    shade -shades "sun 2% 1000" > two; shade -shades "sun 50% 1000" -moves moves.tsv > fifty
    grep -qx "shades    open 40.0 %, half 0.0 %, whole 60.0 % of the hours" two
    grep -qx "shades    open 40.0 %, half 60.0 %, whole 0.0 % of the hours" fifty
    grep -qx "moves     2, 0 hours in doubt" fifty; grep -qx "why       sun 50% 1000 in 3 hours" fifty
    grep -qx "DA        50.0 % of the hours have 300 lx, mean of the sensors" fifty
    grep -qx "DA        20.0 % of the hours have 300 lx, mean of the sensors" two'
check 'hour by hour' '
    printf "0321_0530 open 0321_0930 half 0321_1230 half 0321_1530 half 0322_1230 open " > expected
    sed 1d moves.tsv | cut -f 1,3 | tr "\t\n" "  " | cmp - expected
    grep -qx "0321_0930	-	half	half	sun 50% 1000" moves.tsv'
check 'which is a schedule itself' '
    shade -shades "schedule moves.tsv" > again; head -n 5 again > a; head -n 5 fifty | cmp - a'
check 'rules in a file' '
    printf "# as LM-83 has it\nsun 2%%\n" > rules; shade -shades rules | head -n 6 | cmp - <(head -n 6 two)'
check 'slats by the profile angle of the sun' '
    shade -shades "slats 180 .05 .042 tilts -,-60,10 weather y.wea" > slats
    grep -q "^shades    open 40.0 %, half 0.0 %, whole 60.0 %" slats'
check 'one state alone is a year as before' '
    vcyear -state half all.tsv > half; grep -q "^hours     5, 1 dark" half; [ "$(grep -c shades half)" = 0 ]'
check 'columns of a table' '
    shade -format tsv -shades "sun 2% 1000" | head -n 1 | grep -q "	whole	whole.lo	whole.hi	moves	moves.lo	moves.hi$"'
check 'sensors with shades that glare closes at a view' '
    ptrace -w- -vta -vp 0 0 .9 -vd 0 -1 0 -vu 0 0 1 -vv 180 -vh 180 -x 16 -y 16 -wea y.wea -frames 5 "${states[@]}" \
        paint.rad 2> said | ptaccum -every x2 | vcmetrics -W- -metrics Ev,DGPf,pixels -ci 95 -last > eye.tsv
    vcyear -w- -by eye.tsv -shades "glare .40" all.tsv > seen; grep -q "^why       glare .40 in [0-9]* hours" seen'
# The rows of a state, without the column.
alone() {
    python3 -c 'import sys
rows = [line.rstrip("\n").split("\t") for line in open(sys.argv[1])]
at = rows[0].index("state")
for row in rows:
    if row[at] in ("state", sys.argv[2]): print(*row[:at], *row[at + 1:], sep="\t")' "$@"
}
check 'likewise with a second table, and views of open shades alone' '
    alone all.tsv open > o.tsv; alone all.tsv whole > w.tsv; alone eye.tsv open > e.tsv
    vcyear -w- -closed w.tsv -by e.tsv o.tsv > two; grep -q "^why       glare 0.4 in [1-9][0-9]* hours" two
    grep -q "^shades    open [0-9.]* %.*, closed [1-9]" two'
check_error 'of sensors, views close shades' 1 '^vcyear: glare 0.4: reads a table of views: -by$' '
    vcyear -w- -closed w.tsv o.tsv'
check 'two groups, each with its own rule' '
    ptrace -w- -points desk.pts -wea y.wea -frames 5 -state s/open -state s/shut=half.rad -state w/open \
        -state w/shut=whole.rad paint.rad 2> said | ptaccum -every x2 | vcmetrics -W- -each > groups.tsv
    printf "0321_0930 w shut\n0321_1230 s shut\n" > days.txt
    vcyear -w- -shades "schedule days.txt" -moves moves.tsv groups.tsv > two
    grep -qx "shades    s: open 80.0 %, shut 20.0 % of the hours" two
    grep -qx "shades    w: open 80.0 %, shut 20.0 % of the hours" two
    grep -qx "0321_1230	s	shut	shut	schedule days.txt" moves.tsv
    grep -qx "0321_1230	w	open	open	-" moves.tsv
    vcyear -w- -state s/shut+w/open groups.tsv | grep -q "^hours     5, 1 dark"
    vcyear -w- -state s/shut+w/shut groups.tsv | grep -q "^DA        0.0 %"'
check_error 'which needs that table' 1 '^vcyear: glare: reads a table of views: -by$' 'shade -shades glare'
check_error 'tables of several states need rules' 1 '^vcyear: all.tsv: has states "open" and "half": -shades says' \
    'vcyear all.tsv'
check_error 'rules need several states' 1 '^vcyear: -shades: the tables have one state' '
    vcyear -state open -shades sun -direct sun.tsv all.tsv'
check_error 'no such state' 1 '^vcyear: -state: no state is called "ajar"; there are open, half, whole$' '
    vcyear -state ajar all.tsv'
check_error 'no such rule' 1 '^vcyear: -shades: "blink" is no rule' 'shade -shades "blink 2"'
