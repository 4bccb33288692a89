# SPDX-License-Identifier: BSD-3-Clause
# What a scene from elsewhere, a planted link, a full disk or a small machine must not bring about (docs/security.md).
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics vcregion mkstream
view='-vtv -vp 0 0 2 -vd 0 .1 -1 -vu 0 1 0 -vh 40 -vv 40 -x 8 -y 8'
printf 'void plastic mat 0 0 5 .5 .5 .5 0 0\nmat polygon floor 0 0 12 -5 -5 0 5 -5 0 5 5 0 -5 5 0\n' > good.rad
printf 'void glow sky 0 0 4 1 1 1 0\nsky source s 0 0 4 0 0 1 180\n' >> good.rad
printf '!touch PWNED\n' > evil.rad
printf 'VIEW= -vtv -vp 0 0 2 -vd 0 .1 -1 -vu 0 1 0 -vh 40 -vv 40\n' > down.vf
rif() { printf 'scene= %s\nRESOLUTION= 8\nview= a -vf down.vf\n%s\n' "$1" "$2" > t.rif; }
little_memory() { [ -z "$NO_THREADS" ] || ulimit -v "$1"; }
t_rif="ptrace -rif t.rif -frames 1 > x"

# 1. A rad input file brings rendering and view options, and nothing else.
for words in '-exec' '-o leak.hdr' '-e log' '-device cpu' '-frames 2' '-seed 7' '-rif t.rif' '-defaults' '-help' \
        '-devices' '-library'; do
    rif evil.rad "render= $words"
    check_error "render= $words is refused" 1 '^ptrace: t.rif: .*may not' "$t_rif"
    printf 'scene= evil.rad\nRESOLUTION= 8\nview= a -vf down.vf %s\n' "$words" > t.rif
    check_error "view= $words is refused" 1 '^ptrace: t.rif: .*may not' "$t_rif"
    rif evil.rad 'render= @words'
    echo "$words" > words
    check_error "and so in an @file that it names: $words" 1 '^ptrace: t.rif: .*may not' "$t_rif"
done
check 'nothing of that was done' 'test ! -e PWNED && test ! -e leak.hdr && test ! -e log'
rif good.rad 'render= $SECRET'
check_error 'it cannot ask for the environment' 1 '^ptrace: t.rif: ' "SECRET=word123 $t_rif"
check 'and sees nothing of it' "SECRET=word123 $t_rif 2> said || true; test -s said; ! grep word123 said x"
echo 'word123 is my password' > private
rif good.rad 'render= @private'
check_error 'a word of an @file that is not an option is not shown' 1 \
    '^ptrace: t.rif: holds a word where an option is expected' "$t_rif"
rif good.rad 'render= -ab 2 -aa .1 -ad 1024 -av 1 1 1 -u+ -i- -w -t 60 @words'
echo '-ab 3 -ss 1' > words
check 'what renders is taken, and an @file of such words' "$t_rif && test -s x"

# 2. Temporary files.
mkstream frames 0 1 > two.hdr
check 'planted links are not followed' '
    echo mine > victim
    (ptaccum -last two.hdr -o s.exr) & pid=$!
    wait $pid
    mkdir planted; cd planted
    bash -c "for i in 0 1; do ln -s ../victim .s.exr.\$\$.\$i.tmp; done; exec ptaccum -last ../two.hdr -o s.exr"
    grep -qx mine ../victim && test -s s.exr && test ! -L s.exr'
# opened COMMAND: the files that it opens, as strace tells them (under which a sanitizer cannot look for leaks)
opened() { ASAN_OPTIONS=${ASAN_OPTIONS-}:detect_leaks=0 strace -f -e trace=openat "$@"; }
check 'names of temporaries are not to be guessed' '
    command -v strace > /dev/null || exit 0
    for i in 1 2; do opened ptaccum -last two.hdr -o s.exr 2>&1 > /dev/null |
        grep -o "[.]luxpipe-[0-9a-f]*[.]tmp.*O_EXCL.*O_NOFOLLOW" | head -n 1 | cut -c 1-30; done > names
    test $(sort -u names | wc -l) -eq 2'
check 'the permissions of a file that is replaced stay' 'for mode in 600 640 444; do
    chmod $mode s.exr; ptaccum -last two.hdr -o s.exr; test $(stat -c %a s.exr) = $mode; done'
check 'a new file has those of the umask' '
    umask 027; ptaccum -last two.hdr -o new.exr; test $(stat -c %a new.exr) = 640'
