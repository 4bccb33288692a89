# SPDX-License-Identifier: BSD-3-Clause
# ptrace's command line: RADIANCE's conventions, our own words, and every way to get it wrong.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics
cp "$TOP"/examples/scenes/office/view.vf .
printf 'void light l 0 0 3 1 1 1\nl source s 0 0 4 0 0 1 30\n' > sky.rad
in_force() { ptrace "$@" -defaults | sed 's, *#.*,,' | grep -x -e "$want"; }

check 'it says its version' 'ptrace -version | grep -q "^ptrace "'
check 'it names its devices' 'ptrace -devices | grep -q cpu'
check 'defaults are those of a converged picture' '
    for want in "-ab unlimited" "-st 0" "-dj 1" "-dr 2" "-pj 1" "-lr 0" "-x 512" "-y 512"; do in_force; done'
check 'an option before -defaults shows' 'want="-ab 3" && in_force -ab 3'
check 'no limit can be typed, too' 'want="-ab unlimited" && in_force -ab 3 -ab unlimited'
check 'the later of two options holds' 'want="-ab 4" && in_force -ab 3 -ab 4'
check 'a later -vp overrides the view file' 'want="-vp 1 2 3" && in_force -vf view.vf -vp 1 2 3'
check 'a view file overrides an earlier -vp' 'want="-vp 2 2.7 1.2" && in_force -vp 1 2 3 -vf view.vf'
check '-i toggles, -i+ and -i- set' '
    for w in "-i:+" "-i -i:-" "-i+ -i+:+" "-i -i-:-" "-i1:+"; do want="-i${w#*:}"; in_force ${w%:*}; done'
check '@file stands for the words in it' 'echo "-ab 2
    -vp 4 5 6" > o.opt; want="-ab 2" && in_force @o.opt && want="-vp 4 5 6" && in_force @o.opt'
check '$VARIABLE stands for its words' 'export OPTS="-ab 9"; want="-ab 9" && in_force "\$OPTS"'
check 'numbers are read in one way' '
    want="-x 1000" && in_force -pa 0 -x 1e3 && want="-pj 0.5" && in_force -pj 50% && want="-ab 3" && in_force --ab 3 &&
        in_force -ab=3'
check 'negative numbers are arguments' 'want="-vd -1 -2 -3" && in_force -vd -1 -2 -3'
check_error 'a variable that is not set is reported' 1 '^ptrace: \$NONE: ' 'ptrace "\$NONE" sky.rad'
check_error 'a missing @file is a system error' 2 '^ptrace: none.opt: cannot be read' 'ptrace @none.opt sky.rad'
check_error 'options that run in a circle stop' 1 'expands without end' 'echo @loop > loop; ptrace @loop sky.rad'

check 'options that a path tracer does not need are named in one warning' '
    ptrace -aa .1 -ar 64 -ad 256 -as 128 -dt 0 -dc 1 -ps 1 -pt 0 -aw 0 -ap map 40 50 -frames 1 -x 8 -y 8 \
        -vf view.vf sky.rad 2> said > /dev/null
    test $(wc -l < said) -eq 1; grep -q "does not need -aa -ar -ad -as -dt -dc -ps -pt -aw -ap$" said'
check '-z says that it writes nothing' '
    ptrace -z z.zbf -frames 1 -x 8 -y 8 -vf view.vf sky.rad 2> said > /dev/null
    grep -qx "ptrace: warning: -z: ignored: no depth file is written" said; test ! -e z.zbf'
check '-cs and -cw say what becomes of spectra' '
    ptrace -cs 20 -cw 380 780 -dt 0 -frames 1 -x 8 -y 8 -vf view.vf sky.rad 2> said > /dev/null
    grep -qx "ptrace: warning: -cs -cw: ignored: spectra are folded to RGB" said; grep -q "need -dt$" said'
check 'and -w- silences it' 'ptrace -w- -aa .1 -frames 1 -x 8 -y 8 sky.rad 2>&1 > /dev/null | { ! grep .; }'
cat > closed.rad << 'END'
void light bulb 0 0 3 100 100 100
bulb sphere b 0 0 4 0 0 0 .01
void plastic wall 0 0 5 .8 .8 .8 0 0
wall bubble room 0 0 4 0 0 0 1
END
inside='-vta -vp .1 0 0 -vd 1 0 0 -vh 180 -vv 180 -x 16 -y 16 -frames 2'
check 'a limit of bounces tells once what it leaves out: .8 ^ 3 of the light in a closed sphere' '
    ptrace -ab 2 $inside closed.rad 2> said > /dev/null; test $(wc -l < said) -eq 1
    share=$(sed -n "s/^ptrace: warning: -ab 2: leaves out \([0-9.]*\) +- [0-9.]* % of the illuminance at the eye/\1/p" \
        said)
    echo "$share" | awk "{exit !(\$1 > 48 && \$1 < 55)}"'
