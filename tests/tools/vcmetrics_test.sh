# SPDX-License-Identifier: BSD-3-Clause
# vcmetrics: lines, stopping, refusals, comparison.
. "${TOP:?}/tests/lib.sh"
needs vcmetrics ptaccum
images=$TOP/tests/golden/glare/images
mkstream=$(command -v mkstream || echo "$BIN/mkstream")
[ -x "$mkstream" ] || skip "no mkstream here"
cp "$images"/office256.hdr "$images"/sunpeak.hdr "$images"/fire128.hdr "$images"/err_*.hdr "$images"/mask128_dark.hdr \
        "$images"/shift.hdr .
$mkstream frames 0 40 64 64 > frames.lux 2> /dev/null

check 'a named file: column file, the same every time' '
    vcmetrics office256.hdr > a && vcmetrics office256.hdr > b && cmp a b &&
    [ "$(head -n 1 a)" = "$(printf "file\tEv\tDGP\tRAMMG")" ] && [ $(wc -l < a) -eq 2 ]'
check 'a stream: columns frame and seconds, one line a picture' '
    ptaccum < frames.lux | vcmetrics > a && head -n 1 a | grep -q "^frame.seconds.Ev.DGP.RAMMG$" &&
        [ $(wc -l < a) -eq 42 ] &&
    [ "$(cut -f 1 a | tail -n 1)" = 40 ]'
check 'several files, patterns too' '
    [ $(vcmetrics office256.hdr sunpeak.hdr | wc -l) -eq 3 ] && [ $(vcmetrics "*256.hdr" | wc -l) -eq 2 ]'
check 'csv and jsonl' '
    vcmetrics -format csv office256.hdr | head -n 1 | grep -q "^file,Ev,DGP,RAMMG$" &&
    vcmetrics -format jsonl office256.hdr | grep -q "^{\"file\": \"office256.hdr\", \"Ev\": [0-9.]*, "'
printf "task circle view 10\nlow rect 40 40 60 60\nhigh rect 120 120 160 160\n" > three.regions
check '-like accelerad: its columns, its contrast ratio' '
    vcmetrics -like accelerad -regions three.regions -cr low/high office256.hdr > a
    [ "$(head -n 1 a)" = "Time,Frame,AvLum,Ev,DGP,RAMMG,TaskLum,HighLum,LowLum,CR" ]
    vcmetrics -metrics task.TAL,high.TAL,low.TAL -regions three.regions office256.hdr | tail -n 1 | cut -f 2- |
        tr "\t" , > b
    grep -q "^0,0,.*,$(cat b)," a && awk -F , "END { d = \$10 * \$9 / \$8; exit !(d > .9999 && d < 1.0001) }" a'
check '-like accelerad without regions: nan in their place' '
    vcmetrics -like accelerad office256.hdr | tail -n 1 | grep -q ",nan,nan,nan,nan$"'
check 'columns as asked for, in that order' '
    [ "$(vcmetrics -metrics UGR,n_sources,Ev office256.hdr | head -n 1)" = "$(printf "file\tUGR\tn_sources\tEv")" ]'
check_error 'an unknown metric is named, and what is meant' 1 '^vcmetrics: -metrics: .*"Dgp"; did you mean DGP[?]$' '
    vcmetrics -metrics Dgp office256.hdr'
check_error 'or all that there are' 1 '^vcmetrics: -metrics: .*"nothing"; there are Ev DGP class' '
    vcmetrics -metrics nothing office256.hdr'
check 'names are separated by commas or blanks' '
    for list in Ev,DGP "Ev, DGP" "Ev DGP"; do vcmetrics -metrics "$list" office256.hdr; done | sort -u > rows
    [ "$(wc -l < rows)" = 2 ]'
for name in desk.mean desk.share300; do
    check_error "$name without regions says what it needs" 1 "^vcmetrics: -metrics: $name needs regions .-regions" "
        vcmetrics -metrics $name office256.hdr"
done
check_error 'a region that is not there' 1 '^vcmetrics: -metrics: desk.mean: there is no region "desk"; there are' '
    vcmetrics -metrics desk.mean -regions three.regions office256.hdr'
