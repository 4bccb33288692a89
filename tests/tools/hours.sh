# SPDX-License-Identifier: BSD-3-Clause
# Hours of a weather file (ptrace -wea): each is the picture of a run of its own, dark ones are there, and say so.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics mkstream
office=$TOP/examples/scenes/office
scene="$office/materials.rad $office/layout.rad"
render() { ptrace -vf $office/view.vf -x 16 -y 16 -frames 4 "$@" $scene; }
cat > y.wea <<'END'
place Here
latitude 39.74
longitude 105.18
time_zone 105
site_elevation 1829
weather_data_file_units 1
12 21 7.5 100 20
12 21 4.5 9999 9999
12 21 12.5 700 90
12 22 12.5 0 0
12 22 13.5 9999 100
END

check 'hours by date, named by their middle, of which the user is told' '
    render -wea y.wea -hours "1221 1222 4-13" > all.str 2> said
    strings all.str | sed -n "s/^SKYNAME=//p" | uniq | tr "\n" " " > is
    [ "$(cat is)" = "1221_0430 1221_0730 1221_1230 1222_1230 " ]
    year="the sun is that of 2022; 1 January is a Sunday, standard time is UTC-7"
    grep -qx "ptrace: y.wea: hours: 4 of 4, 2 dark; $year" said'
ptaccum -o '%s.exr' < all.str
check 'headers have time, sun and irradiances' '
    strings all.str | grep -A 2 "^TIME= 21 Dec 12:30 UTC-7" | sed -n 2,3p | tr "\n" " " > is
    [ "$(cat is)" = "SUN= 26.41 187.96 IRRADIANCE= 700 90 " ] '
check 'vcmetrics finds black pictures where an hour has light, not where it is dark or without values' '
    render -wea y.wea 2> notes | ptaccum -last -o - | vcmetrics -metrics Ev 2> said > rows; [ ! -s said ]
    printf "void plastic shut 0 0 5 0 0 0 0 0\nshut sphere s 0 0 4 $(
        sed -n "s/.*-vp \([^ ]* [^ ]* [^ ]*\).*/\1/p" $office/view.vf) .1\n" > shut.rad
    render -wea y.wea shut.rad 2> notes | ptaccum -last -o - | vcmetrics -metrics Ev 2> said > rows
    grep -q "^vcmetrics: warning: 1221_0730: the picture is black: .* in a solid" said
    tail -n 1 said | grep -q "is black: .*(2 times)$"; [ "$(wc -l < said)" = 2 ]'
check 'without -frames hours have sixteen diffuse ones each' '
    ptrace -vf $office/view.vf -x 8 -y 8 -wea y.wea -hours "1221 7-13" $scene 2> said | ptaccum -every x2/8 |
        vcmetrics -metrics Ev -last > rows
    [ "$(tail -n +2 rows | cut -f 1 | uniq -c | tr -s " ")" = " 2 16" ]'
check 'an hour has the frames of a run for this hour alone' '
    render -wea y.wea -hours 1221_1230 | ptaccum -last -o alone_%s.exr
    [ "$(mkstream differ alone_1221_1230.exr 1221_1230.exr)" = 0 ]'
check 'and those of a run with its sky as a file and its seed' '
    cat > noon.rad <<END
# as gendaylit 12 21 12.5 -y 2022 -a 39.74 -o 105.18 -m 105 -W 700 90 -i 60
void light solar 0 0 3 5466091.5 5466091.5 5466091.5
solar source sun 0 0 4 -0.1239985 -0.887012422 0.444784641 0.533
void brightfunc skyfunc 2 skybright perezlum.cal 0 10 32.2790985 13.187849
-1.05716443 -0.318681985 13.0662575 -3.42451596 0.344909966
-0.1239985 -0.887012422 0.444784641
skyfunc glow sky_glow 0 0 4 1 1 1 0
sky_glow source sky 0 0 4 0 0 1 180
void brightfunc groundfunc 2 skybright perezlum.cal 0 10 32.2790985 13.187849
-1.05716443 -0.318681985 13.0662575 -3.42451596 0.344909966
-0.1239985 -0.887012422 0.444784641
groundfunc glow ground_glow 0 0 4 1 1 1 0
ground_glow source ground 0 0 4 0 0 -1 180
END
    seed=$((1000000 + (355 * 24 + 12) * 60 + 30))
    render -hours-apart -wea y.wea -hours 1221_1230 > apart.str; strings apart.str | grep -qx SEED=$seed
    ptaccum -last -o apart_%s.exr < apart.str
    render -seed $seed -sky noon.rad | ptaccum -last -o alone_%s.exr
    [ "$(mkstream differ alone_noon.exr apart_1221_1230.exr)" = 0 ]'
