# SPDX-License-Identifier: BSD-3-Clause
# Hours that share their paths (ptrace -wea): what ends them early, and years, suns and scenes at the edge.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics mkstream
office=$TOP/examples/scenes/office
room="$office/materials.rad $office/layout.rad"
head='place Here\nlatitude %s\nlongitude 0\ntime_zone 0\nsite_elevation 0\nweather_data_file_units 1\n'
dates() { # YEAR: month and day of each
    for ((day = 0; day < 365 + ($1 % 4 == 0); ++day)); do echo "$1-01-01 $day days"; done | date -u -f - '+%-m %-d'
}
{ printf "$head" 40; dates 2024 | awk '{ for (h = 0; h < 24; ++h) print $0, h + .5, (h > 8 && h < 16 ? 600 : 0),
    (h > 6 && h < 18 ? 100 : 0) }'; } > leap.wea
awk 'BEGIN { for (y = 0; y < 200; ++y) for (x = 0; x < 200; ++x)
    print .01 + x * .0195, .01 + y * .0295, .8, 0, 0, 1 }' > many.pts
echo '0 0 0 0 0 1' > level.pts
printf 'void plastic p 0 0 5 .2 .2 .2 0 0\np ring r 0 0 8 0 0 -99 0 0 1 0 .01\n' > below.rad
year="-w- -frames 5 -points many.pts -wea leap.wea $room"  # whose first pass takes more than a minute of a core
level="-points level.pts -wea leap.wea -frames 2 below.rad"

for signal in INT TERM; do
    check_exit "a $signal ends hours inside a pass over their paths, with nothing written" 3 '
        status=0
        timeout --preserve-status -k 20 -s $signal 2 ptrace $year > cut.str 2> said || status=$?
        [ ! -s cut.str ]; [ "$(wc -l < said)" = 1 ]; grep -q "^ptrace: leap.wea: hours: 8784 of" said; exit $status'
done
check 'a reader that has gone ends them, too' '
    timeout -k 1 60 ptrace -vf $office/view.vf -x 64 -y 64 -frames 900 -wea leap.wea $room 2> said | true'
check 'a reader of some bytes ends them without a word' '
    ptrace -w- -vf $office/view.vf -x 16 -y 16 -frames 3 -wea leap.wea -hours 0621 $room 2> said | head -c 1000 > some
    [ "$(wc -l < said)" = 1 ]; [ "$(wc -c < some)" = 1000 ]'
check_exit 'a full disk is one line' 2 '
    status=0
    ptrace -w- -hours "0621 12-13" $level > /dev/full 2> said || status=$?
    tail -n 1 said | grep -qx "ptrace: stdout: cannot be written: No space left on device"; [ "$(wc -l < said)" = 2 ]
    exit $status'

check 'sixteen parts are the whole, bit by bit' '
    some() { ptrace -w- -vf $office/view.vf -x 8 -y 8 -frames 3 -wea leap.wea -hours "Mar 12-13 $1" $room 2> said; }
    some "" | ptaccum -last -o "whole_%s.exr"; for k in $(seq 16); do some $k/16 | ptaccum -last -o "part_%s.exr"; done
    [ "$(ls part_*.exr | wc -l)" = 31 ]
    for f in whole_*.exr; do [ "$(mkstream differ $f part_${f#whole_})" = 0 ]; done'
check 'a leap year has 8,784 hours' '
    ptrace -w- -hours 2024 $level 2> said | ptaccum | vcmetrics -each > rows
    grep -q "^ptrace: leap.wea: hours: 8784 of 8784, " said; [ "$(grep -c "^0229_" rows)" = 24 ]
    [ "$(grep -v "^sky" rows | cut -f 1 | sort -u | wc -l)" = 8784 ]'
check 'a day by steps of ten minutes has 144' '
    { printf "$head" 23.44; for ((m = 5; m < 1440; m += 10)); do
        awk "BEGIN { h = $m / 60; print 6, 21, h, (h > 6 && h < 18 ? 800 : 0), (h > 5 && h < 19 ? 90 : 0) }"; done
      echo 6 22 12.03 900 100; } > ten.wea
    ptrace -w- -points level.pts -wea ten.wea -frames 400 below.rad > ten.str 2> said
    ptaccum -every x2 < ten.str | vcmetrics -each > rows
    [ "$(grep -c "^0621_" rows)" = 144 ]; grep -q "^0621_1155" rows'
