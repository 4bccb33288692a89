#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# The cost of a grid of sensors by its number of points: bench/points.sh build/bin
# The office at 14:00, a plan .76 m over the floor, 16 frames, ptrace on one thread with its default sampling.  Tab
# separated lines: points, seconds of a core of ptrace, ptaccum and vcmetrics, MB of each at most, half of a point's
# interval over its value (median, %).  With gnuplot also points.svg.  docs/scale.md has both.
set -euo pipefail
bin=$(cd "$1" && pwd)
here=$PWD
office=$(cd "$(dirname "$0")/../examples/scenes/office" && pwd)
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$office"
scene=(materials.rad layout.rad sky_1400.rad)
export LUXPIPE_THREADS=1

# plan N: so many points
plan() {
    awk -v n="$1" 'BEGIN { k = int(sqrt(n) + .5); for (i = 0; i < n; i++)
        print .3 + 3.4 * (i % k + .5) / k, .3 + 4.4 * (int(i / k) + .5) * k / n, .76, 0, 0, 1 }'
}
costs() { /usr/bin/time -a -o "$dir/costs" -f '%U %S %M' "$bin/$@" 2> "$dir/log" || { cat "$dir/log" >&2; exit 1; }; }

echo "# points, s of each, MB of each, % of a point; $(nproc) cores, load $(cut -d ' ' -f 1 /proc/loadavg)"
for n in ${POINTS:-100 1000 10000 100000 1000000}; do
    rm -f "$dir/costs"
    plan "$n" > "$dir/plan.pts"
    costs ptrace -w- -frames 17 -points "$dir/plan.pts" "${scene[@]}" > "$dir/frames"
    costs ptaccum < "$dir/frames" > "$dir/sums"
    costs vcmetrics -W- -ci 95 < "$dir/sums" > "$dir/table"
    "$bin/vcmetrics" -W- -each < "$dir/sums" |
        awk 'NR > 1 && $3 > 0 { print 50 * ($5 - $4) / $3 }' | sort -g > "$dir/errors"
    error=$(awk '{ v[NR] = $1 } END { print v[int((NR + 1) / 2)] }' "$dir/errors")
    awk -v n="$n" -v error="$error" '{ s = s sprintf("\t%.2f", $1 + $2); m = m sprintf("\t%.0f", $3 / 1024) }
        END { printf "%d%s%s\t%.2g\n", n, s, m, error }' "$dir/costs"
done | tee "$dir/points.tsv"
if command -v gnuplot > /dev/null; then
    gnuplot << END
set terminal svg size 640,320 font 'sans,11' noenhanced background 'white'
set output '$here/points.svg'
programs = 'ptrace ptaccum vcmetrics'
set multiplot layout 1,2
set logscale xy; set grid; set xlabel 'points'; set key left top
set title 'seconds of a core, 16 frames'
plot for [k=2:4] '$dir/points.tsv' using 1:k with linespoints pt 7 ps .4 title word(programs, k - 1)
set title 'MB at most'
plot for [k=5:7] '$dir/points.tsv' using 1:k with linespoints pt 7 ps .4 title word(programs, k - 4)
END
fi
