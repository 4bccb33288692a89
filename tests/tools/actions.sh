# SPDX-License-Identifier: BSD-3-Clause
# Pictures of an action (ACTION=, ptrace -action) beside the ordinary ones: their files, and what is measured in them.
. "${TOP:?}/tests/lib.sh"
needs ptaccum vcmetrics vcyear mkstream
# The frames of an ordinary picture again, as those of actions: mEDI is .6 of Ev, illuminance by V 1.2 of it.
stream() {
    mkstream frames 0 "$1" 16 16 > o; mkstream action mel 9 lx .6 < o > mel; mkstream action V 12 lx 1.2 < o > V
    cat o mel V | mkstream last "$1"
}
stream 8 > all.str
named() { LC_ALL=C sed "s|^FRAME=|VIEWNAME=$1\n&|"; }  # a view of that name

check 'pictures of actions go to files beside the ordinary one' '
    ptaccum -last -o office.exr < all.str; strings office_mel.exr | grep -q "^ACTION=mel 9 lx"
    strings office.exr | not grep -q ACTION=; [ "$(echo office*.exr | wc -w)" = 3 ]; [ -e office_V.exr ]'
check 'and those of several views likewise' '
    for v in desk door; do named $v < all.str; done | ptaccum -last -o "%s.exr"
    ls desk.exr desk_mel.exr desk_V.exr door.exr door_mel.exr door_V.exr'
check 'a stream of sums says which is which' '
    ptaccum -every 8 < all.str | strings | grep "^ACTION=\|^FRAMES=8" | uniq | tr "\n" " " > is
    grep -qx "FRAMES=8 ACTION=mel 9 lx FRAMES=8 ACTION=V 12 lx FRAMES=8 " is'
check_error 'they are not merged' 1 '^ptaccum: office_mel.exr: has action mel of 9 bands in lx, office.exr has' '
    ptaccum office.exr office_mel.exr -o both.exr'
check_error 'nor is a sum of one continued by frames of the other' 1 'has no action \(ACTION=\), office_mel.exr has' '
    mkstream frames 9 12 16 16 > more.str; ptaccum office_mel.exr more.str -o both.exr'
check_error 'a line that is no such' 1 'header line "ACTION=mel lx" is not ACTION=name bands' '
    LC_ALL=C sed "s/^FRAME=/ACTION=mel lx\n&/" o | ptaccum -last -o x.exr'

# Numbers
stream 64 > long.str; ptaccum -every x2/16 < long.str 2> said > sums.str
columns() { vcmetrics -ci 95 -metrics "$@" 2> said; }
check 'the last row of a view has all numbers, those of actions behind the others' '
    columns Ev,mEDI,mDER,DGPV,EvV < sums.str | cut -f 3-17 > rows
    [ "$(head -n 1 rows | tr "\t" "\n" | grep -v "[.]" | tr "\n" " ")" = "Ev mEDI mDER DGPV EvV " ]
    tail -n 1 rows | awk "function near(a, b) { if (!((a/b - 1)^2 <= 1e-8)) { print a, b; exit 1 } }
        { near(\$4, .6*\$1); near(\$5, .6*\$2); near(\$6, .6*\$3); near(\$7, .5); near(\$13, 1.2*\$1) }"
    tail -n 1 rows | awk "{ exit \$8 != \$7 || \$9 != \$7 || !(\$2 < \$1) || !(\$10 > .2) }"'
check 'an illuminance by V that differs from Ev is told once' '
    [ "$(grep -c "illuminance by V is 2067 lx (EvV), of the ordinary .* 1723 lx (Ev), -16.7 %" said)" = 1 ]'
check 'with -last it is the only row of the view' '
    for v in desk door; do named $v < long.str; done | ptaccum -every x2/16 > two.str 2> said
    columns Ev,mEDI,mDER -last < two.str > rows
    [ "$(cut -f 1,3 rows | tr "\t\n" "/ ")" = "frame/view 64/desk 64/door " ]
    awk "NR > 1 && !((\$10 - .5)^2 <= 1e-8) { exit 1 }" rows'
check 'who asks for no action has the rows of before' '
    columns Ev,DGP < sums.str > with; mkstream last 64 < o | ptaccum -every x2/16 2> said | columns Ev,DGP > without
    cut -f 1,3- with | diff - <(cut -f 1,3- without)'