check 'from the horizon to the zenith a level sensor has the illuminance of sun and sky that its header says' '
    strings ten.str | awk "/^SUN=/ { up = sin(\$2 * atan2(0, -1) / 180); high = \$2 > high ? \$2 : high }
        /^ILLUMINANCE=/ { lux = \$2 * up + \$3 } /^SKYNAME=/ { sub(/.*=/, \"\"); if (lux) print \$0, lux; lux = 0 }
        END { exit !(high > 89.5) }" | sort -u > expected
    [ "$(wc -l < expected)" -gt 70 ]
    awk "NR == FNR { lux[\$1] = \$2; next } \$1 in lux { ++n; if (!((\$4 / lux[\$1] - 1) ^ 2 <= 2e-5)) print }
        END { print n }" expected rows > off; [ "$(cat off)" -gt 70 ]'
check 'an hour without diffuse light has the light of its sun alone' '
    { printf "$head" 20; printf "4 21 %s.5 800 0\n" 10 11 12 13; } > sun.wea
    ptrace -w- -points level.pts -wea sun.wea -frames 9 below.rad 2> said > sun.str
    strings sun.str | awk "/^SUN=/ { up = sin(\$2 * atan2(0, -1) / 180) } /^ILLUMINANCE=/ { lux = \$2 * up }
        /^SKYNAME=/ { sub(/.*=/, \"\"); print \$0, lux }" | sort -u > expected
    ptaccum < sun.str | vcmetrics -each -last > rows
    awk "NR == FNR { lux[\$1] = \$2; next } (\$4 / lux[\$1] - 1) ^ 2 < 4e-8 { ++n } END { exit n != 4 }" expected rows'
check 'a scene that no sky sees is black, below the sky alone there are sky and sun' '
    printf "void plastic w 0 0 5 .5 .5 .5 0 0\nw bubble b 0 0 4 0 0 0 9\n" > closed.rad
    ev() { ptrace -w- -vta -vp 0 0 0 -vd 0 1 0 -vu 0 0 1 -vh 180 -vv 180 -x 16 -y 16 -wea leap.wea -hours "0621 8-9" \
        -frames 5 "$@" 2> said | ptaccum | vcmetrics -metrics Ev -W- -last | tail -n +2 | cut -f 4; }
    [ "$(ev closed.rad)" = 0 ]; lit=$(ev below.rad); apart=$(ev -hours-apart below.rad)
    awk "BEGIN { exit !($lit > 5000 && ($lit / $apart - 1) ^ 2 < 1e-5) }"'
check_error 'a mirror says that its hours are rendered one by one' 0 \
    '^ptrace: each hour is rendered by itself: the scene has materials that make virtual suns' '
    printf "void mirror m 0 0 3 .8 .8 .8\nm ring r 0 0 8 0 0 -9 0 0 1 0 1\n" > mirror.rad
    ptrace -w- -points level.pts -wea leap.wea -hours 0621_1230 -frames 2 mirror.rad 2> said > m.str
    grep -v "leap.wea: hours" said >&2'
check 'a scene on the standard input is read once, for hours together, apart and under several skies' '
    printf "void plastic p 0 0 5 .5 .5 .5 0 0\np ring r 0 0 8 0 9 0 0 -1 0 0 5\n" > wall.rad
    printf "void glow g 0 0 4 1 1 1 0\ng source sky 0 0 4 0 0 1 180\n" > sky.rad
    cp sky.rad other.rad
    for how in "-wea leap.wea -hours 0621_1230 mirror.rad" "-wea leap.wea -hours 0621_1230" \
        "-hours-apart -wea leap.wea -hours 0621" "-sky sky.rad -sky other.rad"; do
        some() { ptrace -w- -vp 0 0 1 -vd 0 1 0 -x 8 -y 8 -frames 3 $how $1 2> said | ptaccum -last; }
        for f in wall.rad -; do some $f < wall.rad | vcmetrics -metrics Ev | cut -f 3- > rows$f; done
        diff rowswall.rad rows-; cut -f 2 rows- | grep -q "[1-9]"
    done'
