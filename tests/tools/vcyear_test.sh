# SPDX-License-Identifier: BSD-3-Clause
# vcyear from outside: from the weather to the year, hours rendered again, and what it refuses.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics vcyear
office=$TOP/examples/scenes/office
cat > y.wea <<'END'
place Here
latitude 39.74
longitude 105.18
time_zone 105
site_elevation 1829
weather_data_file_units 1
END
for month in 1 2 3; do
    for hour in 5.5 9.5 12.5 15.5; do echo "$month 21 $hour 700 90"; done
done >> y.wea
rendered() {
    ptrace -w- -hours-apart -vf $office/view.vf -x 24 -y 24 -wea y.wea "$@" $office/materials.rad $office/layout.rad |
        ptaccum -every x2/8
}
measured() { vcmetrics -W- -metrics Ev,DGPf,DGP.px,DGPf.px,pixels -ci "$@"; }
hours() { rendered "$@" | measured 95; }
rendered -frames 9 > all.frames 2> said
measured 95 < all.frames > all.tsv 2> said

check 'five lines, dark hours among them' '
    vcyear all.tsv > five; [ "$(wc -l < five)" = 5 ]
    grep -qE "^hours     12, 3 dark, [0-9]+ undecided$" five
    grep -qE "^worst     0.[0-9]+: ptrace ... -hours 0[123]21_" five'
check 'the year is the same whatever the certainty of its limits' '
    for ci in 60 90 99; do measured $ci < all.frames > ci.tsv 2> said; vcyear ci.tsv | cmp five -; done'
check 'a table of limits alone counts as of 95 %, which is told' '
    awk -F "\t" -v OFS="\t" "{ NF -= 2; print }" all.tsv > limits.tsv
    vcyear limits.tsv 2>&1 > out | grep -q "warning: limits.tsv: no column errors .*count as of 95 %$"'
# Hours that share their paths: parts with the same seed do, too.
shared() {
    ptrace -w- -seed ${seed:-1} -vf $office/view.vf -x 24 -y 24 -wea y.wea "$@" $office/materials.rad \
        $office/layout.rad | ptaccum -every x2/8 |
        vcmetrics -W- -metrics Ev,DGPf,DGP.px,DGPf.px,pixels -ci 95 -last
}
check 'hours that share paths say so at the end of their rows, with half-samples' '
    shared -frames 9 > one.tsv 2> said; [ "$(cut -f 20 one.tsv | sort -u | wc -l)" -ge 2 ]
    head -n 1 one.tsv | grep -q "	errors	paths	hour$"
    sed -n 3p one.tsv | grep -qE "	Ev=[^ ]*/[A-Za-z0-9_-]{16}/4 DGPf=[^ ]*/4 DGP.px=[^ ]*/4	[0-9a-f]{8}	2/12$"
    vcyear one.tsv > says; grep -q "^hours     12, 3 dark" says'
check 'parts of one run join, in all formats' '
    for k in 1 2; do shared -frames 9 -hours $k/2 2> said > part.$k; done; cat part.1 part.2 | vcyear - | cmp - says'
check_error 'hours of another seed do not' 1 '^vcyear: 0[123]21_[0-9]*: and 0121_[0-9]* share their paths with' '
    seed=2 shared -frames 9 -hours 2/2 2> said > other; cat part.1 other | vcyear -'
check_error 'nor are they counted without half-samples' 1 '^vcyear: 0121_[0-9]*: has no half-samples, but hours' '
    sed -E "s,/[A-Za-z0-9_-]{16}/4,,g" one.tsv > bare.tsv; vcyear bare.tsv'
check 'parts joined by cat, and the standard input' '
    hours -frames 9 -hours 1/2 > a.tsv 2> said; hours -frames 9 -hours 2/2 > b.tsv 2> said
    cat a.tsv b.tsv | vcyear - > joined; cmp five joined
    vcyear b.tsv a.tsv | cmp five -'