check_error 'what a region does not have' 1 '^vcmetrics: -metrics: task.men: a region has TAL, mean, ' '
    vcmetrics -metrics task.men -regions three.regions office256.hdr'
check 'a line for each source; their shares add up' '
    vcmetrics -sources fire128.hdr |
        awk -F "\t" "NR > 1 { s += \$NF; n++ } END { exit !(n > 3 && s > 0.999 && s < 1.001) }"'

check_exit 'a rule that never holds: status 4' 4 'ptaccum < frames.lux | vcmetrics -until "Ev 0.0000001%"'
check 'an interval around each number, narrower and narrower' '
    ptaccum < frames.lux | vcmetrics -metrics Ev -ci 95 -W > ci &&
    head -1 ci | grep -qP "Ev\tEv.lo\tEv.hi\ttails\terrors$" &&
    awk "NR > 4 && !(\$4 <= \$3 && \$3 <= \$5) { bad = 1 } NR == 5 { first = \$5 - \$4 }
        END { exit bad || !(\$5 - \$4 < first) }" ci'
check 'the last row of each picture is the row of a run with all, its interval, too' '
    for seed in 3 4; do
        $mkstream frames 0 9 64 64 $seed 2> err | sed "s/^FRAME=.*/&\\nLASTFRAME=9/"
    done | ptaccum -every x2/8 > sums.lux
    table() { vcmetrics -metrics Ev,DGPf,DGP.px -ci 95 "$@" < sums.lux; }
    table | grep "^9" | cut -f 3- > all
    table -last > last; [ "$(wc -l < last)" = 3 ]; tail -n 2 last | cut -f 3- | cmp - all
    [ "$(ptaccum < frames.lux | vcmetrics -last | wc -l)" = 42 ]'
check_error 'rules need all rows' 1 '^vcmetrics: -last: cannot be used with -until, ' '
    vcmetrics -last -max-frames 4 office256.hdr'
check 'in JSON fields of the same names' '
    ptaccum < frames.lux | vcmetrics -metrics Ev -ci 95 -W -format jsonl | tail -n 1 |
        grep -qE "\"Ev\": [0-9.]+, \"Ev.lo\": [0-9.]+, \"Ev.hi\": [0-9.]+, "'
check 'no intervals of pictures by themselves, of RGBE, of merges, and why' '
    ptaccum -last -ff < frames.lux > one.hdr && ptaccum -fc < frames.lux > rgbe.lux &&
    $mkstream frames 0 2 64 64 7 2> /dev/null | ptaccum -last -ff > other.hdr &&
    ptaccum -ff one.hdr other.hdr > both.hdr &&
    for f in one.hdr rgbe.lux both.hdr; do
        vcmetrics -metrics Ev -ci 95 $f 2>&1 > t | grep -q "no intervals: " &&
            tail -1 t | grep -qP "nan\tnan\t-\t-$" || exit 1
    done'
check 'a file with parts has the intervals that the last line of its stream had' '
    $mkstream frames 0 11 64 64 2> /dev/null | ptaccum -batches 16 -o all.exr -o - |
        vcmetrics -metrics Ev,Lavg -ci 95 -W | tail -1 | cut -f 3- > told &&
    vcmetrics -metrics Ev,Lavg -ci 95 -W all.exr 2> err | tail -1 | cut -f 2- > later &&
    cmp told later && ! grep -q nan later && [ ! -s err ]'
check 'so have shares of several machines, merged' '
    $mkstream frames 0 6 64 64 2> /dev/null | ptaccum -last -batches 8 -o one.exr &&
    $mkstream frames 7 11 64 64 2> /dev/null | ptaccum -last -batches 8 -o two.exr &&
    ptaccum two.exr one.exr -batches 16 -o all.exr &&
    vcmetrics -metrics Ev,Lavg -ci 95 -W all.exr | tail -1 | cut -f 2- > merged &&
    cut -f 1 told | paste - merged | awk "{ exit !((\$1 - \$2) ^ 2 < 1e-8 * \$1 ^ 2 && \$3 < \$1 && \$4 > \$1) }"'
check 'half of all frames in a step is told' '
    ptaccum -every x2 < frames.lux | vcmetrics -ci 95 2>&1 > /dev/null | grep -q "x2/16"'
