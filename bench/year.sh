#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# Measures the cost of a year by hours, views and points: bench/year.sh build/bin
# Processor seconds, the system's included, of ptrace, ptaccum and vcmetrics, each on one thread: lit hours of the
# office under made-up weather, nine frames of 64 x 64 pixels a view, or of a plan of points.  A line a measurement,
# tab separated: hours, views, points, seconds of each program, of an hour and of a view's hour, MB of the largest
# program; medians of RUNS turns.  OUT (out/year_price) gets year_price.svg (studies/year/README.md) if gnuplot is
# there.
set -euo pipefail
bin=$(cd "$1" && pwd)
top=$(cd "$(dirname "$0")/.." && pwd)
runs=${RUNS:-3} out=${OUT:-$top/out/year_price}
mkdir -p "$out" && out=$(cd "$out" && pwd)
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
python3 "$top/studies/year/weather.py" > "$dir/site.epw"
cd "$top/examples/scenes/office"
export LUXPIPE_THREADS=1

# Words of -hours for so many: two, or all from 8 to 18 of days from April to September.
hours() {
    [ "$1" -ge 10 ] || { echo "0421 12-$((12 + $1))"; return; }
    for ((day = 0; day < $1 / 10; day++)); do printf '%02d%02d ' $((4 + day % 6)) $((1 + day / 6 * 9)); done
    echo 8-18
}
desks() {
    awk -v n="$1" 'BEGIN { for (k = 0; k < n; k++) { a = 6.2832 * k / n
        printf "rvu -vta -vp %.3f %.3f 1.2 -vd %.3f %.3f -.08 -vu 0 0 1 -vh 180 -vv 180\n",
            1 + k % 10 / 5, 1 + 3 * int(k / 10) / 10, sin(a), -cos(a) } }'
}
plan() {
    awk -v n="$1" 'BEGIN { k = int(sqrt(n) + .5); for (i = 0; i < n; i++)
        print .3 + 3.4 * (i % k + .5) / k, .3 + 4.4 * (int(i / k) + .5) * k / n, .76, 0, 0, 1 }'
}
costs() { /usr/bin/time -a -o "$dir/costs" -f '%U %S %M' "$bin/$@" 2> "$dir/log" || { cat "$dir/log" >&2; exit 1; }; }
turn() {  # hours, words of ptrace, words of vcmetrics
    rm -f "$dir/costs"
    # shellcheck disable=SC2086
    costs ptrace -w- -wea "$dir/site.epw" -hours "$(hours "$1")" -frames 9 $2 materials.rad layout.rad > "$dir/frames"
    costs ptaccum -every x2/8 < "$dir/frames" > "$dir/sums"
    # shellcheck disable=SC2086
    costs vcmetrics -W- $3 < "$dir/sums" > "$dir/table"
    awk '{ s[NR] = $1 + $2; all += s[NR]; if ($3 > most) most = $3 }
        END { print all, s[1], s[2], s[3], most / 1024 }' "$dir/costs"
}
measure() {  # hours, views, points
    plan "$3" > "$dir/plan.pts"
    desks "$2" > "$dir/desks.vf"
    local words="-points $dir/plan.pts" metrics=-each
    [ "$2" = 0 ] || words="-views $dir/desks.vf -x 64 -y 64" \
        metrics='-metrics Ev,DGPf,DGP.px,DGPf.px,pixels -ci 95 -last'
    for ((run = 0; run < runs; run++)); do turn "$1" "$words" "$metrics"; done | sort -g |
        awk -v h="$1" -v views="$2" -v points="$3" -v middle=$(((runs + 1) / 2)) 'NR == middle {
            printf "%d\t%d\t%d\t%.2f\t%.2f\t%.2f\t%.4f\t%.4f\t%.0f\n", h, views, points, $2, $3, $4, $1 / h,
                $1 / h / (views > 0 ? views : 1), $5 }'
}

echo "# $runs runs; $(nproc) cores, load $(cut -d ' ' -f 1 /proc/loadavg)"
for h in 10 40 160; do measure $h 1 0; done | tee "$out/hours.tsv"
for n in 1 10 100; do measure 2 $n 0; done | tee "$out/views.tsv"
for n in 10 100 1000 10000; do measure 2 0 $n; done | tee "$out/points.tsv"
command -v gnuplot > /dev/null || exit 0
cd "$out" && gnuplot << 'END'
set terminal svg size 900,300 font 'sans,11' noenhanced background 'white'
set output 'year_price.svg'
set multiplot layout 1,3
set logscale xy; set grid; set key off
set title 'seconds of a core'; set xlabel 'hours of one view'
plot 'hours.tsv' using 1:($7 * $1) with linespoints pt 7 ps .5
set title 'seconds of a core an hour'; set xlabel 'views'
plot 'views.tsv' using 2:7 with linespoints pt 7 ps .5
set xlabel 'points'
plot 'points.tsv' using 3:7 with linespoints pt 7 ps .5
END
