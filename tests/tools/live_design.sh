# SPDX-License-Identifier: BSD-3-Clause
# luxpipe-live -design: what is changed in the page is in a file, outlives the programs and is opened again; a full
# disk is said and nothing is lost.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics vcview luxpipe-live python3
cp "$TOP"/examples/scenes/office/* .
mkdir t; export TMPDIR=$PWD/t
scene='-vf view.vf -x 48 -y 48 -seed 5 materials.rad layout.rad blind.rad sky_day.rad'

begin() {
    : > lines
    luxpipe-live -design my.design -regions r.txt -metrics Ev,DGPf $scene "$@" > lines 2> said & live=$!
    await '[ $(wc -l < lines) -gt 4 ]'
}
await() {
    for i in $(seq 600); do eval "$1" && return; sleep .025; done
    echo "in vain: $1"; cat said my.design; return 1
}
end() { kill "$@" $live; status=0; wait $live || status=$?; }
edited() { await "tail -1 lines | cut -f 3 | grep -qx $1"; }
ask() { python3 "$TOP/tests/tools/ask.py" "$@"; }  # METHOD PATH [body]
set_text() { ask POST "/overlay?n=$1&version=$2&said=$3" "$4" > /dev/null; }

check 'a design is written as a text that a person reads' '
    begin; set_text 3 0 "more+slats" "$(sed "s/-a 20/-a 31/" blind.rad)"; edited 1
    ask POST /control "view -vp 2 2.5 1.2" > /dev/null; edited 2
   echo "desk circle 0 -1 -.5 20" > r.txt
    await "grep -q desk my.design"
    grep -A1 "^edits" my.design | grep -qx "	more slats"; grep -q "^	view" my.design
    grep -q "^VIEW= .*-vp 2 2.5 1.2" my.design; grep -qx "text blind.rad" my.design; grep -q "^	.*-a 31" my.design
    end; [ $status = 0 ]; grep -q "a 20" blind.rad'
cp my.design before.design
sed -n '/^text blind.rad/,/^[^\t]/p' my.design | sed -n 's/^\t//p' > want.rad
check 'opened again it is rendered as in a batch run of its model' '
    rm r.txt; begin; edited 1
    [ "$(cat r.txt)" = "desk circle 0 -1 -.5 20" ]; await "[ \$(tail -1 lines | cut -f 1) -ge 4 ]"
    ask GET "/overlay?n=3" | grep -q -- "-a 31"; ask GET "/next" > state; grep -aq "\"more slats\"" state; end
    awk "\$3 == 1 && \$1 == 4" lines | cut -f 4 > live.Ev
    ptrace -vf my.design -x 48 -y 48 -seed 5 -frames 0:4 materials.rad layout.rad want.rad sky_day.rad |
        ptaccum -every 1 | vcmetrics -metrics Ev | tail -1 | cut -f 3 > batch.Ev
    cmp live.Ev batch.Ev'
check 'and is the same file afterwards' 'cmp before.design my.design'
check 'after kill -9 of all programs nothing is lost' '
    begin; edited 1; set_text 3 1 33+slats "$(sed "s/-a 20/-a 33/" blind.rad)"; await "grep -qx \"	33 slats\" my.design"
    kill -9 $(pgrep -P $live); end -9; begin; edited 1; ask GET "/overlay?n=3" | grep -q -- "-a 33"
    grep -qx "	33 slats" my.design; end'
check 'a full disk is said once; the design is kept, and written where there is room again' '
    begin; edited 1; cp my.design kept; ln -sf /dev/full my.design
    set_text 3 1 34+slats "$(sed "s/-a 20/-a 34/" blind.rad)"
    await "ask GET /next | grep -aq \"my.design: cannot be written: No space left\""; sleep 1
    [ "$(ask GET /next | grep -ao "\"messages\":.*" | grep -ao "No space left" | wc -l)" = 1 ]
    ask GET "/overlay?n=3" | grep -q -- "-a 34"
    notices() { ask GET /next | grep -ao "\"notices\":.*\"messages\":" > notices; }; notices; grep -q written notices
    mv kept my.design; await "grep -q -- \"-a 34\" my.design"; await "notices && ! grep -q written notices"; end'
check 'variants are in the design, and any is the base, by its name' '
    begin; edited 1; ask POST "/variant?do=keep&name=dark" > /dev/null
    await "grep -A1 ^variant.dark my.design | grep -q \"	Ev [0-9.]* ([0-9.]* to\""
    set_text 3 1 light "$(sed "s/-a 20/-a 5/" blind.rad)"; edited 2; ask POST "/variant?do=keep&name=light" > /dev/null
    await "grep -q ^variant.light my.design"; end; begin -against light; edited 1
    ask GET /next > state; grep -aq "\"base\":\"light\"" state; grep -aq "\"name\":\"light\",\"edit\":[01]" state
    ask POST "/variant?do=show&name=dark" > /dev/null; edited 2
    await "tail -1 lines | cut -f 7 | grep -q [0-9]"; difference=$(tail -1 lines | cut -f 7)
    awk "BEGIN { exit !($difference < 0) }"; end
    grep -A1 "^variant dark" my.design | grep -q "	Ev [0-9.]* ([0-9.]* to"'
check 'texts without an end of the last line, empty lines and tabs stay as they are' '
    begin; edited 1; printf "%s\n\n\t# a tab\n\n# no end" "$(cat blind.rad)" > want
    set_text 3 1 odd "$(cat want)"; await "grep -q \"# no end\" my.design"; end; begin; edited 1
    ask GET "/overlay?n=3" | head -c -1 | cmp - want; end'
# Two windows by turns, which hold what they were told last and reload at random: after each edit text and numbers are
# those of a batch run of the model.  200 edits: TRIES=200.
check 'whatever two windows do, text and numbers belong to one model' '
    rm my.design; begin; RANDOM=7; edits=0 now=0 known=(0 0)
    for k in $(seq ${TRIES:-12}); do
        slats=$((1 + RANDOM % 40)) w=$((RANDOM % 2)); [ $((RANDOM % 3)) = 0 ] || known[w]=$now
        sed "s/-a 20/-a $slats/" blind.rad > typed.rad
        status=0; set_text 3 ${known[w]} s$k "$(cat typed.rad)" 2> /dev/null || status=$?
        if [ ${known[w]} != $now ]; then [ $status != 0 ]; continue; fi
        [ $status = 0 ]; now=$((now + 1)); known[w]=$now
        ask GET "/overlay?n=3" > text; grep -q -- "-a $slats " text; cmp -s typed.rad model.rad && continue
        cp typed.rad model.rad; edits=$((edits + 1)); await "grep -q \"^4	[^	]*	$edits	\" lines"
        ptrace -w- -vf view.vf -x 48 -y 48 -seed 5 -frames 0:4 materials.rad layout.rad model.rad sky_day.rad |
            ptaccum -every 1 | vcmetrics -metrics Ev,DGPf | tail -1 | cut -f 3-4 > batch
        grep "^4	[^	]*	$edits	" lines | cut -f 4,10 | cmp - batch
    done; end; [ $edits -gt 2 ]'
check_error 'no design' 1 '^vcview: bad.design: line 2: "rubbish" is no part of a design$' '
    printf "# x\nrubbish\n" > bad.design; vcview -design bad.design < /dev/null'
check_error 'a design of another scene' 1 '^vcview: bad.design: line 1: x.rad is not among the files' '
    printf "text x.rad\n\tvoid\n" > bad.design; vcview -design bad.design < /dev/null'