check 'hours together have the light of hours apart' '
    ev() { ptrace -w- -vf $office/view.vf -x 32 -y 32 -frames 129 -wea y.wea -hours 1221_1230 "$@" $scene 2> said |
        ptaccum -every x2/8 | vcmetrics -metrics Ev -ci 95 -last | awk "END { print \$3, (\$5 - \$4) / 4 }"; }
    { ev; ev -hours-apart; } | awk "{ e[NR] = \$1; s[NR] = \$2 }
        END { exit !((e[1] - e[2]) ^ 2 < 16 * (s[1] ^ 2 + s[2] ^ 2)) }"'
check 'so have sensors, in the same bits one path at a time' '
    for x in 1 2 3; do for y in 1 2 3; do echo $x $y .8 0 0 1; done; done > nine.pts
    rows() { ptrace -w- -points nine.pts -wea y.wea -hours 1221_1230 "$@" $scene 2> said | ptaccum -every x2/8 |
        vcmetrics -W- -each; }
    rows -frames 65 | cut -f -8 > together.tsv; rows -hours-apart -frames 129 > apart.tsv
    paste together.tsv apart.tsv | awk -F "\t" "NR > 1 && \$4 > 0 {
        sum += (\$4 - \$12) ^ 2 / (((\$6 - \$5) / 4) ^ 2 + ((\$14 - \$13) / 4) ^ 2); n++
        } END { exit !(n > 6 && sum / n < 4) }"
    rows -frames 3 > side.tsv; rows -frames 3 -device cpu:baseline | cmp - side.tsv'
check 'and the same bits one path at a time' '
    render -device cpu:baseline -wea y.wea -hours 1221_1230 2> said | ptaccum -last -o plain_%s.exr
    [ "$(mkstream differ plain_1221_1230.exr 1221_1230.exr)" = 0 ]'
check 'the hour in which the sun rises has it in the middle of its light' '
    strings all.str | grep -A 1 "^TIME= 21 Dec 07:30" | grep -qx "SUN= 2.97 124.13"'
check 'dark hours are one black frame, and have their line' '
    ptaccum < all.str | vcmetrics -metrics Ev,DGPf > t.tsv
    [ "$(awk "\$3 ~ /0430|1222/ { print \$1, \$4 }" t.tsv | sort | uniq -c | tr -s " ")" = " 2 0 0" ]
    [ "$(awk "\$3 == \"1221_1230\" && \$4 > 1000" t.tsv | wc -l)" = 4 ]'
check 'shares of the hours are those of the whole, one after another' '
    for k in 1 2; do render -wea y.wea -hours "1221 1222 4-13 $k/2"; done > shares.str
    ptaccum -o "share_%s.exr" < shares.str
    for name in 1221_0730 1221_1230 1222_1230; do [ "$(mkstream differ share_$name.exr $name.exr)" = 0 ]; done'
check 'several views under each hour' '
    printf "VIEW= a -vd 0 1 0\nVIEW= b -vd 1 0 0\n" > two.vf
    render -views two.vf -wea y.wea -hours 1221_1230 | ptaccum -o "%s.exr"
    [ -e a_1221_1230.exr ] && [ -e b_1221_1230.exr ]'
check 'progress counts pictures' 'render -t 1 -x 256 -y 256 -frames 9 -wea y.wea -hours "1221 4-13" 2> said > frames
    grep -qE "^ptrace: 1221_(07|12)30: frame [0-9] of 8, picture [12] of 2, .* s left" said'
cat > lit.wea <<'END'
place Here
latitude 45
longitude -8
time_zone -15
site_elevation 0
weather_data_file_units 1
1 2 8.5 441.62 45
2 29 12.5 300 90
3 21 12.5 800 200
6 21 12.5 0 200
6 21 14.5 800 0
12 21 4.5 5 0
12 21 12.5 50 40
END
lux() { ptrace -points level.pts -frames 400 "$@" ground.rad | ptaccum -every x2 | vcmetrics -each; }
check 'a level sensor has Perez'"'"' illuminance of both irradiances' '
    printf "void plastic p 0 0 5 .2 .2 .2 0 0\np ring r 0 0 8 0 0 -99 0 0 1 0 .01\n" > ground.rad
    echo 0 0 0 0 0 1 > level.pts
    lux -wea lit.wea > lux.tsv 2> said
    printf "%s\n" "0229_1230 32339.8" "0321_1230 82789.9" "0621_1230 24734.2" "1221_1230 6882.95" > expected
    awk "NR == FNR { lux[\$1] = \$2; next } \$1 in lux && (\$4 / lux[\$1] - 1) ^ 2 < 1e-6 { ++n } END { exit n != 4 }" \
        expected lux.tsv'
check 'no hour with light is black, also where gendaylit has no sky, and without diffuse light' '
    [ "$(awk "\$1 == \"0102_0830\" && \$4 > 6700 || \$1 == \"0621_1430\" && \$4 > 70000" lux.tsv | wc -l)" = 2 ]
    [ "$(awk "\$1 == \"1221_0430\" { print \$4 }" lux.tsv)" = 0 ]'