check 'no limit, -ab 0 and -w- tell nothing' '
    for ab in "-ab unlimited" "-ab 0" "-w- -ab 2"; do
        ptrace $ab $inside closed.rad 2>&1 > /dev/null | { ! grep .; }
    done'
check '-av without a limit is ignored, said once' '
    ptrace $inside closed.rad | ptaccum -last -ff > without
    ptrace -av 1 1 1 $inside closed.rad 2> said | ptaccum -last -ff > with
    test $(wc -l < said) -eq 1; grep -q "warning: -av: ignored, except in mist: without -ab n" said
    test "$(tail -c 3072 without | cksum)" = "$(tail -c 3072 with | cksum)"'
check '-e sends messages to a file' '
    ptrace -e log -aa .1 -frames 1 -x 8 -y 8 sky.rad > /dev/null; grep -q "warning.*-aa" log'

unset LUXPIPE_THREADS SLURM_CPUS_PER_TASK
check 'threads: what the process may use' 'taskset -c 0 ptrace -defaults | grep -q "^-n 1 "'
check 'a job of Slurm has so many' 'SLURM_CPUS_PER_TASK=1 ptrace -defaults | grep -q "^-n 1 "'
check_error 'LUXPIPE_THREADS that is no number' 1 '^ptrace: LUXPIPE_THREADS: "many" is not an integer' '
    export LUXPIPE_THREADS=many; ptrace -defaults'
check_error 'a number of -seed that does not fit' 1 '^ptrace: -seed: "18446744073709551615" is too large' '
    ptrace -seed 18446744073709551615 x.rad'
check 'LUXPIPE_THREADS is taken, -n before it' '
    export LUXPIPE_THREADS=7; want="-n 7" && in_force && want="-n 3" && in_force -n 3'
dome='-vta -vh 180 -vv 180 -vd 0 0 1 -vu 0 1 0'
check '-n threads do the work' '
    threads() {  # more than asked for under the thread sanitizer or an emulator, which have one of their own
        rm -f later; ptrace -n $1 -x 64 -y 64 $dome -frames 1000000 sky.rad 2> said \
            > >(head -c 100000 > first; : > later; cat > /dev/null) & p=$!; most=0; looks=0  # some frames
        until [ -e later -a $looks -ge 100 ] || ! kill -0 $p; do
            n=$(ls /proc/$p/task | wc -l); [ "$n" -le "$most" ] || most=$n; looks=$((looks + 1)); done; kill -9 $p
        echo $most; }
    [ $(threads 3) -eq $(($(threads 1) + 2)) ]'
check_error '-n 0 is reported' 1 '^ptrace: -n: 0 is outside' 'ptrace -n 0 sky.rad'

check_error 'an unknown option is reported' 1 '^ptrace: -zz: unknown option' 'ptrace -zz sky.rad'
check_error 'and the nearest one is named' 1 '^ptrace: -vx: unknown option; did you mean -vp[?]$' 'ptrace -vx sky.rad'
check_error 'a missing argument is reported' 1 '^ptrace: -ab: an argument is missing .-ab n.$' 'ptrace -ab'
check_error 'a word is not a number' 1 '^ptrace: -vp: "sky.rad" is not' 'ptrace -vp 1 2 sky.rad'
check_error 'no scene is reported' 1 '^ptrace: no scene file' 'ptrace -frames 1'
check_error 'a size of 0 is reported' 1 '^ptrace: -x: 0 is outside' 'ptrace -x 0 -frames 1 sky.rad'
check_error 'a huge size is reported' 1 '^ptrace: -y: ' 'ptrace -y 999999 -frames 1 sky.rad'
check_error 'an impossible view is reported' 1 '^ptrace: -vh: ' 'ptrace -vh 200 -frames 1 sky.rad'
check_error 'options after the scene are an error' 1 \
    '^ptrace: -ab: options must come before the scene files, but "sky.rad" came first$' 'ptrace sky.rad -ab 3'
