# SPDX-License-Identifier: BSD-3-Clause
# ptrace while its scene, view and options change (-watch, -control): after any edits the frames are those of a run of
# its own, bit by bit, and what is broken is said once while the last good scene goes on.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics mkstream
office=$TOP/examples/scenes/office
export SEED=${SEED:-1}
mkdir model && cp $office/*.rad model/
grey='void plastic grey_wall 0 0 5'
printf '%s .5 .5 .5 0 0\nvoid brightfunc p\n2 v f.cal\n0 0\np plastic wall 0 0 5 .5 .5 .5 0 0\n' "$grey" > m.rad
printf 'v = .8;\n' > f.cal
printf '!xform -t 0 0 0 inner.rad\nvoid light l 0 0 3 3 3 3\nl source s 0 0 4 0 .3 1 40\n' > s.rad
printf 'wall ring r 0 0 8 0 0 0 0 0 1 0 3\nwall sphere b 0 0 4 0 1 .5 .5\n' > inner.rad
eye='-vtv -vp 0 -4 2 -vd 0 1 -.4 -vh 60 -vv 60'
mkfifo ctl
sleep 10000 <> ctl & holder=$!  # writing to it never waits for a reader
trap 'status=$?; kill $holder; (exit $status); finish' EXIT

# The stream to f, ptrace's messages to said; a reader counts frames, so that edits come after some have been written.
begin() {
    rm -f f said
    {
        timeout --foreground 100 ptrace -moments- -x 16 -y 16 "$@" m.rad s.rad 2> said & echo $! > pid
        wait
    } | cat > f &
}
end() { kill $(cat pid); wait || :; }  # --foreground: one signal, after which ptrace finishes its frame; else two
frames() { grep -ac '^FRAME=' f; }
edits() { grep -a '^EDIT=' f | uniq | tr '\n' ' '; }
await() { for i in $(seq 400); do eval "$1" && return; sleep .025; done; echo "in vain: $1"; return 1; }
settle() { n=$(frames); await '[ $(frames) -gt $((n + 3)) ]'; }
# Its last picture is that of a run of its own, of as many frames, with the words of $1.
as_alone() {
    ptaccum -last -o is.exr < f
    n=$(ptaccum -last < f | grep -a ^RANGE=0: | tail -1); n=${n#*:}
    ptrace -w- -moments- -x 16 -y 16 $1 -frames $((n + 1)) m.rad s.rad | ptaccum -last -o alone.exr
    [ "$(mkstream differ alone.exr is.exr)" = 0 ]
    [ "$(strings is.exr | grep ^FINGERPRINT | tail -1)" = "$(strings alone.exr | grep ^FINGERPRINT | tail -1)" ]
}

check 'each way of saving a file begins a picture anew, a touch without change does not' '
    begin -watch $eye; await "[ -s f ] && [ \$(frames) -gt 3 ]"
    printf "v = .7;\n" > f.cal; await "grep -aq ^EDIT=1 f"                                   # in place
    printf "v = .6;\n" > t; mv t f.cal; await "grep -aq ^EDIT=2 f"                            # moved over it
    mv f.cal f.cal~; sleep .05; printf "v = .5;\n" > f.cal; await "grep -aq ^EDIT=3 f"        # as vim does
    sed -i s/.5/.4/ inner.rad; await "grep -aq ^EDIT=4 f"                                     # included
    touch m.rad; settle; sleep .3; settle; end
    [ "$(edits)" = "EDIT=0 start EDIT=1 scene EDIT=2 scene EDIT=3 scene EDIT=4 scene " ]; [ ! -s said ]'
check 'a broken scene is said once with its place, the last good one goes on, and the mended one is rendered' '
    begin -watch $eye; await "[ -s f ] && [ \$(frames) -gt 3 ]"
    cp inner.rad good; echo "wal sphere c 0 0 4 0 0 1 .2" >> inner.rad; await "[ -s said ]"; settle; settle
    [ "$(cat said)" = "ptrace: inner.rad:3: modifier \"wal\" is not defined" ]; [ "$(edits)" = "EDIT=0 start " ]
    sed s/wal\ /wall\ / inner.rad > t; mv t inner.rad; await "grep -aq ^EDIT=1 f"; settle; end
    [ $(wc -l < said) = 1 ]; as_alone "$eye"; cp good inner.rad'
check 'a file that comes to be earlier on RAYPATH, or beside the file that names it, is taken' '
    mkdir first last; mv f.cal last; export RAYPATH=first:last; begin -watch $eye
    await "[ -s f ] && [ \$(frames) -gt 3 ]"
    echo "v = .1;" > first/f.cal; await "grep -aq ^EDIT=1 f"; settle
    echo "v = .2;" > f.cal; await "grep -aq ^EDIT=2 f"; settle; end; as_alone "$eye"'
mkdir grid
watch_points() {
    printf "1 0 1 0 0 1\n" > grid/a.pts; begin -watch -points grid; await "[ -s f ] && [ \$(frames) -gt 3 ]"
}
check 'a file of points is watched as those of the scene, and more points are more pixels' '
    watch_points; seq 9 | sed "s/.*/& 0 1 0 0 1/" > t; mv t grid/a.pts; await "grep -aq ^EDIT=1 f"; settle; end
    grep -aq "^GRID=a 0 9 " f; as_alone "-points grid"; [ ! -s said ]'
