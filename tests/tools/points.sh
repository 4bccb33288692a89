# SPDX-License-Identifier: BSD-3-Clause
# ptrace -points: points from files and from the standard input, their header lines, sums, shares and mistakes.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics
printf 'void glow g 0 0 4 1 1 1 0\ng source sky 0 0 4 0 0 1 180\n' > sky.rad
{
    printf 'void light l 0 0 3 9 9 9\nl sphere s 0 0 4 0 0 3 .1\n'
    printf 'void plastic p 0 0 5 .5 .5 .5 0 0\np ring r 0 0 8 0 0 0 0 0 1 0 9\n'
} > room.rad
printf '# a desk\n1 1 .7 0 0 1\n\n2 1 .7 0 0 2 # twice as long\n' > desk.pts
printf '0 0 0.1 1 0 0\r\n' > 'wall.a.pts'


check 'each file is a grid; the header says which pixels are its own' '
    ptrace -points desk.pts -points wall.a.pts -frames 2 sky.rad room.rad | ptaccum -last -ff > both
    grep -aqx "GRID=desk 0 2 irradiance [0-9a-f]\{16\}" both; grep -aqx "GRID=wall.a 2 1 irradiance [0-9a-f]\{16\}" both
    grep -aqx -e "-Y 2 +X 2" both; not grep -aq "^VIEW=" both; grep -aqx "FRAME0=0" both'
check 'the standard input is one, too' '
    ptrace -points - -frames 2 sky.rad room.rad < desk.pts | ptaccum -last -ff | grep -aq "^GRID=points 0 2 irradiance"'
check 'a folder stands for its .pts files, in the order of their names' '
    mkdir grid; cp desk.pts grid/b.pts; cp wall.a.pts grid/a.pts; echo nothing > grid/readme
    ptrace -points grid -frames 2 sky.rad room.rad | ptaccum -last -ff > folder
    grep -aqx "GRID=a 0 1 irradiance [0-9a-f]*" folder; grep -aqx "GRID=b 1 2 irradiance [0-9a-f]*" folder
    ptrace -points grid -frames 2 sky.rad room.rad | ptaccum | vcmetrics -each -points grid | grep -q "^b	2	1	0.7"'
check 'also where their names have blanks or another case, and those of its sub-folders; hidden files are left out' '
    mkdir -p grids/floor1 grids/.old; for f in "Room 1.pts" "Raum ä.pts" x.PTS floor1/desk.pts .old/y.pts .z.pts; do
        cp desk.pts "grids/$f"; done
    ptrace -points grids -frames 2 sky.rad room.rad | ptaccum | vcmetrics -each -points grids > named
    test "$(tail -n +2 named | cut -f1 | uniq | tr "\n" " ")" = "Raum_ä Room_1 floor1_desk x "'
check 'sums of points are floats in every way out, and a .hdr file of them is a warning' '
    printf "void light r 0 0 3 90 .2 .2\nr sphere s 0 0 4 1 1 3 .1\n" > red.rad
    every() { ptrace -moments- -points desk.pts -frames 4 red.rad | ptaccum "$@"; }
    every -every x2 | vcmetrics -like rtrace -last > exact; every -last | vcmetrics -like rtrace | cmp - exact
    every -last -o red.exr; ptaccum red.exr -o - | vcmetrics -like rtrace | cmp - exact
    every -o red.hdr 2> said; vcmetrics -like rtrace red.hdr | cmp - exact; grep -q "red.hdr: holds points" said
    every -last -ff -o red.hdr 2> said; [ ! -s said ]
    every -last -fc | vcmetrics -like rtrace > rough; ! cmp rough exact'
check_error 'which it has' 1 '^ptrace: empty: is a folder without .pts files' '
    mkdir empty; ptrace -points empty -frames 2 sky.rad'
check '-I- is the radiance along the ray' '
    ptrace -I- -points desk.pts -frames 2 sky.rad room.rad | ptaccum -last -ff | grep -aq "^GRID=desk 0 2 radiance"'