check 'files one after another count, too' '
    ptaccum -last -o f.exr < long.str; columns Ev,mEDI,mDER f.exr f_mel.exr f_V.exr > rows
    not grep -v "illuminance by V" said
    [ "$(cut -f 1 rows | tr "\n" " ")" = "file f.exr f_mel.exr f_V.exr " ]
    tail -n 1 rows | awk "{ exit !((\$8 - .5)^2 <= 1e-8) }"
    columns mEDI f.exr f_mel.exr f.exr f_mel.exr | cut -f 1 | tr "\n" " " > rows
    grep -qx "file f.exr f_mel.exr f.exr f_mel.exr " rows'
check 'by itself such a picture is called by its name' '
    [ "$(vcmetrics f_mel.exr | tr "\t\n" "::" | sed "s/\([.]..\)[0-9]*:$/\1:/")" = "file:mEDI:f_mel.exr:1033.62:" ]'
check 'that of V has luminances, and glare' '
    vcmetrics -metrics Ev,DGP f_V.exr | tail -n 1 | awk "{ exit !(\$2 > 2066 && \$2 < 2068 && \$3 > .2) }"
    vcmetrics -sources f_V.exr | grep -q .; vcmetrics -report f.html f_V.exr > x; grep -q "<html" f.html'
check 'a report says it in a sentence' '
    ptaccum -every x2/16 < long.str 2> said | vcmetrics -W- -metrics Ev,DGP,mEDI -ci 95 -report f.html > x
    sed "s/<[^>]*>//g" f.html | grep -qx "Daylight for the body clock: 1034 lx of melanopic EDI (1027 to 1041)."'
for how in '-metrics Ev' '-metrics DGP' -sources '-like evalglare' '-report x.html' '-over x.png'; do
    check_error "not Ev, nor glare: $how" 1 '^vcmetrics: f_mel.exr: is of action mel, in which only mEDI is measured' "
        vcmetrics $how f_mel.exr"
done
check_error 'a report needs the ordinary picture' 1 '^vcmetrics: f_mel.exr: -report and -over show the ordinary ' '
    vcmetrics -metrics mEDI -report x.html f_mel.exr'
check 'DER without illuminance by V is not known, and a line says what to type' '
    columns mDER f.exr f_mel.exr | tail -n 1 | grep -q "^f_mel.exr	nan"
    grep -q "^vcmetrics: warning: f.exr: mDER needs a picture of action V, and there is none: ptrace -action V" said'
check 'and so for one that is not there' '
    columns Ev,scEDI f.exr > x; grep -q "scEDI needs a picture of action sc, and there is none: ptrace -action sc" said'
check_error 'a rule that asks for a column that the run lacks' 1 '^vcmetrics: -until: .* "mEDI" .*; -metrics adds it$' '
    vcmetrics -until "mEDI 2%" < sums.str'
check 'actions of a user are called by their names' '
    mkstream action plant 9 W/m2 .01 < o | mkstream last 64 | cat long.str - | ptaccum -last > plant.str
    columns Ev,E_plant -last < plant.str | tail -n 1 | awk "{ exit !((\$6/\$3 - .01)^2 <= 1e-6) }"'
check 'a rule waits for what the run is to measure, and ends it in the picture of the action' '
    columns mEDI,Ev -until "mEDI 2%" < sums.str > rows; [ "$(tail -n 1 rows | cut -f 1)" -lt 64 ]
    grep -q "^vcmetrics: stopped after .* mEDI 10[0-9.]* +-" said
    columns mEDI,Ev -until "Ev 2%" < sums.str > rows; tail -n 1 rows | awk "{ exit \$1 != 64 || !(\$6 > 1000) }"'
check 'with -control each picture is ended by itself' '
    mkfifo ctl; exec 7<> ctl; columns mEDI,mDER,Ev -until "mEDI 2%, Ev 2%, mDER 1%" -control ctl < two.str > rows
    for n in desk door; do for a in "" _mel _V; do echo "next $n$a"; done; done > due; head -n 6 <&7 | diff due -
    grep -q "^vcmetrics: door_V: stopped after 16 frames: mDER 0.5 +- 0$" said'
check 'pictures of actions are compared with their like' '
    vcmetrics -difference -metrics mEDI f_mel.exr f_mel.exr | tail -n 1 | grep -q "^mel	mEDI	1033"'
check_error 'not with others' 1 '^vcmetrics: f.exr: is no picture of an action' '
    vcmetrics -difference -metrics mEDI f_mel.exr f.exr'