check 'a mistake in it is said once with its place, the last good points go on, and the mended ones are rendered' '
    watch_points; printf "1 0 1 0 0 1\n2 0 1 0 0\n" > grid/a.pts; await "[ -s said ]"; settle; settle
    [ "$(cat said)" = "ptrace: grid/a.pts:2: a point is x y z dx dy dz, six numbers, not 5" ]
    [ "$(edits)" = "EDIT=0 start " ]; printf "1 0 2 0 0 1\n2 0 2 0 0 1\n" > grid/a.pts; await "grep -aq ^EDIT=1 f"
    settle; end; as_alone "-points grid"; [ $(wc -l < said) = 1 ]'
check 'points that come to a folder, and leave it, while the scene changes, too' '
    watch_points; printf "0 0 2 1 0 0\n" > t; mv t grid/b.pts; await "grep -aq \"^GRID=b 1 1 \" f"
    sed "s/[.]5 [.]5/.1 .1/" m.rad > t; cp m.rad good; mv t m.rad; await "grep -aq ^EDIT=2 f"
    rm grid/a.pts; await "grep -aq \"^GRID=b 0 1 \" f"; settle; end; as_alone "-points grid"
    mv good m.rad; rm grid/b.pts'
check 'the points of the standard input stay' '
    echo 1 0 1 0 0 1 > points.pts; begin -watch -points - < points.pts; await "[ -s f ] && [ \$(frames) -gt 3 ]"
    echo "v = .3;" > f.cal; await "grep -aq ^EDIT=1 f"; settle; end; as_alone "-points points.pts"'
check 'view, set and size; wrong words are said and change nothing; the same words again begin nothing' '
    begin -control ctl $eye; await "[ -s f ] && [ \$(frames) -gt 3 ]"
    echo "view -vp 1 -4 2" > ctl; await "grep -aq \"^EDIT=1 view\" f"
    echo "set -ab 1" > ctl; await "grep -aq \"^EDIT=2 set\" f"
    echo "size 12 20" > ctl; await "grep -aq ^EDIT=3 f"; settle
    echo "view -vp 1 -4 2" > ctl; settle
    for w in "jump" "view -vh 400" "set -o x" "size 3"; do echo "$w" > ctl; settle; done; end
    [ "$(edits)" = "EDIT=0 start EDIT=1 view EDIT=2 set EDIT=3 size " ]; [ $(wc -l < said) = 4 ]
    as_alone "$eye -vp 1 -4 2 -ab 1 -x 12 -y 20"'
check 'a storm of 1,000 commands ends with the last view, and takes no memory' '
    begin -control ctl $eye; await "[ -s f ] && [ \$(frames) -gt 3 ]"
    memory() { awk "/^VmRSS/ { print \$2 }" /proc/$(cat pid)/status; }; before=$(memory)
    for i in $(seq 1000); do echo "view -vp .$i -4 2"; [ $((i % 50)) != 0 ] || sleep .02; done > ctl
    echo "view -vp .5 -4 2" > ctl
    await "grep -aq \"VIEW=.* -vp 0.5 -4 2\" f"; settle; after=$(memory); end; as_alone "$eye -vp .5 -4 2"
    echo "$before $after kB"; [ $after -lt $((before + 8000)) ]'
