# SPDX-License-Identifier: BSD-3-Clause
# luxpipe-live: the page answers, edits arrive, and whichever program ends, all end and nothing stays behind.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics vcview luxpipe-live python3
cp "$TOP"/examples/scenes/office/* .
mkdir t; export TMPDIR=$PWD/t
scene='-vf view.vf -x 64 -y 64 materials.rad layout.rad sky_day.rad'

begin() { luxpipe-live "$@" $scene > lines 2> said & live=$!; await '[ -s lines ] && [ $(wc -l < lines) -gt 4 ]'; }
await() { for i in $(seq 1200); do eval "$1" && return; sleep .025; done; echo "in vain: $1"; cat said; return 1; }
below() { for child in $(pgrep -P "$1"); do echo "$child $(cat /proc/$child/comm)"; below $child; done | sort -n; }
ended() { await '! kill -0 $live 2> /dev/null'; status=0; wait $live || status=$?; [ -z "$(ls t)" ]; }
ask() { python3 "$TOP/tests/tools/ask.py" "$@"; }  # METHOD PATH [body]

check 'the page knows the FIFO, the scene files and the regions; an edit arrives and is compared' '
    begin; ask GET /facts > facts; grep -q "\"control\":true" facts
    for f in luxpipe.regions materials.rad layout.rad sky_day.rad; do grep -q "\"$f\"" facts; done
    ask POST "/overlay?n=3&version=0" "$(sed s/14/9/ sky_day.rad)"; await "cut -f 3 lines | grep -qx 1"
    head -1 lines | grep -q "^frame.seconds.edit.Ev.Ev.lo.Ev.hi.Ev.d.Ev.d.lo.Ev.d.hi.DGPf"
    kill $live; ended; [ $status = 0 ]; [ ! -e luxpipe.regions ]'
check 'a region that is drawn has a column and stays' '
    begin; ask GET "/file?n=0" > text; [ ! -s luxpipe.regions ]
    echo "desk circle 0 -1 -.5 20" > luxpipe.regions; await "grep -q desk.TAL lines"
    kill $live; ended; grep -q desk luxpipe.regions; rm luxpipe.regions'
# Of the picture: the day has programs of the same names, and which of them began first is a matter of speed.
of_day() { tr "\\0" " " < /proc/$1/cmdline | grep -qE " -w- -frames 9 | -every 1 | -metrics Ev,DGPf -ci 95 "; }
kill_program() {
    for child in $({ echo "$live vcview"; below $live; } | awk -v name=$1 '$2 == name { print $1 }'); do
        of_day $child || { kill -9 $child; return; }
    done
}
seq 4 | sed "s/.*/& 2 .8 0 0 1/" > desk.pts
for signals in KILL "TERM TERM"; do
    check "where vcview is ended by $signals all end, also while nothing is rendered, and those of a plan" '
        begin -points desk.pts; await "below $live | grep -c ptaccum | grep -qx 3"; all=$(below $live | cut -d " " -f 1)
        ask POST /control "preview -vp 2 2 1"; sleep .5; for s in '"$signals"'; do kill -$s $live || :; done
        await "! kill -0 $live 2> /dev/null"; for child in $all; do await "! kill -0 $child 2> /dev/null"; done
        rm -rf luxpipe.regions t/*'
done
for program in ptrace ptaccum vcmetrics; do
    check "where $program is killed it is named and started again with the design; the second time the page stays" '
        begin; ask POST "/overlay?n=3&version=0" "$(sed s/14/9/ sky_day.rad)"; sleep .5
        n=$(cut -f 3 lines | tail -1); kill_program '$program'
        await "grep -q \"'$program' was ended by signal 9: it is started again\" said"
        await "[ \$(cut -f 3 lines | tail -1) -gt $n ]"; ask GET "/overlay?n=3" | grep -q " 9 "
        await "! ask GET /next | grep -aq \"current.:[1-9]\""; kill_program '$program'
        await "ask GET /next | grep -aq \".ended.:[0-9]\""; ask GET "/save?as=hdr" | grep -aq "^#?RADIANCE"
        ask GET "/overlay?n=3" | grep -q " 9 "; n=$(wc -l < lines); ask POST /start
        await "[ \$(wc -l < lines) -gt $((n + 2)) ]"; ask GET /next | not grep -aq ".ended.:[0-9]"
        kill $live; ended; [ $status = 0 ]'
done
data() { grep -oE '<data value="[^"]*"' report | cut -d '"' -f 2; }
check 'a report has the numbers of the line, of an edit that is not saved, too, and says how it is made again' '
    begin -frames 33; sed s/14/9/ sky_day.rad > edited; ask POST "/overlay?n=3&version=0" "$(cat edited)"
    await "tail -1 lines | cut -f 1,3 | tr \"\\t\" \" \" | grep -qx \"32 1\""
    ask GET "/report?picture=1" > report; data > numbers
    for column in 4 5 6 10 11 12; do tail -1 lines | cut -f $column | grep -qxFf numbers; done
    grep -q "sky (sky_glow) through pane" report; grep -q "sky_day.rad: gensky 12 21 9 " report
    hash=$(printf %s "$(cat edited)" | sha256sum | cut -c 1-64)
    grep -q "sky_day.rad (as changed in the page)</td><td>$hash" report
    grep -q "ptrace -frames 33 -vf view.vf -x 64 -y 64 -vta .* -x 64 -y 64 -frames 0:32 materials.rad" report
    not grep -q "<td>low.TAL</td>\|low/high.CR</td>" report  # nobody has drawn them
    not grep -q "$TMPDIR" report; kill $live; ended'
# The commands of a report, as a script.
commands() {
    python3 -c "import html, re, sys
part = re.search(r'<dt>Commands</dt><dd>(.*?)</dd>', open(sys.argv[1]).read(), re.S).group(1)
print('\n'.join(html.unescape(c) for c in re.findall(r'<code>(.*?)</code>', part, re.S)))" "$1"
}
check 'its commands run in another folder, where no region is drawn and nothing was saved, to the same numbers' '
    begin -frames 33 -about "Project: a <test>" -criterion "EN 17037 high: DGPf <= 0.35" -criterion "UGRf <= 19"
    ask POST "/overlay?n=3&version=0" "$(cat edited)"
    await "tail -1 lines | cut -f 1,3 | tr \"\\t\" \" \" | grep -qx \"32 1\""
    ask GET "/report?picture=1" > report; tail -1 lines | cut -f 4,10 > told; kill $live; ended
    grep -q "<dt>Project</dt><dd>a &lt;test&gt;</dd>" report
    grep -q "<td>EN 17037 high</td><td>DGPf at most 0.35</td><td>.*met</td>" report
    grep -q "<td>UGRf</td><td>UGRf at most 19</td><td>not known</td>" report
    commands report > script; grep -qx "cat > sky_day.changed.rad << .END OF TEXT." script
    mkdir copy; cp *.rad *.vf copy; (cd copy; bash -eo pipefail ../script > table 2> said)
    head -n 1 copy/table | tr "\t" "\n" | grep -nE "^(Ev|DGPf)$" | cut -d : -f 1 | paste -sd , > at
    tail -n 1 copy/table | cut -f "$(cat at)" | cmp - told; test -s copy/report.html'
check 'what the programs say is in the page and on the standard error' '
    begin; ask POST "/overlay?n=1&version=0" "broken"; await "grep -q ^ptrace: said"
    await "ask GET /next | grep -aq \"messages.*ptrace: .*current.:[1-9]\""; kill $live; ended'
check 'a scene that cannot be read ends it, and why is said, however soon' '
    for turn in 1 2 3 4 5 6 7 8; do
        status=0; timeout 60 luxpipe-live -vf view.vf missing.rad 2> said || status=$?; [ $status = 1 ]
        grep -q "^ptrace: missing.rad: " said; [ -z "$(ls t)" ]; [ ! -e luxpipe.regions ]
    done'
check 'of a folder of Honeybee the materials are changed and the views offered, the first of which is shown' '
    cp -r "$TOP/examples/exports/honeybee" model; sed s/rvu/"rvu -vp 1 1 1"/ model/view/desk.vf > model/view/other.vf
    scene="-x 16 -y 16 model sky_day.rad"; begin; ask GET /facts > facts
    for f in model/scene/envelope.mat model/aperture/aperture.mat sky_day.rad; do grep -q "\"$f\"" facts; done
    ask GET /next > news; grep -aq "\"places\":..\"desk\",\" -vta -vp 2 3.5 1.2 .*\"other\"," news
    grep -aq "\"views\":.\" -vta -vp 2 3.5 1.2 " news;
    ask POST "/overlay?n=1&version=0" "$(sed "s/^5 0.5/5 0.9/" model/scene/envelope.mat)"
    await "cut -f 3 lines | grep -qx 1"; kill $live; ended'
check '-open gives the browser a file that leads to the page, and the secret to nobody else' '
    mkdir bin; printf "#!/bin/sh\n{ cat \"\$1\"; stat -c %%a \"\$1\"; } > $PWD/opened\n" > bin/xdg-open
    chmod +x bin/xdg-open; before=$PATH; PATH=$PWD/bin:$PATH; begin -open; await "[ \$(wc -l < opened) = 2 ]"
    grep -qF "url=$(grep -o "http://[^ ]*" said)\"" opened; [ "$(tail -1 opened)" = 600 ]
    kill $live; ended; PATH=$before'
check 'where a file of the scene goes away the page says so, and the last good picture stays' '
    begin; mv layout.rad away; await "ask GET /next | grep -aq \"messages.*ptrace: [^,]*layout.rad\""
    ask GET "/save?as=hdr" | grep -aq "^#?RADIANCE"; mv away layout.rad; lines=$(wc -l < lines)
    await "[ \$(wc -l < lines) -gt $((lines + 1)) ]"; kill $live; ended'
check 'a renderer that is stopped stops nothing else, and goes on' '
    begin; pid=$(below $live | awk "\$2 == \"ptrace\" { print \$1 }"); kill -STOP $pid; sleep 1
    ask POST "/overlay?n=3&version=0" "$(sed s/14/9/ sky_day.rad)"; ask GET "/overlay?n=3" | grep -q " 9 "
    kill -CONT $pid; await "cut -f 3 lines | grep -qx 1"; kill $live; ended'
check_error 'no scene' 1 '^luxpipe-live: names no scene' 'luxpipe-live'
check_error 'no value' 1 '^luxpipe-live: -port: needs a value' 'luxpipe-live -port'
check_error 'programs in scenes' 1 '^luxpipe-live: -exec: ' 'luxpipe-live -exec a.rad'