check_error 'nor as ordinary ones' 1 '^vcmetrics: f_mel.exr: is of action mel' '
    vcmetrics -difference -metrics Ev f_mel.exr f_mel.exr'

# Sensors: the same pixels, as a grid
grid() { LC_ALL=C sed "s|^VIEW=.*|GRID=floor 0 256 irradiance 0123456789abcdef|"; }
grid < long.str | ptaccum -every x2/16 2> said > floor.str
check 'numbers of sensors by an action stand in the row of its last picture' '
    columns "mean,floor.mEDI.mean,mEDI.share250,EvV.mean" -last < floor.str > rows; [ "$(wc -l < rows)" = 2 ]
    [ "$(head -n 1 rows | cut -f 3- | tr "\t" "\n" | grep -v "[.][lh][oi]$" | tr "\n" " ")" = \
        "floor.mean floor.mEDI.mean floor.mEDI.share250 floor.EvV.mean " ]
    tail -n 1 rows | awk "function near(a, b) { if (!((a/b - 1)^2 <= 1e-8)) { print a, b; exit 1 } }
        { near(\$6, .6*\$3); near(\$7, .6*\$4); near(\$12, 1.2*\$3); exit !(\$9 > 0 && \$9 < 1) }"'
check 'each sensor has both in a row' '
    columns mEDI -each < floor.str > each; [ "$(wc -l < each)" = 257 ]
    [ "$(head -n 1 each | cut -f 3-9 | tr "\t" " ")" = "E lo hi mEDI mEDI.lo mEDI.hi errors" ]
    awk "NR > 1 && !((\$6/\$3 - .6)^2 <= 1e-8) { exit 1 }" each; tail -n 1 each | grep -q " mEDI=[0-9]"'
check 'who asks for no action of sensors has the rows of before' '
    columns mean < floor.str > with; mkstream last 64 < o | grid | ptaccum -every x2/16 2> said | columns mean > without
    cut -f 1,3- with | diff - <(cut -f 1,3- without)'
check 'a rule of sensors waits for its pictures' '
    columns mEDI.mean -until "mEDI.mean 20%" < floor.str > rows; grep -q "^vcmetrics: .*stopped after" said
    [ "$(tail -n 1 rows | cut -f 1)" -lt 64 ] && tail -n 1 rows | awk "{ exit !(\$3 > 100) }"'
check_error 'the ratio is of views' 1 '^vcmetrics: -metrics: floor.mDER.mean: the ratio is of views' '
    vcmetrics -metrics floor.mDER.mean < floor.str'

# A year of four hours, in which mEDI is 86, 172, 344 and 250.05 +- 1.7 lx
mkstream frames 0 16 16 16 > o16
for hour in "0121_0930 .05" "0121_1230 .1" "0221_0930 .2" "0221_1230 .1455"; do
    { cat o16; mkstream action mel 9 lx "${hour#* }" < o16; } | mkstream last 16 |
        LC_ALL=C sed "s|^FRAME=|SKYNAME=${hour% *}\n&|"
done > year.str
ptaccum -every x2/16 < year.str 2> said | columns Ev,DGP,mEDI -last > year.tsv
check 'vcyear counts the hours of a view with 136 and 250 lx' '
    vcyear year.tsv 2> said | grep -qx "mEDI      136 lx in 3, 250 lx in 2 (1 to 2) of 4 hours"
    vcyear -format jsonl year.tsv 2> said | grep -q "\"mEDI_250\": *2,.*\"mEDI_250.lo\": *1,"'
check 'rows of ordinary pictures, which have no mEDI yet, do not count' '
    ptaccum -every x2/16 < year.str 2> said | columns Ev,DGP,mEDI > all.tsv
    vcyear all.tsv 2> said | grep mEDI | diff - <(vcyear year.tsv 2> said | grep mEDI)'
check 'and the share of the sensors' '
    grid < year.str | ptaccum -every x2/16 2> said | columns mEDI -each > sensors.tsv
    vcyear sensors.tsv > five 2> said; grep -q "^DA " five
    grep -qE "^mEDI      136 lx in .* %.* of the hours, in 50 % of them at .* %.* of the sensors; 250 lx in" five
    vcyear -format tsv sensors.tsv 2> said | head -n 1 | tr "\t" "\n" | grep -c "^s*mEDI_" | grep -qx 12'
check 'without the column nothing is said of it' '
    ptaccum -every x2/16 < year.str 2> said | columns Ev,DGP -last > plain.tsv
    vcyear plain.tsv 2> said | not grep mEDI'