check 'an edit does not wait for the frame at hand, which is thrown away' '
    begin -control ctl $eye -x 3000 -y 3000; sleep 1; echo "size 16 16" > ctl
    await "grep -aq ^EDIT=1 f"; settle; end; [ "$(edits)" = "EDIT=1 size " ]; as_alone "$eye"'
overlay() { printf "overlay %s %d\n%s" "$1" ${#2} "$2" > ctl; }
check 'an overlay stands for a file until it is taken back or the file changes on disk' '
    printf "v = .8;\n" > f.cal; begin -watch -control ctl $eye; await "[ -s f ] && [ \$(frames) -gt 3 ]"
    overlay f.cal "v = .3;"; await "grep -aq \"^EDIT=1 overlay\" f"; settle
    overlay ./f.cal "v = broken("; await "[ -s said ]"; settle; overlay f.cal "v = .2;"; await "grep -aq ^EDIT=2 f"
    echo "overlay f.cal -" > ctl; await "grep -aq ^EDIT=3 f"; overlay inner.rad "wall sphere b 0 0 4 0 1 .5 .3"
    await "grep -aq ^EDIT=4 f"; overlay f.cal "v = .1;"; await "grep -aq ^EDIT=5 f"; printf "v = .4;\n" > f.cal
    await "grep -aq \"^EDIT=6 scene\" f"; settle; end; cp inner.rad good
    echo "wall sphere b 0 0 4 0 1 .5 .3" > inner.rad; as_alone "$eye"; cp good inner.rad; [ $(wc -l < said) = 1 ]'
check 'what comes with a broken file is carried out under its own name, and what is broken is said with each picture' '
    begin -watch -control ctl $eye; await "[ -s f ] && [ \$(frames) -gt 3 ]"
    printf "preview -vp 1 -4 2\nnote broken\noverlay f.cal 11\nv = broken(\ngo\n" > ctl
    await "grep -aq \"^EDIT=. view\$\" f"; await "[ -s said ]"; settle; said=$(wc -l < said)
    echo "view -vp 2 -4 2" > ctl; await "[ \$(grep -a \"^EDIT=. view\$\" f | uniq | wc -l) = 2 ]"; settle
    [ $(wc -l < said) = $((said + 1)) ]; printf "note mended\noverlay f.cal 7\nv = .2;" > ctl
    await "grep -aq \"^EDIT=. overlay mended\$\" f"; echo "view -vp 1 -4 2" > ctl
    await "[ \$(grep -a \"^EDIT=. view\$\" f | uniq | wc -l) = 3 ]"; end
    [ "$(uniq said)" = "$(head -1 said)" ]; [ $(wc -l < said) = $((said + 1)) ]; ! grep -aq "^EDIT=.*broken" f'
check 'no overlay with -exec: its text could run programs' '
    begin -exec -control ctl $eye; await "[ -s f ] && [ \$(frames) -gt 3 ]"
    overlay inner.rad "!touch ran"; await "[ -s said ]"; settle; end
    grep -q "with -exec no text may replace a file" said; [ ! -e ran ]; [ "$(edits)" = "EDIT=0 start " ]'
check 'an overlay needs a file and all of its bytes' '
    begin -control ctl $eye; await "[ -s f ] && [ \$(frames) -gt 3 ]"
    overlay none.cal "v = 1;"; await "[ -s said ]"; echo "overlay f.cal many" > ctl; await "[ \$(wc -l < said) = 2 ]"
    end; grep -q "^ptrace: none.cal: cannot be overlaid: No such file" said; [ "$(edits)" = "EDIT=0 start " ]'
check 'a preview is small, two frames, and waits; go makes a full picture of it' '
    begin -control ctl $eye -x 200 -y 200; await "[ -s f ] && [ \$(frames) -gt 3 ]"
    echo "preview -vp 1 -4 2" > ctl; await "grep -aq \"^EDIT=1 preview\" f"; sleep .5
    [ "$(grep -ac "^EDIT=1 preview" f)" = 2 ]; grep -aq "^-Y 128 +X 128" f; overlay f.cal "v = .3;"
    await "grep -aq \"^EDIT=2 preview\" f"; echo "overlay f.cal -" > ctl; await "grep -aq ^EDIT=3 f"; echo go > ctl
    await "grep -aq \"^EDIT=4 overlay\" f"; settle; end; as_alone "$eye -x 200 -y 200 -vp 1 -4 2"'
check 'a preview leaves the size of later pictures as it was' '
    begin -control ctl $eye; await "[ -s f ] && [ \$(frames) -gt 3 ]"
    echo "preview -x 9 -y 9" > ctl; await "[ -s said ]"; grep -q "^ptrace: ctl: a preview has a size of its own" said
    echo "view -vp 1 -4 2" > ctl; await "grep -aq \"^EDIT=1 view\" f"; settle; end
    not grep -aq "^-Y 9 +X 9" f; as_alone "$eye -vp 1 -4 2"'
check 'next ends a preview' '
    { sleep 1; printf "preview -vp 1 -4 2\n" > ctl; sleep 1; echo next > ctl; } &
    ptrace -moments- -control ctl -x 8 -y 8 $eye m.rad s.rad | cat > t; wait; grep -aq "^EDIT=1 preview" t'
check 'edits pass through the sums to a column, and LASTFRAME= does not make them errors' '
    (sleep 1; echo "view -vp 1 -4 2" > ctl; sleep 1; echo next > ctl) &
    ptrace -moments- -control ctl -x 8 -y 8 -frames 2000000 $eye m.rad s.rad | ptaccum | vcmetrics -metrics Ev > t
    [ "$(head -1 t)" = "$(printf "frame\tseconds\tedit\tEv")" ]; [ "$(cut -f 3 t | uniq | tr "\n" " ")" = "edit 0 1 " ]'
check 'next behind an edit that came at the same time is of the picture after it' '
    begin -control ctl $eye; await "[ -s f ] && [ \$(frames) -gt 3 ]"
    printf "view -vp 1 -4 2\nnext\n" > ctl; wait; [ "$(edits)" = "EDIT=0 start EDIT=1 view " ]
    [ "$(grep -ac ^LASTFRAME=0 f)" = 1 ]'
check 'with -frames the last picture waits for edits' '
    begin -watch -frames 4 $eye; await "[ -s f ] && [ \$(frames) = 4 ]"; sleep .2; printf "v = .9;\n" > f.cal
    await "[ \$(frames) = 8 ]"; end; as_alone "$eye"'
check_error '-watch cannot read the standard input again' 1 '^ptrace: -watch: the standard input' '
    ptrace -watch - < s.rad | cat'

# Any row of edits: files, views, options and sizes, some of them broken.
random() { awk -v n="$1" -v s="$2" 'BEGIN { srand(s); for (i = 0; i < 9; i++) k = rand(); print int(k * n) }'; }
campaign() {
    printf 'v = .8;\n' > f.cal; vp=0 ab=5 size=16
    begin -watch -control ctl -ab $ab $eye; await '[ -s f ] && [ $(frames) -gt 1 ]'
    for step in 1 2 3 4 5 6; do
        x=$(random 90 $((SEED * 100 + $1 * 10 + step)))
        case $((x % 5)) in
            0) printf 'v = .%s1;\n' $x > f.cal ;;
            1) vp=.${x}1; echo "view -vp $vp -4 2" > ctl ;;
            2) ab=$((x % 4)); echo "set -ab $ab" > ctl ;;
            3) size=$((8 + x % 9)); echo "size $size $size" > ctl ;;
            4) echo broken >> inner.rad; settle; cp good inner.rad ;;
        esac
        [ $((x % 2)) = 0 ] || settle
    done
    sleep .3; settle; settle; end
    as_alone "$eye -vp $vp -4 2 -ab $ab -x $size -y $size"
}
for k in $(seq ${CAMPAIGNS:-3}); do check "edits in any order, row $k of seed $SEED" "campaign $k"; done