check_error 'other primaries are refused' 1 '^ptrace: -pXYZ: ' 'ptrace -pXYZ sky.rad'
check 'frames in a file get a warning: other programs misread them' '
    ptrace -frames 1 -x 8 -y 8 sky.rad > file.hdr 2> said; [ "$(wc -l < said)" = 1 ];
    grep -q "^ptrace: warning: stdout: .*ptaccum -last" said
    ptrace -w- -frames 1 -x 8 -y 8 sky.rad > file.hdr 2> said; [ ! -s said ]
    ptrace -frames 1 -x 8 -y 8 sky.rad 2> said | cat > file.hdr; [ ! -s said ]'
check_error 'frames without end need a reader' 1 '^ptrace: -frames: ' 'ptrace sky.rad > file.hdr'
check_error 'files have an end' 1 '^ptrace: -frames: ' 'ptrace -o f%d.hdr sky.rad'
check_error 'no frame is reported' 1 '^ptrace: -frames: needs at least 1' 'ptrace -frames 0 sky.rad'
check_error 'a range runs forward' 1 '^ptrace: -frames: 5:2 contains no frames' 'ptrace -frames 5:2 sky.rad'
check_error 'frames count from 0' 1 '^ptrace: -frames: ' 'ptrace -frames -3:2 sky.rad'
check_error 'several frames need %d in -o' 1 '^ptrace: -o: ' 'ptrace -frames 2 -o f.hdr sky.rad'
check_error 'a pattern holds a %d only' 1 '^ptrace: -o: ' 'ptrace -frames 2 -o f%s.hdr sky.rad'
check_error 'a missing scene is reported by name' 2 '^ptrace: none.rad: ' 'ptrace -frames 1 none.rad > x'
check_error 'a full disk is reported' 2 '^ptrace: stdout: ' 'ptrace -x 64 -y 64 -frames 2 sky.rad > /dev/full'
check_error 'an unknown device is reported' 1 '^ptrace: .*abacus' 'ptrace -device abacus -frames 1 sky.rad > x'
check_error 'an OpenCL device that is not there' '[12]' '^ptrace: .*OpenCL' '
    ptrace -device opencl:99 -frames 1 sky.rad > x'

check 'a closed pipe is a quiet end' '
    ptrace -x 64 -y 64 -vta -vh 180 -vv 180 sky.rad 2> said | head -c 100 > /dev/null; test ! -s said'
check '-o writes one file a frame, in float' '
    ptrace -x 8 -y 8 -frames 2:3 -o f%03d.hdr sky.rad; grep -aq FORMAT=float f002.hdr; test -f f003.hdr;
    test $(ls f0* | wc -l) -eq 2'
check 'a frame carries its history' '
    for line in "#?RADIANCE" "ptrace .*sky.rad" "SOFTWARE=.*luxpipe" "VIEW=.* -vp 0 0 1" "SEED=7" "FRAME=0" \
        "FORMAT=float" "-Y 8 +X 8"; do
        ptrace -vp 0 0 1 -x 8 -y 8 -seed 7 -frames 1 sky.rad | head -c 1000 | strings | grep -q -e "^$line"; done'
check '-f defines functions for the whole scene' '
    echo "half = .5;" > half.cal;
    printf "void brightfunc b 2 half . 0 0\nb glow g 0 0 4 2 2 2 0\ng source s 0 0 4 0 0 1 360\n" > half.rad
    ptrace -f half.cal -vta -vh 180 -vv 180 -x 32 -y 32 -frames 1 half.rad | ptaccum -last -ff |
        vcmetrics -metrics Lavg | tail -n 1 | grep -qE "\b(179|179[.]0+.*|178[.]999.*)$"'
check_error 'a function file that is not there' '[12]' '^ptrace: -f: ' 'ptrace -f none.cal -frames 1 sky.rad > x'
check 'a rad input file brings scene, options and view' '
    printf "ZONE= I -1 1 -1 1 -1 1\nscene= sky.rad\nRESOLUTION= 16 16\nview= up -vtv -vp 0 0 0 -vd 0 0 1 -vu 0 1 0\n" \
        > t.rif
    ptrace -rif t.rif -frames 1 up | head -c 1000 | strings | grep -qx -e "-Y 16 +X 16";
    ptrace -rif t.rif -frames 1 -x 12 -y 12 > /dev/null; ptrace -rif t.rif -frames 1 Xl > /dev/null'
check 'its exposure brightens the picture and moves no number' '
    ptrace -rif t.rif -av 0 0 0 -frames 3 | ptaccum -last -ff > p.hdr
    for e in +2:4 -1:0.5 3:3; do
        { cat t.rif; echo "EXPOSURE= ${e%:*}"; } > e.rif
        ptrace -rif e.rif -av 0 0 0 -frames 3 > e.str; strings e.str | grep -qx "EXPOSURE=${e#*:}"
        ptaccum -last -ff e.str > e.hdr; strings e.hdr | grep -qx "EXPOSURE=${e#*:}"
        vcmetrics -metrics Lavg,Ev -vta -vh 180 -vv 180 p.hdr e.hdr | tail -n 2 | cut -f 2- | uniq | wc -l | grep -qx 1;
        done'