check 'shares of the frames merge to the bits of one run' '
    share() { ptrace -points desk.pts -frames "$1" sky.rad room.rad | ptaccum -last -o "$2"; }
    share 10 all.exr; share 0:4 a.exr; share 5:9 b.exr; ptaccum a.exr b.exr -o merged.exr
    for f in all merged; do ptaccum $f.exr -ff -o - | tail -c 24 > $f; done; cmp all merged'
check_error 'other points, or another order of them, are not summed' 1 'other.exr: has other points than a.exr' '
    tac desk.pts > other.pts; ptrace -frames 5:9 -points other.pts sky.rad room.rad | ptaccum -last -o other.exr
    ptaccum a.exr other.exr -o x.exr'
check 'each sky has a picture' '
    ptrace -points desk.pts -sky sky.rad -sky room.rad -frames 2 room.rad | ptaccum -last -ff > skies
    test "$(grep -acx "SKYNAME=sky" skies)" = 1 && test "$(grep -acx "SKYNAME=room" skies)" = 1'
check 'the bits hang neither on threads nor on the device' '
    seq 300 | awk "{print \$1 % 20 / 9, \$1 / 99, .5, 0, 0, 1}" > many.pts
    ptrace -n 1 -points many.pts -frames 3 sky.rad room.rad > one
    for how in "-n 3" "-device cpu:baseline"; do
        ptrace $how -points many.pts -frames 3 sky.rad room.rad | tail -c 3888 | cmp - <(tail -c 3888 one)
    done'

bad() { printf "$1" > bad.pts; ptrace -points bad.pts -frames 2 sky.rad; }
check_error 'five numbers are not a point' 1 '^ptrace: bad.pts:2: a point is x y z dx dy dz, six numbers, not 5' \
    'bad "0 0 0 0 0 1\n1 2 3 4 5\n"'
check_error 'nor are seven' 1 '^ptrace: bad.pts:1: a point is .* not 7' 'bad "0 0 0 0 0 1 7"'
check_error 'nor are numbers with commas' 1 '^ptrace: bad.pts:1: a point is .* with blanks between the six numbers' \
    'bad "0, 0, 0, 0, 0, 1\n"'
check_error 'also without blanks' 1 '^ptrace: bad.pts:1: a point is .* with blanks' 'bad "0,0,0,0,0,1\n"'
check_error 'words are no numbers' 1 '^ptrace: bad.pts:1: "nan" is not a number' 'bad "0 0 nan 0 0 1"'
check_error 'a direction has a length' 1 '^ptrace: bad.pts:3: the direction has no length' 'bad "\n\n0 0 0 0 0 0"'
check_error 'an empty file has no point' 1 '^ptrace: bad.pts: holds no point' 'bad "# nothing\n"'
check_error 'a missing file is a system error' 2 '^ptrace: none.pts: cannot be ' 'ptrace -points none.pts sky.rad'
check_error 'grids have different names' 1 'two grids are called "desk"' '
    ptrace -points desk.pts -points ./desk.pts sky.rad'
check_error '-views has no place beside them' 1 '^ptrace: -points: ' 'ptrace -points desk.pts -views x sky.rad'
check_error '-I needs points' 1 '^ptrace: -I: needs the points of -points' 'ptrace -I -frames 1 sky.rad'
check_error 'the standard input is read once' 1 'the standard input has the points' '
    ptrace -points - -frames 1 - < desk.pts'
check 'points that no light reaches are named: below the floor, for one' '
    printf "0 0 1 0 0 1\n0 0 -1 0 0 -1\n" > dark.pts
    ptrace -points dark.pts -frames 2 sky.rad room.rad 2>&1 > /dev/null |
        grep -x "ptrace: warning: dark.pts:2: no light arrives at this point: is it .*"'
