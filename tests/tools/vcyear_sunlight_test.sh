# SPDX-License-Identifier: BSD-3-Clause
# EN 17037's exposure to sunlight from outside: a window with a reveal whose sun is known in closed form.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics vcyear
{
    printf 'place Berlin\nlatitude 52.52\nlongitude -13.4\ntime_zone -15\nsite_elevation 0\nweather_data_file_units 1\n'
    awk 'BEGIN { for (m = 300; m < 1200; m += 5) print 3, 21, m / 60, 800, 80 }'
} > day.wea
# A wall .3 m thick about an opening of 1.2 m by 1.4 m, .9 m above the floor, its outer face southwards at y = 0.
{
    echo 'void plastic w 0 0 5 .5 .5 .5 0 0'
    box() { # NAME X0 X1 Z0 Z1
        echo "!genbox w $1 $(awk "BEGIN { print $3 - $2 }") .3 $(awk "BEGIN { print $5 - $4 }") | xform -t $2 0 $4"
    }
    box left -6 -.6 0 3; box right .6 6 0 3; box under -.6 .6 0 .9; box over -.6 .6 2.3 3
} > wall.rad
echo '0 .3 1.2 0 -1 0' > south.pts
echo '0 0 1.2 0 1 0' > north.pts
{ cat north.pts; echo '3 0 1.2 0 -1 0'; cat south.pts; } > both.pts
sun() {
    ptrace -w- -points south.pts -points north.pts -points both.pts -wea day.wea -frames 4 -ab 0 "$@" wall.rad 2> said |
        ptaccum -every x2 | vcmetrics -each
}
sun -dj 0 > sun.tsv

# The reveal hides the sun from 63.43 degrees on either side of south: tan 63.43 = 2 = sin H / (sin latitude cos H) at
# the equinox, so that H is 57.8 degrees on either side of noon, 7.7 hours in all; the rest is below a step.
check 'what the reveal leaves of the day' '
    vcyear -sunlight day.wea 11 -format csv sun.tsv > rows
    awk -F, "\$1 == \"south\" { found = 1; off = \$6 - 7.705; exit !(off < 1 / 12 && off > -1 / 12) }
        END { if (!found) exit 1 }" rows
    grep -q "^south,high,high,high,21 Mar," rows'
check 'north of the wall is none' '
    vcyear -sunlight day.wea 11 sun.tsv > says
    none="none: 0.00 h on 21 Mar, sun at 11 degrees or more, steps of 5 min"
    grep -A1 "^north" says | grep -qx "sunlight  EN 17037 $none"'
check 'points of a room add up, or count each by itself' '
    vcyear -sunlight day.wea 11 -each sun.tsv > each; [ "$(grep -c "^both" each)" = 3 ]
    [ "$(grep "^both	2" each | cut -f 3-)" = "$(grep "^south	0" each | cut -f 3-)" ]
    grep -q "^both	0	none	" each; grep "^both	1" each | cut -f 3- | grep -q "^high"
    [ "$(vcyear -sunlight day.wea 11 sun.tsv | grep -A1 "^both" | tail -n 1)" != \
      "$(vcyear -sunlight day.wea 11 sun.tsv | grep -A1 "^south" | tail -n 1)" ]'
check 'by the whole disc, steps in which an edge hides a part of it are either' '
    sun > disc.tsv; vcyear -sunlight day.wea 11 -format csv disc.tsv | grep ^south > row
    awk -F, -v is="$(grep ^south rows | cut -d, -f 6)" "{ exit !(\$7 <= is && is <= \$8) }" row'
check_error 'a year is no day' 1 '^vcyear: year.wea: has steps of 60 minutes: five or less are wanted$' '
    awk "NR <= 6 || \$3 ~ /^[0-9]*\$/" day.wea > year.wea; vcyear -sunlight year.wea 11 sun.tsv'
check_error 'one thing at a time' 1 \
    '^vcyear: -sunlight: has tables of a day in steps; those of -en17037 are of a year$' '
    vcyear -sunlight day.wea 11 -en17037 day.wea sun.tsv'
