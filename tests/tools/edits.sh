# SPDX-License-Identifier: BSD-3-Clause
# ptaccum and vcmetrics in a live stream (EDIT=): regions read again, differences between edits, -go-on; and the same
# differences of two files (vcmetrics -difference).
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics
office=$TOP/examples/scenes/office
cp "$office"/*.rad "$office"/view.vf "$TOP"/examples/office.regions .
sed 's/\.68 \.67 \.64/.60 .59 .56/' materials.rad > dark.rad
# frames FILE [ptrace's options]: of the office with these materials
frames() { ptrace -w- -vf view.vf -x 32 -y 32 -frames 17 "${@:2}" "$1" layout.rad sky_1400.rad; }
frames materials.rad > light.frames; frames dark.rad > dark.frames; frames dark.rad -seed 2 > other.frames
edit() { sed "s/^FRAME=/EDIT=$1\nFRAME=/" $2.frames; }  # 'number what' frames
live() { edit '0 start' light; edit '1 scene' dark; edit '2 scene' light; }
for name in light dark other; do
    ptaccum -last -batches 16 -o $name.exr < $name.frames; ptaccum < $name.frames > $name.sums
done
column() { awk -v name="$1" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) c = i; next } { print $c }'; }
metrics='-metrics Ev,DGP,UGR,TAL,CR -cr screen=screen_low/screen_high -regions office.regions'

check 'what two files differ by: less than independent runs would, and told apart' '
    vcmetrics -difference $metrics light.exr dark.exr > d; vcmetrics -difference $metrics light.exr other.exr > e 2> w
    head -1 d | grep -q "^row.metric.first.second.difference.lo.hi.apart.se.df$"; [ $(wc -l < d) = 8 ]
    awk "\$2 == \"Ev\" { exit !(\$6 < \$5 && \$5 < \$7 && \$7 < 0 && \$8 == 1 && (\$5 - \$4 + \$3)^2 < .01) }" d
    paste d e | awk "\$2 == \"Ev\" { exit !(3 * (\$7 - \$6) < \$17 - \$16) }"
    grep -q "^vcmetrics: warning: other.exr: its parts hold other frames or seeds than those of light.exr: " w'
check 'streams of sums give the differences of their files' '
    vcmetrics -difference $metrics light.sums dark.sums | diff d -'
check 'a column without bias is of the pixels that -G leaves' '
    vcmetrics -G 2 -metrics DGP,DGPu light.exr | awk -F "\t" "NR == 2 { exit !((\$2 - \$3)^2 < .002^2) }"'
check 'a picture without parts has a difference without an interval' '
    ptaccum -last light.frames > light.hdr; ptaccum -last dark.frames > dark.hdr
    vcmetrics -W- -difference light.hdr dark.hdr |
        awk "NR > 1 && !(\$5 == \$5 + 0 && \$6 \$7 \$8 == \"nannannan\") { exit 1 }"'
check_error 'as many pictures on both sides' 1 '^vcmetrics: dark.exr: has only 1 rows of 2$' '
    cat light.sums light.sums > two; vcmetrics -W- -difference two dark.exr'

check '-against previous: the difference of files, once both edits have the same look' '
    live | ptaccum | vcmetrics $metrics -against previous > t
    [ "$(column Ev.d < t | sed -n 1,19p | uniq)" = nan ]  # edit 0, and frames 0 and 1 of edit 1
    [ "$(column Ev.d < t | sed -n 34p)" = "$(awk "\$2 == \"Ev\" { print \$5 }" d)" ]
    [ "$(column DGP.d.hi < t | sed -n 34p)" = "$(awk "\$2 == \"DGP\" { print \$7 }" d)" ]
    [ "$(column screen.CR.d < t | sed -n 34p)" = "$(awk "\$2 == \"screen.CR\" { print \$5 }" d)" ]
    vcmetrics -difference -metrics Ev dark.exr light.exr > back
    [ "$(column Ev.d < t | sed -n 51p)" = "$(column difference < back)" ]'
check 'lines of edits are compared by frame and edit' '
    live | ptaccum | vcmetrics -metrics Ev > t; { head -1 t; sed 1d t | sort -r; } > back
    vcmetrics -difference -tolerance default t back
    awk -v OFS="\t" "\$1 == 3 && \$3 == 1 { \$4 = 5 } 1" t > other
    status=0; vcmetrics -difference -tolerance default t other > d || status=$?; [ $status = 5 ]
    [ "$(grep "no$" d | cut -f 1)" = "3 1" ]'
check '-against first: the third edit is the first again' '
    live | ptaccum | vcmetrics -metrics Ev -ci 90 -against first > t; [ "$(column Ev.d < t | sed -n 51p)" = 0 ]
    [ "$(head -1 t | cut -f 4-)" = "$(printf "Ev\tEv.lo\tEv.hi\tEv.d\tEv.d.lo\tEv.d.hi\ttails\terrors")" ]'
check '-against FILE: the edit that it names, also where that changes' '
    echo 0 > base; live | ptaccum | vcmetrics -metrics Ev -ci 90 -against base > t
    live | ptaccum | vcmetrics -metrics Ev -ci 90 -against first > u; cmp <(cut -f 1,3- t) <(cut -f 1,3- u)
    echo 1 > base; live | ptaccum | vcmetrics -metrics Ev -ci 90 -against base > t
    [ "$(column Ev.d < t | sed -n 2,34p | uniq)" = nan ]; [ "$(column Ev.d < t | sed -n 51p)" != nan ]'
check_error 'no edit' 1 '^vcmetrics: -against: "nothing" is neither previous nor first, nor a file' '
    vcmetrics -against nothing < /dev/null'
check 'previews have no line, and change nothing' '
    { edit "0 start" light; edit "1 preview" other; edit "1 view" dark; } | ptaccum | vcmetrics -metrics Ev > t
    [ "$(column edit < t | uniq | tr "\n" " ")" = "0 1 " ]; [ $(wc -l < t) = 35 ]
    vcmetrics -metrics Ev < dark.sums | column Ev > alone; column Ev < t | tail -17 | diff - alone'
check 'an edit does not write the old sum once more' '
    { edit "0 start" light; edit "1 scene" dark; } | ptaccum -every 10 | vcmetrics -metrics Ev > t
    [ "$(column frame < t | tr "\n" " ")" = "0 10 0 10 16 " ]'
check '-go-on: settled from the line on at which -until would stop, anew in each edit' '
    frames materials.rad -frames 90 > long.frames; rule="Ev 5%"
    ptaccum < long.frames | vcmetrics -metrics Ev -until "$rule" 2> w > alone
    n=$(tail -1 alone | cut -f 1); [ $n -lt 85 ]
    { edit "0 start" long; edit "1 scene" long; } | ptaccum | vcmetrics -metrics Ev -until "$rule" -go-on 2> w > t
    [ $(wc -l < t) = 181 ]; column settled < t | uniq -c | awk "{ print \$1, \$2 }" > runs
    printf "$n 0\n$((90 - n)) 1\n$n 0\n$((90 - n)) 1\n" | diff - runs
    sed "s/Ev .*//" w > w2; printf "vcmetrics: edit %s: settled after $n frames: \n" 0 1 | diff - w2'