check 'but not under direct light alone, where shadows are dark and every frame is the same' '
    ptrace -ab 0 -points dark.pts -frames 3 sky.rad room.rad 2> said | ptaccum -every 1 -o - |
        vcmetrics -ci 95 -metrics dark.mean > rows
    not grep "no light" said; tail -n 1 rows | awk "{ exit !(\$3 > 0 && \$3 == \$4 && \$3 == \$5) }"'

stream() { ptrace -points desk.pts -points wall.a.pts -frames "$1" sky.rad room.rad | ptaccum -every x2 -o -; }
check 'vcmetrics prints numbers of each grid, with intervals' '
    stream 17 | vcmetrics -ci 95 -metrics desk.mean,U0,wall.a.share300 -format csv > table
    names="frame,seconds,desk.mean,desk.mean.lo,desk.mean.hi,desk.U0,.*,wall.a.U0,.*,wall.a.share300,.*"
    head -1 table | grep -x "$names"
    tail -1 table | awk -F, "{exit !(\$4 <= \$3 && \$3 <= \$5 && \$3 > 100 && \$5 - \$4 < .1 * \$3)}"'
check '-until ends the stream' '
    ptrace -points desk.pts sky.rad room.rad | ptaccum -o - |
        vcmetrics -metrics mean -until "desk.mean 5%" > table 2> said
    grep -q "stopped after [0-9]* frames: -until holds" said; test "$(tail -1 table | cut -f 1)" -ge 16'
check '"each 5%" ends it where 95 of 100 points of each grid are within 5 %' '
    ptrace -points desk.pts -points wall.a.pts sky.rad room.rad | ptaccum -o - |
        vcmetrics -each -until "each 5%" > table 2> said
    grep -q "stopped after [0-9]* frames: -until holds" said
    awk "NR > 1 && !((\$5 - \$4) / 2 <= .05 * \$3) { exit 1 }" table
    test "$(sed "s/.*after \([0-9]*\) .*/\1/" said)" -lt 300'
check_error 'and is no number of the table' 1 'is not a number of a grid' 'stream 3 | vcmetrics -metrics desk.each'
check_exit 'or was not met' 4 'stream 3 | vcmetrics -until "desk.mean .0001%" 2> said'
check 'points that change in a live stream (EDIT=) are measured by what they are now' '
    printf "5 5 1 0 0 1\n" > one.pts; seq 7 | sed "s/.*/0 & 1 0 0 1/" > seven.pts
    edit() { ptrace -points "$2" "${@:3}" -frames 3 sky.rad room.rad | sed "s/^FRAME=/EDIT=$1\nFRAME=/"; }
    { edit "0 start" one.pts; cp seven.pts one.pts; edit "1 scene" one.pts; edit "2 scene" desk.pts -points one.pts
        edit "3 scene" one.pts; } | ptaccum -o - | vcmetrics -metrics mean > table
    ptrace -points seven.pts -frames 3 sky.rad room.rad | ptaccum -o - | vcmetrics -metrics mean > alone
    grep -n frame table | cut -f 1,4,5 | tr "\n\t" ", " > names
    [ "$(cat names)" = "1:frame one.mean,8:frame desk.mean one.mean,12:frame one.mean," ]
    for e in 1 3; do [ "$(awk "\$3 == $e { print \$4 }" table)" = "$(sed 1d alone | cut -f 3)" ]; done'
check '-each has a row a point' '
    stream 17 | vcmetrics -each -points desk.pts -points wall.a.pts > rows; test "$(wc -l < rows)" = 4
    sed -n 3p rows | grep -q "^desk	2	1	0.7	0	0	1	"'
check_error 'of the files that ptrace had' 1 'desk.pts: these are not the points of the picture' '
    stream 3 | vcmetrics -each -points wall.a.pts -points desk.pts 2>&1 >/dev/null | sed s/wall.a/desk/ >&2; exit 1'
