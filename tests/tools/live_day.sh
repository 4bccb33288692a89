# SPDX-License-Identifier: BSD-3-Clause
# luxpipe-live: glare by the hour of the date comes in idle time, is that of batch runs, and is dropped with the model.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics vcview luxpipe-live python3
cp "$TOP"/examples/scenes/office/* .
mkdir t; export TMPDIR=$PWD/t
luxpipe-live -vf view.vf -x 16 -y 16 -seed 5 materials.rad layout.rad blind.rad sky_day.rad > lines 2> said & live=$!
await() {
    for i in $(seq 1200); do eval "$1" && return; sleep .05; done
    echo "in vain: $1"; cat said; return 1
}
edited() { await "tail -n 1 lines | cut -f 3 | grep -qx $1"; }
ask() { python3 "$TOP/tests/tools/ask.py" "$@"; }  # METHOD PATH [body]
hours() { ask GET "/next?picture=99999&line=99999" | grep -ao '"day":{[^}]*}' > day; }
hour() { grep -o "\[$1,[^]]*\]" day | tr -d '[]' | cut -d , -f 2-; }
# as the second pipe renders it: DGPf and its interval
batch() {
    sed "s/!gensky 12 21 14/!gensky 12 21 $1/" sky_day.rad > sky_then.rad
    ptrace -w- ${2:--vf view.vf} -x 64 -y 64 -seed 5 -frames 9 materials.rad layout.rad ${3:-blind.rad} sky_then.rad |
        ptaccum -every 1 | vcmetrics -metrics Ev,DGPf -ci 95 | tail -n 1 | cut -f 6-8 | tr '\t' ,
}
near() {  # JSON has the digits of the table
    echo "$1 $2"
    awk -v a="$1" -v b="$2" 'BEGIN { n = split(a, p, ","); m = split(b, q, ",")
        for (k = 1; k <= n; k++) bad += (p[k] - q[k]) ^ 2 > 1e-10; exit bad || n != 3 || m != 3 }'
}
rest() { await '[ "$(tail -n 1 lines | cut -f 1)" -ge 32 ]' && ask POST /control pause > /dev/null; }  # good enough
await '[ $(wc -l < lines) -gt 2 ]'; rest
check 'hours come, the nearest to noon first' 'await "hours; [ -n \"\$(hour 11)\" ]"; [ -n "$(hour 12)" ]'
check 'they are those of a batch run of that hour' 'near "$(hour 12)" "$(batch 12)"; near "$(hour 11)" "$(batch 11)"'
check 'another model has other hours; the view is that of the page' '
    sed "s/-a 20/-a 35/" blind.rad > low.rad
    ask POST /control "view -vp 2 2.5 1.2" > /dev/null; edited 1
    then=$(hour 12); ask POST "/overlay?n=3&version=0&said=low" "$(cat low.rad)" > /dev/null
    hours; [ "$(hour 12)" != "$then" ]; edited 2; rest
    await "hours; [ -n \"\$(hour 12)\" ]"
    near "$(hour 12)" "$(batch 12 "-vta -vp 2 2.5 1.2 -vd 0 -1 -.08 -vu 0 0 1 -vh 180 -vv 180" low.rad)"'
check 'a click on an hour keeps them, another date does not' '
    sed "s/12 21 14/12 21 11/" sky_day.rad > then.rad
    then=$(hour 12); [ -n "$then" ]; ask POST "/overlay?n=4&version=0" "$(cat then.rad)
"  > /dev/null
    hours; [ "$(hour 12)" = "$then" ]
    ask POST "/overlay?n=4&version=1" "$(sed "s/12 21 11/6 21 11/" then.rad)" > /dev/null
    hours; [ "$(hour 12)" != "$then" ]'  # that of June is there at once, or not yet
check 'all programs end with the page, and nothing is left' '
    pgrep -f "$PWD/t/vcview"; kill $live; await "! kill -0 $live 2> /dev/null"; [ -z "$(ls t)" ]
    await "! pgrep -f $PWD/t/vcview"'
