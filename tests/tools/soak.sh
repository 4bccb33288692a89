# SPDX-License-Identifier: BSD-3-Clause
# A long run of small frames: memory stays flat in every program of the pipe once ptrace makes as many frames at a time
# as it ever will, and each frame counts once.
# SOAK=100000 for the long one.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics mkstream
[ -r /proc/self/status ] || skip 'no /proc here'
frames=${SOAK:-8000}
export ASAN_OPTIONS=${ASAN_OPTIONS-}:quarantine_size_mb=0  # else the address sanitizer keeps what was freed
cat > room.rad << 'END'
void light l 0 0 3 9 9 9
l sphere s 0 0 4 0 5 0 1
void plastic w 0 0 5 .5 .5 .5 0 0
w bubble b 0 0 4 0 0 0 9
END
view='-vta -vp 0 0 0 -vd 0 1 0 -vu 0 0 1 -vh 180 -vv 180'

held() { mkstream show "$1" 2> /dev/null | sed 's/.*FRAMES=//; s/ .*//' | tail -n 1 | grep . || echo -1; }
await() { for ((i = 0; i < 6000; i++)); do [ "$(held "$1")" -ge "$2" ] && return; sleep .1; done; return 1; }
kilobytes() { sed -n 's/^VmHWM:[^0-9]*\([0-9]*\).*/\1/p' "/proc/$1/status"; }

check "$frames frames through ptrace, ptaccum and vcmetrics" '
    mkfifo frames sums; go() { exec "$@"; }
    go ptrace -w- $view -x 8 -y 8 -ab 2 room.rad > frames & trace=$!
    go ptaccum -every 20 -o sum.exr -o - < frames > sums & sum=$!
    go vcmetrics < sums > lines & measure=$!
    await sum.exr $((frames / 2)); for p in $trace $sum $measure; do kilobytes $p; done > first
    await sum.exr $frames; for p in $trace $sum $measure; do kilobytes $p; done > last
    s=0; kill -TERM $trace; wait $trace || s=$?; [ $s = 3 ]; wait $sum; wait $measure; cat first last >&2
    n=$(held sum.exr); [ $n -ge $frames ]; [ "$(tail -n 1 lines | cut -f 1)" = $n ];
    [ "$(wc -l < lines)" = $(((n + 19) / 20 + 2)) ]'
check 'memory at the end is that of the beginning' '
    paste first last | awk "{ n++; grown = grown || \$2 - \$1 > 2000 } END { exit grown || n != 3 }"'
