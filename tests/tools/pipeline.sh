# SPDX-License-Identifier: BSD-3-Clause
# The whole pipe on the office, small: shares give what one run gives, an early stop is quiet, broken input is reported.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics vcregion
cp "$TOP"/examples/scenes/office/* "$TOP"/examples/office.regions .
side=${side:-48}  # an emulator's is smaller (scripts/test_arm64.sh)
office="-vf view.vf -x $side -y $side materials.rad layout.rad sky_1400.rad"
render() { ptrace -frames "$1" $office; }
# Numbers of the picture, to 6 digits: the same picture within float rounding gives the same text.
numbers() { vcmetrics "$1" | tail -n 1 | cut -f 2- | tr '\t' '\n' | awk '{ printf "%.6g\n", $1 }'; }

check 'the same command gives the same bits' 'render 4 > a; render 4 > b; cmp a b'
check 'another seed gives others' '
    ptrace -seed 2 -frames 4 $office > b; tail -c $((side * side * 12)) b > other
    not cmp -s <(tail -c $((side * side * 12)) a) other'
check 'frames do not depend on the range asked for' '
    render 3:3 > alone; n=$(wc -c < alone); tail -c $((side * side * 12)) alone > pixels;
    tail -c $((side * side * 12)) a | cmp - pixels'
check 'ranges merge to what one run gives' '
    render 64 | ptaccum -last -o whole.exr
    for r in 0:9 10:40 41:63; do render $r | ptaccum -last -o part_$r.exr; done
    ptaccum part_0:9.exr part_10:40.exr part_41:63.exr -o merged.exr
    numbers whole.exr > 1; numbers merged.exr > 2; test -s 1; diff 1 2'
check 'one thread or many: the same frames' '
    taskset -c 0 true 2> /dev/null || exit 0; taskset -c 0 ptrace -frames 4 $office | cmp - a'
check 'metrics come line by line, header first' '
    render 4 | ptaccum | vcmetrics > t; test $(wc -l < t) -eq 5; head -n 1 t | grep -q "^frame	seconds	Ev	DGP";
    cut -f 1 t | tail -n 1 | grep -qx 3'
check 'the middle of an interval is the value without the bias of noise, in which the picture may not lie' '
    render 9 | ptaccum | vcmetrics -metrics DGP,DGPu -ci 95 | tail -n 1 |
        awk -F "\t" "{ off = (\$4 + \$5) / 2 - \$6; exit !(\$5 > \$4 && off < 1e-6 && off > -1e-6 && \$3 > \$6) }"'
check 'regions and contrast have their columns' '
    vcregion -vf view.vf -x $side -y $side -o r.exr office.regions
    render 3 | ptaccum -last | vcmetrics -regions r.exr -cr screen=screen_low/screen_high | head -n 1 |
        grep -q "desk.TAL.*screen.CR"'
check 'a rule that holds ends the pipe with status 0' '
    ptrace $office | ptaccum | vcmetrics -until "Ev 5%" > t; test $(wc -l < t) -lt 200'
check 'and leaves the picture in -o' '
    ptrace $office | ptaccum -o kept.exr -o - | vcmetrics -until "Ev 5%" > t; numbers kept.exr | grep -q .'
check_exit 'frames that end before the rule holds' 4 'render 3 | ptaccum | vcmetrics -until "Ev 0.0001%"'
check 'a reader that goes away is not an error' '
    ptrace $office 2> said | ptaccum 2>> said | head -c 500 > /dev/null; test ! -s said'

check 'moments come behind frame 0 and the first sum; frames are the same without; merged shares keep their bits' '
    render 3 > with.hdr; render 3 -moments- > without.hdr
    test $(grep -ac "^LAYER=moments" with.hdr) -eq 1; not grep -aq moments= without.hdr
    ptaccum < with.hdr > sums.hdr; test $(grep -ac "^LAYER=moments" sums.hdr) -eq 1
    ptaccum -last < with.hdr -o a.exr; ptaccum -last < without.hdr -o b.exr
    numbers a.exr > a; numbers b.exr > b; cmp a b
    render 0:1 | ptaccum -last -o c.exr; render 2:2 | ptaccum -last -o d.exr; ptaccum d.exr c.exr -ff > merged.hdr
    ptaccum a.exr -ff > whole.hdr
    for f in merged whole; do tail -c $((side * side * 16)) $f.hdr > $f.moments; done; cmp merged.moments whole.moments'
check_error 'single frames are no picture' 1 '^vcmetrics: .*ptaccum' 'render 2 | vcmetrics > t'
check_error 'a stream cut in the middle is reported' 1 '^ptaccum: stdin: ' 'render 2 | head -c 8000 | ptaccum > t'
check_error 'a partial sum has no metrics' 1 '^vcmetrics: ' 'vcmetrics part_10:40.exr > t'
check_error 'the same frames twice are refused' 1 '^ptaccum: ' 'ptaccum part_0:9.exr part_0:9.exr -o twice.exr'
check_error 'an undefined modifier is reported' 1 '^ptrace: bad.rad:2: .*glas' '
    printf "\nglas sphere s 0 0 4 0 0 0 1\n" > bad.rad; ptrace -frames 1 bad.rad > t'
check_error 'a command of the scene does not run' 1 '^ptrace: bad.rad:1: .*-exec' '
    echo "!touch ran" > bad.rad; ptrace -frames 1 bad.rad > t; test ! -e ran'
check 'one error of a pipe is one line, whichever program it is of, and each ends with status 1' '
    for pipe in "ptrace bad.rad | ptaccum" "ptrace nowhere.rad | ptaccum" "ptrace -nothing | ptaccum -every 2" \
        "render 3 | ptaccum -nothing" "{ render 3 | head -c 8000; } | ptaccum" "render 3 | ptaccum nowhere.hdr -"; do
        { eval "$pipe | vcmetrics > rows; echo \${PIPESTATUS[*]} > ends" || :; } 2> said
        echo "$pipe: $(cat ends said)"; [ "$(wc -l < said)" = 1 ] || exit 1; grep -q " 1$" ends || exit 1
    done
    { ptrace bad.rad | ptaccum -o kept.hdr || :; } 2> said; [ "$(wc -l < said)" = 1 ]'
check 'a pipe that nothing came through says so' '
    { : | vcmetrics || [ $? = 1 ]; } 2>&1 | grep -q "^vcmetrics: stdin: holds no picture (ptaccum -o needs -o -"'
check 'nothing half-written is left behind' 'test ! -e twice.exr; test ! -e ran; test "$(ls -A | grep -c tmp)" -eq 0'
check 'a full disk ends in one line and status 2' '
    s=0; render 4 | ptaccum -last > /dev/full 2> said || s=$?; test $s -eq 2; test $(wc -l < said) -eq 1'