check_error 'a file that may not grow is reported and does not kill the program' 2 '^ptaccum: big.hdr: .*too large' '
    ulimit -f 1; ptrace $view -x 64 -y 64 -frames 2 good.rad | ptaccum -last -o big.hdr > /dev/null'
check 'and leaves nothing behind' 'test -z "$(ls -A | grep -E "luxpipe|[.]tmp|^big")"'
long=$(printf 'n%.0s' $(seq 251)).exr
check 'a name of 255 characters is written' "
    test \${#long} -eq 255 && ptaccum -last two.hdr -o $long && test -s $long && rm $long"
check 'a link is kept and what it names is replaced' '
    ln -s s.exr link.exr; chmod 644 s.exr; : > s.exr; ptaccum -last two.hdr -o link.exr;
    test -L link.exr && test -s s.exr'
check 'also where that is not there yet, and over several links' '
    mkdir far; ln -s far/new.exr first.exr; ln -s first.exr second.exr; ptaccum -last two.hdr -o second.exr
    test -L second.exr && test -L first.exr && test "$(ls -A far)" = new.exr'
check_error 'a link to itself is an error' 2 '^ptaccum: loop.exr: cannot be written: Too many levels' '
    ln -s loop.exr loop.exr; ptaccum -last two.hdr -o loop.exr'
check 'and stays' 'test -L loop.exr && rm loop.exr'

# 3. The terminal, and the cache of kernels.
esc=$(printf '\033]0;owned\007')
no_escapes() { ! LC_ALL=C grep -q "$(printf '[\001-\010\013-\037\177]')" "$@"; }
check 'escape sequences in file names stay out of messages' '
    ptrace $view -frames 1 "$esc.rad" > x 2> said || true; test -s said && no_escapes said'
check 'in header lines too' '
    printf "#?RADIANCE\nEXPOSURE=%s\nFORMAT=float\n\n-Y 8 +X 8\n" "$esc" > bad.hdr
    ptaccum bad.hdr > x 2> said || true; test -s said && no_escapes said'
check 'and out of tables' '
    ptaccum -last two.hdr -o "$esc.exr"; for f in tsv csv jsonl; do
        vcmetrics -vta -vh 180 -vv 180 -format $f -metrics Ev "$esc.exr" "$esc.exr" > table; test -s table;
        no_escapes table; done'
check 'UTF-8 stays readable' 'ptrace $view -frames 1 "Büro.rad" > x 2> said || true; grep -q Büro said'
check 'without HOME kernels are not kept where all may write' '
    ptrace -devices | grep -q Portable || exit 0
    before=$(ls -d /tmp/pocl 2> /dev/null || true)
    env -u HOME -u XDG_CACHE_HOME TMPDIR=$TMP ptrace $view -device opencl -frames 1 good.rad > x
    test "$before" = "$(ls -d /tmp/pocl 2> /dev/null || true)"; test -z "$(ls -d luxpipe-kernels* 2> /dev/null)"'

# 5. Small machines.
rif good.rad 'render= -ab 1'
check '-device cpu does not ask OpenCL' '
    command -v strace > /dev/null || exit 0
    opened ptrace $view -device cpu -frames 1 good.rad 2>&1 > /dev/null | {
    ! grep -E "OpenCL/vendors|libpocl"; }'
check 'nor -device auto where the system shows no graphics processor' '
    command -v strace > /dev/null || exit 0
    ls /dev/dri/renderD* /dev/kfd /dev/nvidia[0-9]* /dev/dxg /dev/mali* /dev/kgsl* 2> /dev/null > gpus || true
    test ! -s gpus || exit 0
    opened ptrace $view -device auto -frames 1 good.rad 2>&1 > /dev/null | {
    ! grep -E "OpenCL/vendors|libpocl"; }'
if [ -n "$NO_THREADS" ] && [ -f "$NO_THREADS" ]; then
    few="LD_PRELOAD=$NO_THREADS"
    check 'frames without threads are the same' '
        ptrace $view -x 200 -y 200 -device cpu -frames 2 good.rad | tail -c 400000 > many
        for n in 0 1; do env $few LUXPIPE_TEST_THREADS=$n ptrace $view -x 200 -y 200 -device cpu -frames 2 good.rad |
            tail -c 400000 | cmp - many; done'
    check '-device auto goes on where OpenCL drivers end the program' "
        env $few LUXPIPE_TEST_THREADS=0 ptrace $view -device auto -frames 1 good.rad > x"
    check_error 'and -device opencl says so in a line' 2 '^ptrace: -device opencl: .*OpenCL' "
        env $few LUXPIPE_TEST_THREADS=0 ptrace $view -device opencl -frames 1 good.rad > x"
    check 'masks without threads' '
        for i in 1 2 3 4 5 6 7 8 9; do echo "r$i circle 0 1 0 $((i + 9))"; done > many.regions
        env $few LUXPIPE_TEST_THREADS=0 vcregion -vta -vd 0 1 0 -vh 180 -vv 180 -x 64 -y 64 -o m.exr many.regions'
fi
check 'expressions nested deep do not need a large stack' '
    { printf "a = "; for i in $(seq 480); do printf "("; done; printf "1"; for i in $(seq 480); do printf ")"; done;
    printf ";\n"
      printf "b(x) = if(x-1, b(x-1)+"; for i in $(seq 400); do printf "sin("; done; printf "x"; for i in $(seq 400);
      do printf ")"; done; printf ", Px*a);\n"; } > deep.cal
    printf "void brightfunc p 2 b(30) deep.cal 0 0\np plastic m 0 0 5 .5 .5 .5 0 0\nm sphere s 0 0 4 0 0 0 1\n" \
        > deep.rad
    ulimit -s 256; ptrace $view -device cpu -frames 1 deep.rad > x'

# 15. Work without end.
small='LUXPIPE_WORK=100000'
nested() {  # a scene of $1 levels, each with two of the next
    printf 'void plastic m 0 0 5 .5 .5 .5 0 0\nm sphere s 0 0 4 0 0 0 1\n' > n0.rad
    for i in $(seq $1);
        do printf 'void instance a 4 n%d.rad -t 1 0\n0 0\nvoid instance b 4 n%d.rad -t 2 0\n0 0\n' $((i-1)) $((i-1)) |
            sed 's/ 4 / 5 /; s/-t \(.\) 0/-t \1 0 0/' > n$i.rad; done
}
limit='steps of work .*LUXPIPE_WORK'
nested 40
check_error 'octrees that double at each level' 1 "^ptrace: n40.rad:1: .*$limit" "
    $small timeout 60 ptrace $view -frames 1 n40.rad > x"
printf '!xform -a 1000 good.rad | xform -a 1000 | xform -a 1000\n' > pipe.rad
check_error 'arrays of arrays of arrays' 1 "^ptrace: pipe.rad:1: .*$limit" "
    $small timeout 60 ptrace $view -frames 1 pipe.rad > x"
printf 'void plastic unused 0 0 5 .5 .5 .5 0 0\n' > unused.rad
printf '!xform -a 1000 unused.rad | xform -a 1000 | xform -a 1000\n' > pipe.rad
check_error 'also of nothing to be seen' 1 "^ptrace: pipe.rad:1: .*$limit" "
    $small timeout 60 ptrace $view -frames 1 pipe.rad > x"
{ printf '!genbox m b 1 1 1'; for i in $(seq 30); do printf ' | xform -a 10'; done; echo; } > boxes.rad
check_error 'a box ten to the thirty times' 1 "^ptrace: boxes.rad:1: .*$limit" "
    $small timeout 60 ptrace $view -frames 1 <(cat good.rad | sed s/mat/m/) boxes.rad > x"
check_error 'vcregion has the same limit' 1 "^vcregion: n40.rad:1: .*$limit" "
    printf 'floor surface s\n' > s.regions; $small timeout 60 vcregion $view -list s.regions n40.rad"
check 'what is within it renders' "nested 6; $small ptrace $view -frames 1 n6.rad > x"
check_error 'a limit that is none' 1 '^ptrace: LUXPIPE_WORK: ' "LUXPIPE_WORK=much ptrace $view -frames 1 good.rad > x"

# 16. Commands that -exec allows.
printf '%s' '!sh -c "yes | head -n 1 > /dev/null; trap - PIPE; echo done" > /dev/null;' \
    ' kill -l PIPE > /dev/null; sh -c "kill -PIPE \$\$"; echo $? > pipe' > sig.rad
check 'start with the ordinary SIGPIPE' 'ptrace $view -exec -frames 1 good.rad sig.rad > x; test "$(cat pipe)" -eq 141'
printf '!sleep 61.7 & echo $! > sleeper; wait\n' > sleep.rad
check 'and end with the program' '
    ptrace $view -exec -frames 1 good.rad sleep.rad > x & pid=$!
    for i in $(seq 100); do test -s sleeper && break; sleep .1; done
    kill -TERM $pid; wait $pid || true; sleep .3; test -s sleeper
    ! kill -0 $(cat sleeper) || grep -q "^State:.*Z" /proc/$(cat sleeper)/status'
printf '!sed p\n' > stdin.rad
check 'and do not read our standard input' '
    echo "no scene" | timeout 20 ptrace $view -exec -frames 1 good.rad stdin.rad > x'

# 17. Inputs without end.
for words in '@/dev/zero' '-rif /dev/zero' '-vf /dev/zero'; do
    check_exit "ptrace $words ends" 1 "little_memory 4000000; timeout 60 ptrace $view -device cpu $words good.rad > x"
done
check_exit 'vcmetrics -difference /dev/zero ends' 1 "timeout 60 vcmetrics -difference /dev/zero /dev/zero"
check_exit 'vcmetrics -tolerance /dev/zero ends' 1 "timeout 60 vcmetrics -difference -tolerance /dev/zero s.exr s.exr"
mkfifo fifo
printf '!xform -rz 90 fifo\n' > f1.rad
printf 'void instance i 1 fifo 0 0\n' > f2.rad
printf 'void brightfunc p 2 a fifo 0 0\np plastic m 0 0 5 .5 .5 .5 0 0\nm sphere s 0 0 4 0 0 0 1\n' > f3.rad
for scene in f1 f2; do
    check_error "a FIFO named by a scene is refused ($scene)" 1 "^ptrace: $scene.rad:1: .*not an ordinary file" "
        timeout 20 ptrace $view -frames 1 good.rad $scene.rad > x"
done
check_error 'as a function file it is not found' 1 '^ptrace: f3.rad:1: ' "
    timeout 20 ptrace $view -frames 1 good.rad f3.rad > x"
for line in 'scene= fifo' 'render= @fifo' 'render= -vf fifo'; do
    rif good.rad "$line"
    check_error "and so is one in a rad input file: $line" 1 '^ptrace: t.rif: .*not an ordinary file' "
        timeout 20 $t_rif"
done
check 'on the command line it is welcome' '(cat good.rad > fifo &); timeout 20 ptrace $view -frames 1 fifo > x'

# 19. Words.
printf 'void plastic m 0 0 5 .5 .5 .5 0 0\nm sphere s 0 0 4\n 0 1e30 0 1\n' > far.rad
check_error 'a coordinate too far names its primitive' 1 '^ptrace: far.rad:2: .*coordinate' "
    ptrace $view -frames 1 far.rad > x"
printf 'void plastic mat 0 0 5 .5 .5 .5 0 0\nmat mesh m 3 t.obj -s 1e25 0 0\n' > far.rad
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' > t.obj
check_error 'that of a mesh or instance, too' 1 '^ptrace: far.rad:2: .*coordinate' "ptrace $view -frames 1 far.rad > x"
check_error '-e to a folder that is not there' 2 '^ptrace: nowhere/log: cannot be written' "
    ptrace -e nowhere/log $view -frames 1 good.rad > x"
check_error '-o without an ending is reported before the work' 1 '^ptrace: .*ending' "
    timeout 20 ptrace -vta -vh 180 -vv 180 -x 4096 -y 4096 -frames 20000 -o %d good.rad"
check_error 'and a folder that is not there' 2 '^ptrace: nowhere/' "
    timeout 20 ptrace $view -x 4096 -y 4096 -frames 20000 -o nowhere/%d.hdr good.rad"
check_error '-o wants a name' 1 "^ptrace: -o: " "ptrace $view -frames 1 -o '' good.rad > x"
check_error '-I with rows beyond int' 1 '^vcmetrics: -I: ' "vcmetrics -I 100 4294967297 4294967297 two.hdr"
[ -z "$NO_THREADS" ] ||
        check_error 'too little memory says so' 2 '^ptrace: memory: not enough|^ptrace: .*not enough memory' \
        "ulimit -v 140000; ptrace $view -device cpu -frames 1 good.rad > x"
check 'a non-blocking pipe loses nothing' '
    ptrace $view -x 128 -y 128 -frames 40 good.rad > straight
    cat > nonblock.py <<END
import fcntl, os, sys
for fd in (0, 1): fcntl.fcntl(fd, fcntl.F_SETFL, fcntl.fcntl(fd, fcntl.F_GETFL) | os.O_NONBLOCK)
os.execvp(sys.argv[1], sys.argv[1:])
END
    command -v python3 > /dev/null || exit 0
    python3 nonblock.py ptrace $view -x 128 -y 128 -frames 40 good.rad | { sleep 1; cat; } | cmp - straight
    (sleep 1; cat straight) | python3 nonblock.py ptaccum -last > /dev/null'
check_error 'a frame number beyond all' 1 'frames end at' "
    sed 's/^FRAME=0/FRAME=9223372036854775807/' two.hdr | ptaccum -last > x"
