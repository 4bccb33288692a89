# SPDX-License-Identifier: BSD-3-Clause
# Signals and kills: the first SIGINT or SIGTERM finishes the frame and writes what there is (status 3), the second
# ends at once; a sum in a file survives a kill at any moment, and a run goes on from it.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics mkstream
cat > room.rad << 'END'
void light l 0 0 3 9 9 9
l sphere s 0 0 4 0 5 0 1
void plastic w 0 0 5 .5 .5 .5 0 0
w bubble b 0 0 4 0 0 0 9
END
view='-vta -vp 0 0 0 -vd 0 1 0 -vu 0 0 1 -vh 180 -vv 180'
render() { exec ptrace $view -x 32 -y 32 -ab 2 "$@" room.rad; }

# Waits until a file has come and holds at least so many frames.
await() {
    for ((i = 0; i < 600; i++)); do held "$1" | awk -v n="$2" '{ exit !($1 >= n) }' && return; sleep .1; done
    return 1
}
held() { mkstream show "$1" 2> /dev/null | sed 's/.*FRAMES=//; s/ .*//' | tail -n 1 | grep . || echo -1; }
# Sends a signal and gives the status of the process.
stop() { kill -"$1" "$2"; wait "$2"; }

for signal in INT TERM HUP; do
    check "ptaccum: SIG$signal leaves the sum in -o, status 3" "
        mkfifo $signal; (mkstream frames 0 4; sleep 60) > $signal & feeder=\$!
        (trap - INT; exec ptaccum -last -o $signal.exr < $signal) & sum=\$!
        sleep 1; s=0; stop $signal \$sum || s=\$?; kill \$feeder; [ \$s = 3 ];
        mkstream show $signal.exr | grep -q 'FRAMES=4 RANGE=0:4 '"
done
check 'ptaccum: likewise on stdout, stream or picture' '
    mkfifo a; (mkstream frames 0 4; sleep 60) > a & feeder=$!; ptaccum -last < a > last.hdr & sum=$!
    sleep 1; s=0; stop TERM $sum || s=$?; kill $feeder; [ $s = 3 ];
    mkstream show last.hdr | grep -q "FRAMES=4 RANGE=0:4 "
    mkfifo b; (mkstream frames 0 4; sleep 60) > b & feeder=$!; ptaccum -every 3 < b > some.hdr & sum=$!
    sleep 1; s=0; stop TERM $sum || s=$?; kill $feeder; [ $s = 3 ];
    mkstream show some.hdr | tail -n 1 | grep -q "FRAMES=4 RANGE=0:4 "'
check 'ptaccum: inside a frame a first signal waits for the rest, a second does not' '
    mkfifo c; (mkstream frames 0 1 64 64 | head -c 60000; sleep 60) > c & feeder=$!;
    ptaccum -last -o two.exr < c & sum=$!
    sleep 1; kill -TERM $sum; sleep .5; kill -0 $sum; s=0; stop TERM $sum || s=$?; kill $feeder; [ $s = 3 ];
    [ ! -e two.exr ] && ! ls -A | grep tmp'
check 'ptrace: whole frames, status 3' '
    render -frames 1000000 > frames.hdr & p=$!
    for ((i = 0; i < 600; i++)); do [ -s frames.hdr ] && break; sleep .1; done
    s=0; stop TERM $p || s=$?; [ $s = 3 ]; ptaccum -last -o f.exr frames.hdr 2> said && exit 1;
    grep -q "^ptaccum: frames.hdr: ends after frame .*up to 999999" said
    [ "$(wc -l < said)" = 1 ]; mkstream show f.exr | grep -q "RANGE=0:"'