check 'nothing is settled while the regions are being written' '
    { echo; cat office.regions; } > busy.regions; n=$(tail -1 alone | cut -f 1)
    while [ ! -e enough ]; do printf " " 1<> busy.regions; done & writer=$!
    edit "0 start" long | ptaccum | vcmetrics -metrics Ev -regions busy.regions -until "Ev 5%" -go-on 2> w > busy
    touch enough; wait $writer; [ $(column settled < busy | grep -c 0) -gt $n ]'
check_error '-go-on needs a rule' 1 '^vcmetrics: -go-on: ' 'vcmetrics -go-on < light.sums'

# The region file changes between the pictures of edit 0 and those of edit 1, which come when its lines are out.
lines() { for i in $(seq 400); do [ -s t ] && [ $(wc -l < t) -ge $1 ] && return; sleep .025; done; return 1; }
changing() {  # command that changes r.regions, vcmetrics' options
    cp office.regions r.regions; : > t
    { edit '0 start' light; lines 18; eval "$1"; sleep .1; edit '1 scene' dark; } | ptaccum |
        vcmetrics -metrics Ev,TAL -regions r.regions "${@:2}" > t 2> said
}
check 'a region that has moved has the values of its new place with the next picture' '
    changing "sed '\''s/^desk/floor/; s/screen_low/desk/; s/^floor/screen_low/'\'' office.regions > r.regions"
    [ "$(sed -n 19p t | cut -f 4-)" = "$(printf "Ev\tscreen_low.TAL\tscreen_high.TAL\tdesk.TAL")" ]
    vcmetrics -metrics TAL -regions office.regions < dark.sums > alone
    [ "$(tail -17 t | cut -f 5)" = "$(column desk.TAL < alone)" ]
    [ "$(tail -17 t | cut -f 7)" = "$(column screen_low.TAL < alone)" ]
    [ ! -s said ]'