check_error 'a view that the rad input file lacks' 1 '^ptrace: t.rif: has no view "left"' '
    ptrace -rif t.rif -frames 1 left > x'

view='-vta -vh 180 -vv 180 -vd 0 0 1 -vu 0 1 0 -x 32 -y 32'
pixels() { sed -n '/^-Y/,$p' "$1"; }
check '-picture is the picture that ptaccum -last makes' '
    ptrace $view -frames 5 sky.rad | ptaccum -last > two.hdr; ptrace -picture $view -frames 5 sky.rad > one.hdr 2> said
    test ! -s said; pixels one.hdr > a; pixels two.hdr | cmp - a; strings one.hdr | grep -qx FRAMES=4'
check 'to a file, too, which merges' '
    ptrace -picture $view -frames 5 -o one.hdr sky.rad; pixels one.hdr | cmp - a
    ptrace -picture $view -frames 5 -o one.exr sky.rad; ptaccum one.exr | pixels /dev/stdin | cmp - a
    ptrace -seed 2 $view -frames 5 sky.rad | ptaccum -last | ptaccum one.exr - -o both.exr
    ptaccum both.exr | strings | grep -qx FRAMES=8'
check 'of 64 frames where -frames is not given, also to a file' '
    ptrace -picture $view sky.rad > one.hdr; strings one.hdr | grep -qx FRAMES=63'
check 'of several views one after another, or each by its name' '
    for d in 1 2; do echo "VIEW= v$d -vta -vh 180 -vv 180 -vp 0 0 $d -vd 0 0 1 -vu 0 1 0"; done > two.vf
    ptrace -picture -views two.vf -x 8 -y 8 -frames 2 sky.rad | grep -ao "#?RADIANCE" | wc -l | grep -qx 2
    ptrace -picture -views two.vf -x 8 -y 8 -frames 2 -o "%s.hdr" sky.rad; test -s v1.hdr && test -s v2.hdr'
check_error '-picture without frame 0' 1 '^ptrace: -picture: needs frame 0' 'ptrace -picture -frames 2:4 sky.rad > x'
check_error '-picture has no number of a frame' 1 '^ptrace: -o: .*writes no numbered frames' '
    ptrace -picture -frames 2 -o x%d.hdr sky.rad'
check 'a signal ends it with the frames until then' '
    for wait in 1 5 25 125; do  # until it has one, which an emulator takes long for
        ptrace -picture -x 64 -y 64 -frames 1000000 sky.rad > x & pid=$!; sleep $wait; kill -TERM $pid
        status=0; wait $pid || status=$?; test $status -eq 3; ! [ -s x ] || break
    done; vcmetrics -vta -vh 180 -vv 180 -metrics Ev x > table'
check '-pixel prints the light of a pixel, which sums to that of the picture' '
    ptrace $view -pixel 16,17 -frames 0:0 sky.rad > one; ptrace $view -pixel 16,17 -frames 5 sky.rad > five
    head -1 one | grep -q "^frame.path.vertex.surface.material.place.point.lobe.weight.bounces.light.red"
    head -1 five | grep -qx "by.name.red.green.blue.share"; grep -q "^pixel.*.100$" five
    grep -q "^surface	.* (sky.rad:[0-9]*)	\|^surface	(none)	" five
    awk -F"\t" "NF == 15 && NR > 1 {sum += \$12} /^pixel/ {all = \$3}
        END {exit !(all > 0 && (sum / all - 1) ^ 2 < 1e-10)}" one'
check_error '-pixel outside of the picture' 1 '^ptrace: -pixel: 32,0 is outside of a picture of 32 x 32' '
    ptrace $view -pixel 32,0 sky.rad > x'
check_error '-pixel is two numbers' 1 '^ptrace: -pixel: needs a pixel such as 120,88, not 7' '
    ptrace $view -pixel 7 sky.rad > x'
check_error '-pixel writes no picture' 1 '^ptrace: -pixel: writes no picture' 'ptrace $view -pixel 1,1 -o x.hdr sky.rad'
if command -v pfilt > /dev/null; then
    check 'pfilt reads it from the pipe' '
        ptrace -picture $view -frames 4 sky.rad | pfilt -x 16 -y 16 > small.hdr; test -s small.hdr'
fi