check 'a rule of widths holds, and says so'      '
    $mkstream frames 0 100 64 64 2> /dev/null | ptaccum | vcmetrics -until "Ev 30%" 2>&1 > a |
        grep -q "stopped after 16 frames: Ev " && [ $(wc -l < a) -lt 80 ]'
check_exit '-max-frames without a rule: status 0' 0 'ptaccum < frames.lux | vcmetrics -max-frames 5'
check '-max-frames counts as ptrace -frames: N pictures, frame 0 among them' '
    [ $(ptaccum < frames.lux | vcmetrics -max-frames 5 2> /dev/null | sed 1d | wc -l) = 5 ]'
check_exit '-max-frames before the rule holds: status 4' 4 '
    ptaccum < frames.lux | vcmetrics -max-frames 5 -until "Ev 1%"'
check_error 'the class is that of DGP'           1 'no column "DGP"' 'vcmetrics -metrics Ev -until class one.hdr'
check_error 'class takes no tolerance' 1 '^vcmetrics: -until: class takes no tol' '
    vcmetrics -until "class 1%" one.hdr'
check_error 'a column without interval is refused' 1 '^vcmetrics: -until: VCP has no interval' '
    vcmetrics -metrics VCP -until "VCP 1" one.hdr'
check 'it prints its value, and nan around it'   '
    ptaccum < frames.lux | vcmetrics -metrics VCPu,n_sources,Lmed -ci 95 -W | tail -1 | cut -f 3- |
        grep -qP "^[0-9.e+-]+\tnan\tnan\t[0-9]+\tnan\tnan\t[0-9.e+]+\tnan\tnan\t"'
wide='-vta -vh 180 -vv 180' narrow='-vtv -vh 60 -vv 60'
check 'a view that shows a part of what reaches the eye is told of, once, where that matters' '
    vcmetrics $narrow one.hdr one.hdr 2> said > t; [ "$(wc -l < said)" = 1 ]
    grep -q "^vcmetrics: warning: one.hdr: Ev and DGP are of this narrow view; -vta -vh 180 -vv 180 has all" said'
check 'not of a whole one, of regions, with the Ev of a meter, or as evalglare' '
    echo "a circle view 10" > one.regions
    vcmetrics $wide one.hdr 2> said > t; vcmetrics $narrow -regions one.regions -metrics TAL,RAMMG one.hdr 2>> said > t
    vcmetrics $narrow -i 500 one.hdr 2>> said > t
    vcmetrics $narrow -like evalglare one.hdr 2>> said > t; [ ! -s said ]'
check 'a list of metrics may have blanks' '
    vcmetrics -metrics "Ev, DGP" one.hdr > t && vcmetrics -metrics Ev,DGP one.hdr | cmp - t'
check_error 'regions without a name'             1 '^vcmetrics: -regions: the name is empty' '
    vcmetrics -regions "" one.hdr'
check 'a picture of irradiance is told from one of luminance, once' '
    for i in "-i" "-i -i-"; do printf "#?RADIANCE\n/usr/bin/rpict -vta $i a.oct\n"; tail -n +2 one.hdr; done > two.hdr
    vcmetrics -metrics Ev < two.hdr 2> said > t; [ "$(grep -c "stdin: shows irradiance (-i)" said)" = 1 ]
    [ $(wc -l < t) = 3 ]'
on_terminal() {
    python3 -c "import pty, sys; sys.exit(pty.spawn(sys.argv[1:]) >> 8)" "$@" < /dev/null | tr -d "\r" | sed "s/^.\[K//"
}
if python3 -c "import pty" 2> /dev/null; then
    check 'on a terminal: aligned columns, with the digits that an interval leaves meaning; in a pipe all of them' '
        ptaccum < frames.lux > sums.lux 2> w; vcmetrics -W- -metrics Ev,class -ci 95 < sums.lux | tail -n 1 > piped
        on_terminal bash -c "vcmetrics -W- -metrics Ev,class -ci 95 < sums.lux" > shown
        head -n 1 shown | grep -qx " *frame *seconds  *Ev  *class  *tails *"
        [ "$(awk "{ print length }" shown | sort -u | wc -l)" = 1 ]
        awk "{ printf \"%.1f %.1f\\n\", \$3, (\$5 - \$4) / 2 }" piped > rounded
        tail -n 1 shown | awk "{ print \$3, \$5 }" | diff rounded -
        on_terminal vcmetrics -W- -metrics Ev,DGP -format csv one.hdr > shown
        vcmetrics -W- -metrics Ev,DGP -format csv one.hdr | diff shown -'
