# SPDX-License-Identifier: BSD-3-Clause
# Runs with pictures of an action (ptrace -action) that are edited, cut off, gone on with, merged, or asked for a pixel.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics mkstream
printf 'void glow g 0 0 4 5 5 5 0\ng source sky 0 0 4 0 0 1 180\n' > sky.rad
wall() { printf "void plastic p 0 0 5 $1 0 0\np ring floor 0 0 8 0 0 -.1 0 0 1 0 9\n" > floor.rad; }
wall '.5 .5 .5'
eye='-vta -vp 0 0 1 -vd 0 1 0 -vu 0 0 1 -vv 180 -vh 180'
run() { ptrace -w- $eye -x 8 -y 8 -action mel "$@" sky.rad floor.rad; }

mkfifo ctl
exec 7<> ctl  # writing to it never waits for a reader
await() { for i in $(seq 200); do eval "$1" && return; sleep .05; done; echo "in vain: $1"; return 1; }
alone() {  # both pictures of the last edit are those of a run of its own, with ptrace's arguments
    run -frames 5 "$@" | ptaccum -last -o alone.exr; ptaccum -last -o is.exr < f || return
    for of in "" _mel; do [ "$(mkstream differ alone$of.exr is$of.exr)" = 0 ] || return; done
}
check 'an edit begins them anew, and the action follows; by a file, the view, and behind a preview' '
    { timeout 100 ptrace -w- $eye -x 8 -y 8 -action mel -frames 5 -watch -control ctl sky.rad floor.rad & echo $! > pid
      wait; } > f 2> said &
    await "alone 2> /dev/null"; wall ".7 .3 .1"; await "alone 2> /dev/null"
    for d in "1 0 0" ".5 1 0" "0 1 -.2"; do echo "view -vd $d" >&7; done; await "alone -vd 0 1 -.2 2> /dev/null"
    echo preview >&7; echo "view -vd -1 0 0" >&7; echo go >&7; await "alone -vd -1 0 0 2> /dev/null"
    strings f | grep "^EDIT=" | tail -1 | grep -q "view$"
    kill $(cat pid); wait'
exec 7>&-
check_error 'the ordinary picture has an end' 1 '^ptrace: -frames: say how many frames each picture gets$' '
    run -watch > x'

check 'a pixel under D65 is that of the luminance, under A .4957 of it' '
    wall ".5 .5 .5"
    pixel() { ptrace -w- $eye -x 8 -y 8 -pixel 4,1 -frames 9 "$@" sky.rad floor.rad | grep "^pixel" | cut -f 3; }
    pixel > plain; paste <(pixel -action mel) <(pixel -action mel -daylight A) plain |
        awk "{ exit !((\$1/\$3 - 1)^2 < 1e-8 && (\$2/\$3/.4957 - 1)^2 < 1e-4) }"'

run -seed 7 -frames 9 | ptaccum -last -o run.exr; run -seed 7 -frames 17 | ptaccum -last -o whole.exr
check 'sums go on, each with its own frames' '
    run -after run.exr -frames 17 > rest.str; ptaccum -last -o rest.exr < rest.str
    for of in "" _mel; do
        ptaccum run$of.exr rest$of.exr -o both.exr; [ "$(mkstream differ both$of.exr whole$of.exr)" = 0 ]
    done'
check_error 'not one with those of the other' 1 '^ptaccum: stdin: picture 9: frame 9: has action mel of 9 bands in lx' '
    ptaccum run.exr - -o x.exr < rest.str'
check 'a year that was cut off goes on, whatever picture it was cut in' '
    printf "place x\nlatitude 39.74\nlongitude 105.18\ntime_zone 105\nsite_elevation 1829\n" > y.wea
    printf "weather_data_file_units 1\n" >> y.wea
    for h in 5.5 8.5 12.5 15.5; do echo "6 21 $h 700 90"; done >> y.wea
    hours() { ptrace -w- $eye -x 8 -y 8 -action mel -wea y.wea -frames 5 "$@" floor.rad 2> said; }
    table() { ptaccum -every x2/4 | vcmetrics -W- -metrics Ev,mEDI -ci 95 -last; }
    hours > whole.str; table < whole.str > whole.tsv
    for share in 30 45 60 75 90; do
        head -c $(($(wc -c < whole.str) * share / 100 + 37)) whole.str | { table 2> said || true; } > cut.tsv
        hours -after cut.tsv | table | sed 1d >> cut.tsv; cut -f 3- cut.tsv | cmp - <(cut -f 3- whole.tsv)
    done'