check_error 'and no numbers of grids' 1 '^vcmetrics: -metrics: are of grids' '
    stream 3 | vcmetrics -each -metrics desk.df'
check 'a sum by itself has no intervals, and says so' '
    ptrace -points desk.pts -frames 9 sky.rad room.rad | ptaccum -last -ff > one.hdr
    for words in -each "-metrics mean -ci 90"; do
        vcmetrics $words one.hdr 2>&1 > rows | grep -q "^vcmetrics: warning: no intervals: a picture by itself"
        tail -n 1 rows | grep -qP "nan\tnan"
    done
    stream 9 | vcmetrics -each 2> said > rows; ! grep . said'
check '-like rtrace has its lines' '
    stream 3 | vcmetrics -like rtrace > lines; test "$(wc -l < lines)" = 3; awk "NF != 3 {exit 1}" lines'
check 'df is the share of a grid called outside' '
    echo "0 0 9 0 0 1" > outside.pts
    ptrace -points desk.pts -points outside.pts -frames 9 sky.rad room.rad | ptaccum -o - |
        vcmetrics -metrics desk.df,desk.mean,outside.mean -ci 95 | tail -1 |
        awk "{d = \$3 - 100 * \$6 / \$9; exit !(d < .01 && d > -.01 && \$4 <= \$3 && \$3 <= \$5)}"'
check '-over draws a map of each grid, as .png or .svg, with the contour of the rule, and one of half-widths' '
    stream 17 | vcmetrics -over plan.svg -points desk.pts -points wall.a.pts -until "desk.share200 2" > rows 2>&1 || :
    grep -q ">desk</text>" plan.svg; grep -q ">wall.a</text>" plan.svg
    grep -q ">lx; line: 200; hatched: the 95 % interval holds it</text>" plan.svg
    grep -q ">lx, half of the 95 % interval</text>" plan.svg
    grep -q "<title>desk: [0-9.]* ± [0-9.]* lx at 1, 1, 0.7</title>" plan.svg; [ "$(grep -c "<title>" plan.svg)" = 3 ]
    stream 2 | vcmetrics -over plan.png -points desk.pts -points wall.a.pts > rows; head -c 4 plan.png | grep -q PNG'
check_error 'a map needs the points' 1 '^vcmetrics: -over: needs all point files of ptrace: -points FILE' '
    stream 2 | vcmetrics -over plan.png -points desk.pts'
check_error 'pictures of a view are drawn as .png' 1 '^vcmetrics: -over: writes a .png of pictures of a view' '
    ptrace -vp 0 0 1 -x 8 -y 8 -frames 1 sky.rad | vcmetrics -over x.svg'
check_error 'a number that no grid has' 1 'is not a number of a grid' '
    stream 3 | vcmetrics -metrics desk.nonsense1,desk.mean'
for option in '-against first' '-sources' '-like evalglare'; do
    check_error "pictures of points have no $option" 1 'not on pictures of points' "stream 3 | vcmetrics $option"
done
printf 'void glow s 0 0 4 1 1 1 0\ns source sky 0 0 4 0 0 1 180\nvoid plastic g 0 0 5 .5 .5 .5 0 0\n' > floor.rad
printf 'g polygon f 0 0 12 -5 -5 0 5 -5 0 5 5 0 -5 5 0\n' >> floor.rad
check 'ptrace -i shows the irradiance of the surface itself: pi under a sky of radiance 1' '
    ptrace -w- -i -vp 0 0 1 -vd 0 0 -1 -vu 0 1 0 -vh 20 -vv 20 -x 8 -y 8 -frames 17 floor.rad | ptaccum -last > i.hdr
    vcmetrics -metrics Lavg i.hdr | awk "NR == 2 { ok = (\$NF / 179 / 3.14159 - 1) ^ 2 < .01 ^ 2 } END { exit !ok }"'
check_error 'a grid that is not there' 1 'there is no grid "roof"' 'stream 3 | vcmetrics -metrics roof.mean'