fi
check_error 'an empty rule is none'              1 '^vcmetrics: -until: the rule is empty' 'vcmetrics -until "" one.hdr'
check_error 'no columns'                         1 '^vcmetrics: -metrics: .*no column' 'vcmetrics -metrics , one.hdr'
check 'an input that ends too early says so' '
    { ptaccum < frames.lux | vcmetrics -until "Ev 0.0000001%" > a 2> said || [ $? -eq 4 ]; } &&
    grep -q "^vcmetrics: the input ended after 40 frames: -until does not hold$" said'
check 'jsonl of a name that is no UTF-8' '
    cp one.hdr "$(printf "a\377b.hdr")" && vcmetrics -format jsonl a?b.hdr | grep -q "^{\"file\": \"a?b.hdr\", "'
check_error 'a rule needs its column' 1 '^vcmetrics: -until: .*"UGR" in this .* has Ev, DGP; -metrics adds it$' '
    vcmetrics -until "UGR 1%" office256.hdr'
check_error 'whose name is known' 1 '^vcmetrics: -until: .*"DGPP".* has Ev, DGP; did you mean DGP[?]$' '
    vcmetrics -until "DGPP .01" office256.hdr'
check_error 'a single frame is refused with a word about ptaccum' 1 '^vcmetrics: stdin.*ptaccum' '
    $mkstream frames 3 3 32 32 | vcmetrics'
check_error 'a view beside the picture' 1 '^vcmetrics: stdin: no pixel' \
    '$mkstream frames 0 0 16 16 1 "VIEW= -vta -vh 180 -vv 180 -vl 1e18" | vcmetrics'
check 'pixels beyond any light are as black as those that are no number' '
    $mkstream frames 0 0 16 16 1 "VIEW= -vta -vh 180 -vv 180" > bright.hdr
    { head -c -4 bright.hdr; printf "\377\377\177\177"; } | vcmetrics -metrics not_finite,Ev,RAMMG 2> err > bright
    ! grep -qE "inf|nan" bright'
check_error 'no view' 1 '^vcmetrics: err_noview.hdr: .*no view' 'vcmetrics err_noview.hdr'
check 'a view given takes its place' 'vcmetrics -vta -vh 180 -vv 180 -vd 0 1 0 err_noview.hdr'
check_error 'a view given must be whole' 1 '^vcmetrics: view: .*-vt, -vh and -vv' 'vcmetrics -vta -vh 150 office256.hdr'
check_error 'a parallel view' 1 '^vcmetrics: err_par.hdr: .*parallel' 'vcmetrics err_par.hdr'
check_error 'a tabbed exposure' 1 '^vcmetrics: err_tabexp.hdr: .*tab' 'vcmetrics err_tabexp.hdr'
check_error 'black corners of a perspective view' 1 '^vcmetrics: err_corners.hdr: .*black' 'vcmetrics err_corners.hdr'
check 'which -f overrules' 'vcmetrics -f err_corners.hdr'
check 'frames of ours say their view: the corners of a room are black in frame 0' '
    v="VIEW= -vtv -vh 60 -vv 60"
    $mkstream frames 0 2 16 16 1 "$v" 2> err | python3 -c "