check 'what is left out of a sky, and light without a sun, is told once by its hour' '
    grep -qx "ptrace: warning: lit.wea:7: 0102_0830: Perez. sky is not positive .* left out" said
    grep -qx "ptrace: warning: lit.wea:12: 1221_0430: has direct sunlight with the sun below the horizon.*" said
    [ "$(wc -l < said)" = 3 ]'
check 'the sun is that of the year in -hours' '
    lux -wea lit.wea -hours "2023 0321" 2> said | grep ^0321_1230 | cut -f -4 > of_2023
    grep -q "the sun is that of 2023; 1 January is a Sunday" said; ! grep -qFf of_2023 lux.tsv'
check 'hours without values are counted, and are rows of nan' '
    render -wea y.wea > with.str 2> said
    grep -q "^ptrace: y.wea: hours: 5 of 5, 2 dark, 1 without values; " said
    ptaccum < with.str | vcmetrics -metrics Ev,DGPf,classf -ci 95 -last > t.tsv
    grep -P "\t1222_1330\tnan\tnan\tnan\tnan\tnan\tnan\tunknown\t" t.tsv
    echo "0 0 1 0 0 1" > one.pts
    ptrace -points one.pts -wea y.wea -frames 3 $scene 2> said | ptaccum | vcmetrics -each > e.tsv
    grep -P "^1222_1330\t.*\tnan\tnan\tnan\t" e.tsv'
check 'they are undecided in a year' '
    ptaccum < with.str | vcmetrics -metrics Ev,DGPf,DGP.px,DGPf.px,pixels -ci 95 -last > t.tsv
    vcyear t.tsv > year; grep -qE "^hours     5, 2 dark, [1-3] undecided, 1 without values$" year
    vcyear -next t.tsv | not grep 1222_1330
    vcyear e.tsv > year; grep -qE "^hours     5, 2 dark, 1 sensors, 1 without values$" year'
check_error 'but one that is named is an error' 1 \
    '^ptrace: y.wea:11: the direct normal irradiance of 1222_1330 is 9999 W/m2: missing, or wrong$' \
    'render -wea y.wea -hours 1222_1330 > out.str'
check 'an hour whose sun a smooth floor shows the eye is rendered by itself, beside the others' '
    echo "void plastic shiny 0 0 5 .2 .2 .2 .05 0 shiny polygon floor 0 0 12 -9 -9 0 9 -9 0 9 9 0 -9 9 0" > floor.rad
    floor() { ptrace -vp 0 0 1.2 -vd 0 -1 -.2 -vta -vh 180 -vv 180 -x 16 -y 16 -frames 2 -wea y.wea "$@" floor.rad; }
    floor > one.str 2> said; grep -q "^ptrace: 1 of 2 hours are rendered by themselves: a smooth surface shows" said
    [ "$(strings one.str | sed -n "s/^SKYNAME=//p" | uniq | tr "\n" " ")" = \
        "1221_0430 1221_0730 1222_1230 1222_1330 1221_1230 " ]
    ptaccum -last -o "one_%s.exr" < one.str; floor -hours-apart -hours 1221_1230 2> said | ptaccum -last -o "by_%s.exr"
    [ "$(mkstream differ one_1221_1230.exr by_1221_1230.exr)" = 0 ]
    table() { ptaccum -every x2/8 | vcmetrics -metrics Ev,DGPf,DGP.px,DGPf.px,pixels -ci 95; }
    floor -frames 9 2> said | table > t.tsv; vcyear t.tsv > year; grep -q "^hours     5, 2 dark" year
    floor -frames 9 -hours 1221_1230 2> said | table | head -n 1 | cmp - <(head -n 1 t.tsv)
    floor -vd 0 1 -.2 > other.str 2> said; ! grep -q "by themselves" said'
check 'moments have the same bits by one thread and by many' '
    { head -n 6 y.wea; for m in 1 3 5 6 9 11 12; do for h in 8.5 9.5 11.5 13.5 15.5; do
        echo "$m 21 $h 700 90"; done; done; } > many.wea
    for n in 1 7; do LUXPIPE_THREADS=$n ptrace -vf $office/view.vf -x 33 -y 33 -frames 1 -wea many.wea $scene; done \
        2> said > both.str
    head -c $(($(wc -c < both.str) / 2)) both.str | cmp - <(tail -c $(($(wc -c < both.str) / 2)) both.str)'
check_error '-hours needs weather' 1 '^ptrace: -hours: needs a weather file: -wea$' 'render -hours Mo > out.str'
check_error 'skies are files or hours' 1 '^ptrace: -wea: has its own skies' 'render -wea y.wea -sky y.rad > out.str'