check 'an hour rendered again replaces what was said of it' '
    hours -frames 9 -hours 0221_1230 2> said |
        awk -F "\t" -v OFS="\t" "NR > 1 { for (i = 7; i <= 9; i++) \$i += .05 } 1" > more.tsv
    [ "$(vcyear -format tsv all.tsv more.tsv | cut -f 2 | tail -n 1)" = 12 ]
    vcyear -worst 12 all.tsv > before; vcyear -worst 12 all.tsv more.tsv > after
    [ "$(diff before after | grep -c "^> .*0221_1230")" = 1 ]'
check 'a table in any format, with lines of any system, is the same year' '
    head -n 1 all.tsv | tr "\t" "," > all.csv
    tail -n +2 all.tsv | tr "\t" "," >> all.csv; vcyear all.tsv > want
    for f in all.tsv all.csv; do
        vcyear $f | cmp - want; sed "s/$/\r/" $f > crlf; vcyear crlf | cmp - want
    done'
check 'its hours are read by ptrace again' '
    vcyear -next all.tsv > more; head -n 1 more | grep -qx "hour	frames	larger	limit	view"
    { cat more; printf "0321_0930\t40\t2\t0.40\t-\n"; } > named
    hours -frames 2 -hours @named 2> said | cut -f 3 | grep -qx 0321_0930'
check 'one line a view in tsv, csv and jsonl' '
    vcyear -format csv all.tsv | head -n 1 | grep -q "^view,hours,dark,undecided,above_0.35,above_0.35.lo"
    vcyear -format jsonl all.tsv | python3 -c "import json, sys; assert json.load(sys.stdin)[\"hours\"] == 12"'
check 'a heat map and a folder for Honeybee' '
    vcyear -plot map.svg -honeybee hb all.tsv > out; vcyear -plot map.png all.tsv > out
    grep -q "</svg>" map.svg; head -c 8 map.png | grep -qa PNG
    [ "$(awk "{ print NF }" hb/views.dgp)" = 9 ]; [ "$(wc -l < hb/sun-up-hours.txt)" = 9 ]
    grep -qx 489.5 hb/sun-up-hours.txt'
check 'without their number pixels are taken as large, without intervals values as exact' '
    cut -f 1-9 all.tsv > some.tsv; cut -f 1-4,7 all.tsv > exact.tsv
    vcyear some.tsv 2>&1 > out | grep -q "^vcyear: warning: some.tsv: no column pixels: pictures count as 64 x 64"
    vcyear exact.tsv 2>&1 > out | grep -q "^vcyear: warning: exact.tsv: no intervals"'
check 'shades that close by glare, of a second table that has these hours' '
    ptrace -w- -hours-apart -vf $office/view.vf -x 24 -y 24 -wea y.wea -frames 9 $office/materials.rad \
        $office/layout.rad $office/blinds.rad 2> said | ptaccum -every x2/8 |
        vcmetrics -W- -metrics Ev,DGPf,DGP.px,DGPf.px,pixels -ci 95 > blinds.tsv
    vcyear -closed blinds.tsv -close .9 all.tsv > rarely; vcyear -closed blinds.tsv -close 0 all.tsv > always
    head -n 5 always | cmp - <(vcyear blinds.tsv)
    grep -qx "shades    open 0.0 %, closed 100.0 % of the hours" always; grep -qx "moves     0, 0 hours in doubt" always
    grep -qx "why       glare 0 in 12 hours" always; [ "$(wc -l < rarely)" = 8 ]'
check_error 'which has to have them' 1 '^vcyear: state closed: has no 0121_[0-9]*, in which shades may have it' '
    sed /0121/d blinds.tsv > some.tsv; vcyear -closed some.tsv -close 0 all.tsv'
check_error 'no table' 1 '^vcyear: no table; vcyear -help lists the options$' 'vcyear'
check_error 'a table of no hours' 1 '^vcyear: t.tsv: has no column sky' '
    printf "frame\tDGP\n1\t.3\n" > t.tsv; vcyear t.tsv'
check_error 'no such view' 1 '^vcyear: -view: no view is called "door"$' 'vcyear -view door all.tsv'
check_error 'a plot of another kind' 1 '^vcyear: map.gif: ' 'vcyear -plot map.gif all.tsv'
