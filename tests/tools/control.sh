# SPDX-License-Identifier: BSD-3-Clause
# ptrace is told over a FIFO what to do while it renders; vcmetrics ends each picture of a stream by itself.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics mkstream
office=$TOP/examples/scenes/office
scene="$office/materials.rad $office/layout.rad $office/sky_1400.rad"
desk='-vta -vp 2 2.7 1.2 -vd 0 -1 -.08 -vu 0 0 1 -vh 180 -vv 180'
printf 'VIEW= desk %s\nVIEW= door %s\nVIEW= up %s\n' "$desk" "-vta -vp 3.2 5 1.6 -vd -.4 -1 -.1" \
    "-vta -vp 2 2 1 -vd 0 -1 .4" > all.vf
render() { ptrace -w- -x 24 -y 24 -moments- -control ctl "$@" $scene; }
mkfifo ctl

check 'views end one by one when each is certain enough, and so does the pipe' '
    render -views all.vf | ptaccum -every 16 |
        timeout 100 vcmetrics -control ctl -metrics Ev -until "Ev 20%" > t 2> said
    [ "$(cut -f 3 t | uniq | tr "\n" " ")" = "view desk door up " ]
    [ $(grep -c "^vcmetrics: .*: stopped after [0-9]* frames: .*Ev" said) = 3 ]
    [ "$(cut -f 1 t | sort -n | tail -1)" -ge 16 ]'