check 'vcmetrics: whole lines, status 3' '
    mkfifo d; (mkstream frames 0 3 32 32 | ptaccum; sleep 60) > d & feeder=$!; vcmetrics < d > lines & m=$!
    for ((i = 0; i < 600; i++)); do [ "$(wc -l < lines)" = 5 ] && break; sleep .1; done
    s=0; stop TERM $m || s=$?; kill $feeder; [ $s = 3 ]; [ "$(wc -l < lines)" = 5 ]'
check 'a pipe that Ctrl-C ends keeps its picture and prints nothing' '
    (trap - INT; exec setsid timeout 60 bash -c "ptrace $view -x 32 -y 32 room.rad 2> said |
        ptaccum -every 1 -o whole.exr -o - 2>> said | vcmetrics > t 2>> said") & g=$!
    await whole.exr 3; kill -INT -- -$g; wait $g || true
    for ((i = 0; i < 100; i++)); do pgrep -s $g > /dev/null || break; sleep .1; done;
    [ ! -s said ] && await whole.exr 3 && ! ls -A | grep "[.]tmp"'

check '-o is written again at each -every' '
    mkfifo e; (mkstream frames 0 9; sleep 60) > e & feeder=$!; ptaccum -every 4 -o each.exr < e & sum=$!
    await each.exr 8; [ "$(held each.exr)" = 8 ]; kill -9 $sum; kill $feeder; wait; [ "$(held each.exr)" = 8 ]'
check '-o is watched without -every, too' '
    mkfifo w; (mkstream frames 0 9; sleep 60) > w & feeder=$!; ptaccum -o watch.exr < w & sum=$!; await watch.exr 0;
    kill -9 $sum; kill $feeder; wait'
check 'a killed ptrace is an error of its reader; the picture so far is kept' '
    (render -frames 1000000 & p=$!; sleep 1.5; kill -9 $p) | ptaccum -last -o k.exr 2> said && exit 1
    grep -q "^ptaccum: stdin: \(ends after frame\|picture .* input ends\)" said;
    mkstream show k.exr | grep -q "RANGE=0:"'
announced() { mkstream frames 0 8 32 32 | sed "s/^SEED=/LASTFRAME=99\n&/"; }
check 'which is told once: the metrics behind it end with status 1 as well' '
    { { announced | ptaccum | vcmetrics -W- > t; echo "${PIPESTATUS[*]}" > ends; } || :; } 2> said
    [ "$(cat ends)" = "0 1 1" ]; cat said
    [ "$(wc -l < said)" = 1 ]; grep -q "^ptaccum: stdin: ends after frame 8, .*up to 99" said; [ "$(wc -l < t)" = 10 ]'
check 'a killed ptaccum is an error of the metrics' '
    : > killed; mkfifo f; (announced; sleep 60) > f & feeder=$!
    { ptaccum < f & sum=$!; for ((i = 0; i < 600; i++)); do [ "$(wc -l < killed)" = 10 ] && break; sleep .1; done
      kill -9 $sum; } | vcmetrics -W- > killed 2> said && exit 1
    kill $feeder; cat said; [ "$(wc -l < said)" = 1 ]; grep -q "^vcmetrics: stdin: ends after frame 8, .*up to 99" said'

check 'killed at random moments and resumed, a sum has every frame once' '
    mkstream frames 0 0 | ptaccum -last -o r.exr; kills=0
    while [ "$(held r.exr)" -lt 3000 ]; do
        next=$(($(held r.exr) + 1))
        mkstream frames $next 3000 2> /dev/null | ptaccum r.exr - -every 1 -o r.exr & sum=$!
        sleep .0$((RANDOM % 10))$((RANDOM % 10)); sleep .1; kill -9 $sum 2> /dev/null && kills=$((kills + 1));
        wait $sum || true
    done
    [ $kills -gt 2 ]; mkstream frames 0 3000 | ptaccum -last -o once.exr
    mkstream show r.exr | grep -q "FRAMES=3000 RANGE=0:3000 ";
    mkstream differ r.exr once.exr | awk "{ exit !(\$1 <= 1e-6) }"'