import sys
stream, pixels = sys.stdin.buffer.read(), 16 * 16 * 3 * 4
for frame in stream.split(b\"#?RADIANCE\\n\")[1:]:  # black in frame 0
    head = frame[:frame.index(b\"\\n\\n\")]
    black = b\"\\nFRAME=0\\n\" in head + b\"\\n\" and len(frame) > pixels
    sys.stdout.buffer.write(b\"#?RADIANCE\\n\" + (frame[:-pixels] + bytes(pixels) if black else frame))" > dark.lux
    ptaccum < dark.lux | vcmetrics -metrics Ev > rows; [ "$(wc -l < rows)" = 4 ]
    [ "$(sed -n 2p rows | cut -f 3)" = 0 ]'
check 'patches of it: evalglare says nothing of corners' '
    not vcmetrics -like evalglare -z 20 1 err_corners.hdr > out 2> said; test ! -s out; grep -q "need an angular" said'
even() {  # 15 x 15 pixels of one luminance, seen in this direction
    printf '#?RADIANCE\nVIEW= -vta -vd %s -vh 180 -vv 180\nFORMAT=32-bit_rle_rgbe\n\n-Y 15 +X 15\n' "$1"
    printf '\200\200\200\202%.0s' $(seq 225)
}
check 'the line of sight has a position index of 16 where rounding carries its cosine above 1, as in evalglare' '
    even ".1479 -.9738 -.5665" > even.hdr; vcmetrics -like evalglare -d even.hdr | grep -q " 105.663576 "'
black() { printf '#?RADIANCE\n%sFORMAT=32-bit_rle_rgbe\n\n-Y 9 +X 9\n' "$1"; head -c 324 /dev/zero; }
check 'a picture without light is told as such, once a cause, and no other' '
    black "VIEW= -vta -vh 180 -vv 180
" > black.hdr; cp black.hdr again.hdr; vcmetrics black.hdr office256.hdr again.hdr 2> said > rows
    [ "$(grep -c "the picture is black: it is night, the eye is in a solid" said)" = 2 ]
    grep -q "^vcmetrics: warning: black.hdr: " said; grep -q "(2 times)$" said; ! grep -q office said'
check_error 'a picture cut short' 1 '^vcmetrics: err_short.hdr: ' 'vcmetrics err_short.hdr > /dev/null'
check_error 'a file that is not there' 2 '^vcmetrics: nothere.hdr: ' 'vcmetrics nothere.hdr'
check_error 'a full disc' 2 '^vcmetrics: ' 'vcmetrics office256.hdr > /dev/full'
check_error 'what rewrites pictures is not here' 1 '^vcmetrics: -m: ' 'vcmetrics -m out.hdr office256.hdr'
check '-c: a grey picture with coloured sources, which has the same metrics' '
    vcmetrics -c check.exr -metrics Ev,DGP,n_sources fire128.hdr > a; vcmetrics -metrics Ev,DGP,n_sources check.exr > b
    vcmetrics -difference -tolerance "all 0.01%" a b; ptaccum -ff check.exr | strings > s; grep -q "^VIEW= -vta" s
    vcmetrics -c plain.exr -b 1e9 fire128.hdr; ! cmp check.exr plain.exr'
# Programs that call evalglare, with their own words; each reads its line in its own way.
mkdir as_evalglare && printf '#!/bin/sh\nexec vcmetrics -like evalglare "$@"\n' > as_evalglare/evalglare
chmod +x as_evalglare/evalglare && echo 'rvu -vth -vp 0 0 0 -vd 0 1 0 -vu 0 0 1 -vh 180 -vv 180' > their.vf
check 'Honeybee calls it so: a view for a picture without one, a check picture, a task; numbers follow a colon' '
    PATH=$PWD/as_evalglare:$PATH
    evalglare -c check_hdr.hdr -vth -vv 180 -vh 180 err_noview.hdr > said; test -s check_hdr.hdr
    [ "$(sed "s/.*: *//" said | wc -w)" = 6 ]; [ "$(sed "s/:.*//" said)" = dgp,dgi,ugr,vcp,cgi,Lveil ]
    evalglare -c task.hdr -T 60 60 0.349 fire128.hdr > said; test -s task.hdr; sed "s/.*: *//" said | grep -q "^0[.]"
    evalglare -c c1.HDR -T 60 60 .5 -b 5 -d fire128.hdr; test -s c1.HDR'
check 'VI-Suite so: the picture on the standard input, a colour, a view file; numbers are words 7 to 12' '
    PATH=$PWD/as_evalglare:$PATH
    evalglare -u 1.0 0.0 0.0 -c "glare-0.hdr" < fire128.hdr > said; ptaccum -ff glare-0.hdr > /dev/null
    tr , " " < said | cut -d " " -f 7-12 | grep -qxE "([0-9.]+ ?){6}"
    evalglare -u 1.0 0.0 0.0 -vf their.vf -c "glare-1.hdr" < err_noview.hdr | grep -q "^dgp,"; test -s glare-1.hdr
    evalglare -c "glare-2.hdr" < fire128.hdr > said; test -s glare-2.hdr'
if command -v evalglare > /dev/null && command -v pvalue > /dev/null; then
    for options in '' '-u .2 .3 .5' '-T 60 60 .5 -b 5' '-L 60 60 .6 1.2' '-s -b 3'; do
        check "the check picture is evalglare's, byte for byte: $options" '
            evalglare $options -c theirs.hdr fire128.hdr > t 2> said;
            vcmetrics -like evalglare $options -c ours.hdr fire128.hdr > o
            cmp t o; pvalue -h -H -d theirs.hdr > t; pvalue -h -H -d ours.hdr > o; cmp t o'
    done
fi
check_error 'a colour must be one' 1 '^vcmetrics: -u: ' 'vcmetrics -u 0 0 0 -c x.hdr fire128.hdr'
check_error 'the ending chooses the format' 1 '^vcmetrics: x.txt: ' 'vcmetrics -c x.txt fire128.hdr'
check_error 'a mask of another size' 1 '^vcmetrics: mask128_dark.hdr: the mask has 128 x 128' '
    vcmetrics -A mask128_dark.hdr office256.hdr > /dev/null'
check_error 'the task lies in the picture' 1 '^vcmetrics: -t: ' 'vcmetrics -t 256 0 0.4 office256.hdr'

check_exit 'evalglare -V has status 1' 1 'vcmetrics -V office256.hdr'
check 'and its default line two blanks at the end' '
    vcmetrics -like evalglare office256.hdr | grep -q "^dgp,dgi,ugr,vcp,cgi,Lveil: 0.4216.*  $"'
check_error 'mirrored solid angles come with a warning' 0 'warning: .*mirrored' 'vcmetrics -like evalglare shift.hdr'

compare() { vcmetrics -difference -tolerance default "$@"; }
check 'a picture compares with its own record' '
    vcmetrics office256.hdr > rec.tsv && compare rec.tsv office256.hdr'
check 'and with recorded lines of evalglare' '
    vcmetrics -d office256.hdr > rec.txt && compare rec.txt office256.hdr'
check 'its older name -compare goes on, and says so once' '
    vcmetrics -compare rec.txt office256.hdr 2> said | diff - <(compare rec.txt office256.hdr)
    [ $(wc -l < said) = 1 ]; grep -q "^vcmetrics: warning: -compare: is called -difference -tolerance default, " said
    vcmetrics -help | grep -e -compare && return 1; true'
check 'without a tolerance: the differences, of which a record has no interval' '
    vcmetrics -difference rec.tsv office256.hdr | awk "NR > 1 && !(\$5 ^ 2 <= 1e-6 && \$6 == \"nan\") { exit 1 }"'
check_exit 'out of tolerance: status 5' 5 'compare office256.hdr sunpeak.hdr'
check 'unless the tolerance is wide' '
    printf "all 100000%% # wide\n\nDGP 2\n" > tol &&
        vcmetrics -difference -tolerance tol -metrics Ev,DGP office256.hdr sunpeak.hdr'
check 'the output of another run too: two streams' '
    ptaccum < frames.lux > a.lux && compare a.lux a.lux > t && ! grep -q "no$" t'
check_error 'a row too few' 1 '^vcmetrics: b.lux: has no row for frame 0 of a.lux$' '
    ptaccum -last < frames.lux > b.lux && compare -W- a.lux b.lux'
check_error 'a metric too few' 1 'lacks the metric' '
    vcmetrics -metrics Ev,DGP office256.hdr > r1 && vcmetrics -metrics Ev office256.hdr > r2 &&
        compare r1 r2'
check '-metrics chooses what of a table is compared' '
    vcmetrics -metrics Ev,DGP office256.hdr > r1; sed "2s/\t[0-9.]*$/\t.5/" r1 > dgp;
    sed "2s/\t[0-9.]*\t/\t9\t/" r1 > ev
    compare -metrics DGP ev office256.hdr; compare -metrics DGP ev r1
    ! compare -metrics DGP dgp office256.hdr && ! compare -metrics DGP dgp r1'
check_error 'of which it must have them' 1 '^vcmetrics: r1: lacks the metric UGR of -metrics$' '
    compare -metrics UGR r1 office256.hdr'
check_error 'a tolerance for an unknown metric is a typing error' 1 \
    '^vcmetrics: -tolerance: .*"DPG" here; did you mean DGP[?]$' '
    vcmetrics -difference -tolerance "DPG .01" r1 office256.hdr'
check 'one for a metric that is not compared is not' 'vcmetrics -difference -tolerance "UGR 1%" r1 office256.hdr'
check_error 'a bad tolerance is reported with its option' 1 '^vcmetrics: -tolerance: "DGP x"' '
    vcmetrics -difference -tolerance "DGP x" r1 r1'
check_error 'or by the line of its file' 1 '^vcmetrics: tol:2: "DGP"' '
    printf "Ev 1%%\nDGP\n" > tol; vcmetrics -difference -tolerance tol r1 r1'
mkdir -p elsewhere && cp office256.hdr sunpeak.hdr elsewhere
check 'rows are paired by the picture, wherever it lay' '
    for f in tsv csv jsonl; do
        vcmetrics -format $f office256.hdr sunpeak.hdr > one;
        vcmetrics -format $f elsewhere/sunpeak.hdr elsewhere/office256.hdr > two
        compare one two > t; grep -q "^sunpeak.hdr.Ev" t; done'
check_error 'and one that is missing is named' 1 '^vcmetrics: two: has no row for file sunpeak.hdr of one$' '
    vcmetrics office256.hdr sunpeak.hdr > one; vcmetrics office256.hdr > two; compare one two'
check 'rows of a stream are paired by their frame' '
    ptaccum < frames.lux | vcmetrics > one; { head -n 1 one; tail -n +2 one | tac; } > two;
    compare one two > t
    grep -q "^40.Ev" t; ptaccum < frames.lux > a.lux; compare two a.lux'
check 'intervals are compared, too, in tables and in JSON' '
    ptaccum < frames.lux > a.lux; vcmetrics -W -metrics Ev,DGP,class -ci 95 a.lux > one
    vcmetrics -W -metrics Ev,DGP,class -ci 95 -format jsonl a.lux > two
    compare one two > t; grep -q "Ev.lo" t; grep -q "DGP.hi" t; ! grep -q tails t'
check 'of one picture a side the names may differ' '
    cp office256.hdr new.hdr; vcmetrics new.hdr > two; compare r1 office256.hdr &&
        vcmetrics -metrics Ev,DGP new.hdr > two && compare r1 two'

# Glare sources drawn
check 'without a source there are the names of its columns alone' '
    vcmetrics -b 1e9 -sources office256.hdr > none; vcmetrics -sources office256.hdr | head -n 1 | cmp - none'
check 'outlines are added to the sources, and change nothing else' '
    vcmetrics -sources -format jsonl sunpeak.hdr > one
    vcmetrics -sources -outlines -format jsonl sunpeak.hdr > two; [ -s one ]; not grep -v "\"outline\": \[\[" two
    sed "s/, \"outline\": .*/}/" two | cmp - one'
check_error 'outlines are JSON' 1 '^vcmetrics: -outlines: belongs to -sources and -format jsonl$' '
    vcmetrics -sources -outlines sunpeak.hdr'
check 'the drawing has the same bytes each time, and does not touch the numbers' '
    vcmetrics sunpeak.hdr > one; vcmetrics -over a.png sunpeak.hdr > two; vcmetrics -over b.png sunpeak.hdr > two
    cmp one two; cmp a.png b.png; head -c 4 a.png | grep -aq PNG'
check 'a picture without its sources is drawn otherwise' '
    vcmetrics -b 1e9 -over c.png sunpeak.hdr > two; ! cmp -s a.png c.png'
check_error 'the drawing is a PNG file' 1 '^vcmetrics: -over: writes a .png' 'vcmetrics -over a.hdr sunpeak.hdr'