check_exit 'status 4 where the rule did not hold for each, which says for which' 4 '
    render -frames 70 -views all.vf | ptaccum -every 16 |
        timeout 100 vcmetrics -control ctl -metrics Ev -until "Ev 0.01%" > t 2> said || status=$?
    [ "$(sed -n "s/ ended.*//p" said | tr "\n" ,)" = "vcmetrics: desk,vcmetrics: door,vcmetrics: up," ]; exit $status'
check 'a sensor in the dark and one that sees the sky alone have no noise, and hold up nothing' '
    printf "void glow g 0 0 4 1 1 1 0 g source sky 0 0 4 0 0 1 360 void plastic black 0 0 5 0 0 0 0 0\n" > plain.rad
    echo "!genbox black box 1 1 1 | xform -t -5 -5 -5" >> plain.rad
    { echo "VIEW= sky -vta -vp 0 0 0 -vd 0 1 0 -vh 180 -vv 180"; echo "VIEW= dark -vp -4.5 -4.5 -4.5"
      echo "VIEW= up -vp 0 0 0 -vd 0 .5 1"; } > plain.vf
    ptrace -w- -x 24 -y 24 -control ctl -views plain.vf plain.rad | ptaccum |
        timeout 100 vcmetrics -control ctl -metrics Ev -ci 95 -until "Ev 1%" > t
    [ "$(awk "\$1 == 16 && \$5 == \$6 && \$6 == \$7 { print \$3 }" t | tr "\n" " ")" = "sky dark up " ]
    [ "$(cut -f 1 t | sort -n | tail -1)" -lt 100 ]'
check '-max-frames is of each picture, too' '
    render -views all.vf | ptaccum | timeout 100 vcmetrics -control ctl -metrics Ev -max-frames 4 > t 2> said
    is=$(cut -f 1,3 t | tr "\t\n" "_ ")
    [ "$is" = "frame_view 0_desk 1_desk 2_desk 3_desk 0_door 1_door 2_door 3_door 0_up 1_up 2_up 3_up " ]'
printf '2 1 .8 0 0 1\n2 5 .8 0 0 1\n' > desk.pts
points() {
    ptrace -w- -control ctl -points desk.pts -sky $office/sky_0900.rad -sky $office/sky_1400.rad "$@" \
        $office/materials.rad $office/layout.rad | ptaccum
}
check 'skies of a grid of points end one by one, too, and each has its points' '
    points | timeout 100 vcmetrics -control ctl -metrics desk.mean -until "desk.mean 20%" > t 2> said
    [ "$(cut -f 3 t | uniq | tr "\n" " ")" = "sky sky_0900 sky_1400 " ]
    [ $(grep -c "^vcmetrics: sky_.*: stopped after [0-9]* frames: -until holds" said) = 2 ]
    points | timeout 100 vcmetrics -control ctl -each -max-frames 4 > t
    [ "$(cut -f 1,3 t | tr "\t\n" "_ ")" = "sky_point sky_0900_0 sky_0900_1 sky_1400_0 sky_1400_1 " ]'
check_exit 'and status 4 says that the rule did not hold for one of them' 4 '
    points -frames 5 | timeout 100 vcmetrics -control ctl -metrics desk.mean -until "desk.mean 20%" > t 2> said'
check 'frames are those of a run without it, and LASTFRAME= says which is the last' '
    render $desk | { head -c 100; echo next > ctl; cat > rest; } > start; cat start rest > with.str
    last=$(grep -a ^LASTFRAME= with.str | tail -1); last=${last#*=}
    ptrace -w- -x 24 -y 24 -moments- -frames $((last + 1)) $desk $scene | ptaccum -last -o alone.exr
    ptaccum -last -o with.exr < with.str
    [ "$(mkstream differ alone.exr with.exr)" = 0 ]'
check 'next of another picture is passed over; pause holds until go' '
    : > live.str
    (echo next door; echo pause; sleep 1; for k in 1 2; do wc -c < live.str > held$k; sleep .2; done; echo go) > ctl &
    render -frames 400 -views all.vf > live.str; cmp held1 held2; [ $(cat held1) -lt $(wc -c < live.str) ]
    ptaccum -last < live.str | vcmetrics -metrics Ev | cut -f 1,3 | tr "\t\n" "_ " > is
    [ "$(cat is)" = "frame_view 399_desk 399_door 399_up " ]'
check 'what is seen, through a pane, with material, places and numbers; "what" is no edit' '
    printf "void plastic grey 0 0 5 .5 .5 .5 0 0\nvoid glass pane 0 0 3 .9 .9 .9\nvoid glow g 0 0 4 1 1 1 0\n" > see.rad
    printf "\npane polygon window 0 0 12 -1 1 -1 1 1 -1 1 1 1 -1 1 1\ngrey sphere ball 0 0 4 .5 2 0 .3\n" >> see.rad
    printf "g source sky 0 0 4 0 0 1 180\ng source ground 0 0 4 0 0 -1 180\n" >> see.rad
    (echo what .75 .5; echo what .2 .6; echo view -vp 0 1.5 0; echo what .98 .5; echo what 1
        sleep 1; echo next) > ctl &
    ptrace -w- -x 24 -y 24 -moments- -control ctl -vp 0 0 0 -vd 0 1 0 -vh 60 -vv 60 see.rad 2> said | ptaccum > x.str
    grep ^ptrace said > all; cut -f 2 all | head -3 | tr "\n" " " > is
    [ "$(cat is)" = "0 0 1 " ]
    w="window	polygon	see.rad:5	pane	glass	see.rad:2	[-. 0-9]*	-1 1 -1 1 1 -1 1 1 1 -1 1 1"
    ball="ball	sphere	see.rad:6	grey	plastic	see.rad:1	[-. 0-9]*	0.5 2 0 0.3"
    sed -n 1p all | grep -q "^ptrace: what .75 .5	0	$w	$ball\$"
    sed -n 2p all | grep -q "^ptrace: what .2 .6	0	$w	sky	source	see.rad:7	g	glow	see.rad:3	[-. 0-9]*	0 0 1 180\$"
    sed -n 3p all | grep -q "^ptrace: what .98 .5	1	ball	"
    sed -n 4p all | grep -q "^ptrace: ctl: what: needs two fractions"'
check 'of a mesh the group and the material of the face, of an octree the surface in it; panes are rectangles' '
    printf "v -2 3 -1\nv 2 3 -1\nv 2 3 0\nv -2 3 0\nv 0 3 2\nv -2 3 2\nv 2 3 2\n" > room.obj
    printf "g The wall\nusemtl White paint\nf 1 2 3 4\no Window\nusemtl pane\nf 4 3 7\nf 4 7 6\n" >> room.obj
    sed -n "1s/grey/\"White paint\"/p; 2p" see.rad > room.rad
    printf "void plastic slat 0 0 5 .5 .5 .5 0 0\nvoid mesh room 1 room.obj 0 0\n" >> room.rad
    echo "!genbox slat blind 1.8 .02 .02 | xform -t -1.8 2.5 .1 -a 10 -t 0 0 .1" >> room.rad
    printf "void plastic red 0 0 5 .5 0 0 0 0\nred sphere ball 0 0 4 0 0 0 .3\n" > ball.rad
    echo "void instance chair 5 ball.rad -t 1 2 0 0 0" >> room.rad
    grep " g " see.rad >> room.rad; grep "^g " see.rad >> room.rad
    (echo what .5 .3; echo what .55 .8; echo what .3 .6074; echo what .93 .5; sleep 1; echo next) > ctl &
    ptrace -w- -x 24 -y 24 -moments- -control ctl -vp 0 0 0 -vd 0 1 0 -vh 60 -vv 60 room.rad 2> said | ptaccum > x.str
    grep "^ptrace: what" said | cut -f 3- |  # without the points
        awk "BEGIN { FS = \"\t\" } { for (i = 1; i <= NF; i++) if (i % 8 != 7) printf \"%s|\", \$i; print \"\" }" > all
    glass="Window|mesh|room.obj:11|pane|glass|room.rad:2|-2 3 0 2 3 0 2 3 2 -2 3 2|"
    { echo "The wall|mesh|room.obj:8|White paint|plastic|room.rad:1||"
      echo "${glass}sky|source|room.rad:8|g|glow|room.rad:7|0 0 1 180|"
      slat="0 2.5 0.3 0 2.5 0.32 -1.8 2.5 0.32 -1.8 2.5 0.3"
      echo "a2.blind.1540|polygon|room.rad:5|slat|plastic|room.rad:3|$slat|$glass"
      echo "ball|sphere|ball.rad:2|red|plastic|ball.rad:1||"; } > want
    diff want all'
# A blind of a million slats, which take a minute to read: six polygons each.
cp $office/*.rad .; sed 's/-a 20 /-a 999999 /' $office/blind.rad > million.rad
overlay() { printf 'overlay blind.rad %d\n' $(wc -c < $1); cat $1; }
live() {
    exec ptrace -w- -x 8 -y 8 -frames 999999 -control ctl $desk materials.rad layout.rad blind.rad sky_1400.rad
}
frames() { for i in $(seq 600); do grep -aq "^EDIT=$1" live.str && return; sleep .1; done; return 1; }
check 'a number that is too large does not hang: the next edit is carried out, after a line that says what takes long' '
    live > live.str 2> said & p=$!
    exec 9> ctl; frames 0; overlay million.rad >&9; sleep 4; grep -q "^ptrace: edit 1: reading the model$" said
    from=$SECONDS; overlay $office/blind.rad >&9; echo view -vp 2 2 1.2 >&9; frames 1; [ $((SECONDS - from)) -lt 20 ]
    echo next >&9; exec 9>&-; wait $p; [ $(wc -l < said) = 1 ]'
check 'nor does a signal wait for it' '
    live > live.str 2> said & p=$!
    exec 9> ctl; frames 0; overlay million.rad >&9; sleep 2; from=$SECONDS; kill -TERM $p; exec 9>&-
    s=0; wait $p || s=$?; [ $s = 3 ]; [ $((SECONDS - from)) -lt 10 ]'
# Slats whose reading takes longer than a twentieth of a second, after which others follow.
drag() {
    for k in $(seq 400); do
        ! grep -aq "^EDIT=[2-9]" live.str || return 0
        sed "s/-a 20 /-a $((30000 + k % 2)) /" $office/blind.rad > some.rad; overlay some.rad >&9; sleep .05
    done
    return 1
}
check 'a drag whose next step comes before a step is read shows pictures all the same' '
    live > live.str 2> said & p=$!
    exec 9> ctl; frames 0; echo preview >&9; s=0; drag || s=$?; exec 9>&-; kill $p; wait $p || :; [ $s = 0 ]'
check 'a "next" that arrives while an edit fails ends the picture that goes on' '
    live > live.str 2> said & p=$!
    exec 9> ctl; frames 0; printf "overlay blind.rad 7\nbroken\nnext\n" >&9
    for i in $(seq 200); do kill -0 $p 2> /dev/null || break; sleep .1; done; not kill $p 2> /dev/null; exec 9>&-
    wait $p; grep -q "^ptrace: blind.rad:2: " said'
check 'an unknown word and a line without end are reported' '
    (sleep .5; echo "jump up"; head -c 70000 /dev/zero | tr "\0" x; echo; echo next) > ctl &
    timeout 100 ptrace -x 24 -y 24 -moments- -control ctl $desk $scene 2> said | cat > /dev/null
    grep -q "^ptrace: ctl: .jump up. is not a command" said
    grep -q "^ptrace: warning: ctl: a line is longer than 65536 bytes" said; ! grep xxxx said'
check_error 'a FIFO that is none is reported' 2 '^ptrace: t: is not a FIFO' '
    touch t; ptrace -control t -frames 1 $scene | cat'
check_error 'one that is not there, too' 2 '^ptrace: gone: cannot be opened' '
    ptrace -control gone -frames 1 $scene | cat'
check_error 'vcmetrics -control needs to know when a picture ends' 1 '^vcmetrics: -control: needs -until' '
    vcmetrics -control ctl < /dev/null'
check 'a scene on the standard input is not read again by an edit, and stays as it was' '
    touch some.rad; (sleep 1; printf "overlay some.rad 1\n "; sleep 1; echo next) > ctl &
    timeout 100 ptrace -w- -x 8 -y 8 -control ctl - < plain.rad 2> said | cat > live.str
    grep -q "^ptrace: -: the standard input cannot be read again" said
    [ "$(grep -a ^EDIT= live.str | uniq)" = "EDIT=0 start" ]'