check 'regions may come to a file that held none, and may all go' '
    cp office.regions full.regions; echo "# none yet" > office.regions; changing "cp full.regions r.regions"
    cp full.regions office.regions; grep -q "^vcmetrics: warning: r.regions: holds no region$" said
    [ "$(head -1 t)" = "$(printf "frame\tseconds\tedit\tEv")" ]; [ "$(sed -n 19p t | cut -f 5)" = desk.TAL ]
    changing ": > r.regions"; [ "$(sed -n 19p t | cut -f 4-)" = Ev ]'
check 'regions that come between two edits have no difference, and the other columns have theirs' '
    cp office.regions full.regions; echo "# none yet" > office.regions
    changing "cp full.regions r.regions" -ci 95 -against previous; cp full.regions office.regions
    [ $(wc -l < t) = 36 ]; sed 1,18d t > after; [ "$(column desk.TAL.d < after | tail -1)" = nan ]
    vcmetrics -difference -metrics Ev light.exr dark.exr > alone
    [ "$(column Ev.d < after | tail -1)" = "$(column difference < alone)" ]'
check 'regions that come and go: a new line of names' '
    changing "sed 1,3d r.regions > q;  echo wall rect 4 4 20 9 >> q;  mv q r.regions"
    [ "$(grep -c ^frame t)" = 2 ]
    [ "$(sed -n 19p t | cut -f 4-)" = "$(printf "Ev\tscreen_high.TAL\tscreen_low.TAL\twall.TAL")" ]
    tail -17 t | cut -f 7 | awk "!(\$1 + 0 > 0) { exit 1 }"'
check 'a region that -cr names stays, as nan' '
    changing "sed -i /screen_low/d r.regions" -cr screen_low/screen_high -metrics Ev,CR
    [ "$(grep -c ^frame t)" = 1 ]; [ "$(tail -17 t | cut -f 5 | uniq)" = nan ]'
check 'a pair of -cr may come before its regions: nan, then numbers' '
    cp office.regions whole.regions; sed /screen/d office.regions > r.regions
    { edit "0 start" light; edit "1 scene" dark | { sleep 1; cp whole.regions q; mv q r.regions; sleep .3; cat; }; } |
        ptaccum | vcmetrics -regions r.regions -cr screen_low/screen_high -metrics Ev,CR > t
    [ "$(sed -n 2,17p t | cut -f 5 | uniq)" = nan ]; grep -q "screen_low/screen_high.CR" t
    tail -1 t | awk "!(\$NF + 0 > 0) { exit 1 }"; echo > r.regions
    edit "0 start" light | ptaccum | vcmetrics -regions r.regions -cr a/b -metrics Ev,CR | tail -1 | grep -q "nan$"'
check 'a ratio without bias may come before its regions' '
    cp office.regions full.regions; sed -i /screen/d office.regions
    changing "cp full.regions r.regions" -cr screen_low/screen_high -metrics Ev,CRu; cp full.regions office.regions
    sed 1,18d t | tail -1 | awk "!(\$NF + 0 > 0) { exit 1 }"'
check_error 'in a picture its regions are there' 1 '^vcmetrics: -cr: there is no region "a"' '
    vcmetrics -W- -regions office.regions -cr a/b -metrics CR light.exr'
check 'a broken region file is said once with its line, and the last good one goes on' '
    changing "echo desk circle >> r.regions"
    [ $(wc -l < said) = 1 ]; grep -q "^vcmetrics: r.regions:6: " said; [ "$(grep -c ^frame t)" = 1 ]
    vcmetrics -metrics TAL -regions office.regions < dark.sums | column desk.TAL > alone
    tail -17 t | cut -f 5 | diff - alone'
check 'a region out of sight is nan, and the pipe goes on' '
    changing "echo behind circle 0 1 0 5 >> r.regions"; [ "$(tail -17 t | cut -f 8 | uniq)" = nan ]; [ ! -s said ]'
check_error 'without edits a region out of sight ends the run' 1 '^vcmetrics: r.regions:6: region "behind" is empty' '
    vcmetrics -W- -regions r.regions light.hdr'
