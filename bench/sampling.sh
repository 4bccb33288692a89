#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# Error against processor time of each value of -sampling, and of rpict: bench/sampling.sh build/bin [scene ...].  The
# errors (bench/picture_error.cpp) after 0, 1, 2, 4 ... FRAMES diffuse frames are rms over SEEDS runs, against
# REFERENCE frames of other seeds (-sampling reuse), whose own noise (half of the difference of its halves) is printed
# and subtracted in squares.  Seconds are ptrace's alone on one core, from its start, learning included: measured at
# frames 0, 4 and FRAMES, a straight line between them.  The curves stay in OUT (out/sampling), with a plot of each
# scene; bench/sampling.awk makes the table.  With RADIANCE on PATH rpict takes part, with its cache (cached) and
# without. REFERENCES names a folder where references are kept and found again.
set -eu
bin=$(cd "$1" && pwd)
shift
[ $# -gt 0 ] || set -- office_clear_1400 office_blinds_1100 office_clear_overcast classroom_back_row gallery_east
cmake --build "$bin/.." --target picture_error > /dev/null
size=${SIZE:-128} frames=${FRAMES:-256} reference=${REFERENCE:-1024} seeds=${SEEDS:-2}
ways=${WAYS:-reuse portals plain}
bench=$(cd "$(dirname "$0")" && pwd) top=$(dirname "$(cd "$(dirname "$0")" && pwd)")
out=${OUT:-$top/out/sampling}
mkdir -p "$out" ${REFERENCES:+"$REFERENCES"}
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
export LUXPIPE_THREADS=1
TIMEFORMAT=%U

words() { awk -F '\t' -v id="$1" -v column="$2" '$1 == id { print $column }' "$top/tests/golden/bits.tsv"; }
# frames of a scene: sampling, seed, number of diffuse frames; the seconds go to a file
frames() {
    { time "$bin/ptrace" -w- -device cpu -x "$size" -y "$size" -sampling "$1" -seed "$2" -frames 0:"$3" \
        $(words "$scene" 3) 2> "$dir/log"; } 2> "$dir/seconds"
}
# Four runs are the reference; its halves tell its noise.
make_reference() {
    kept=${REFERENCES:-$dir}/$scene.$size.$reference
    if [ ! -s "$kept.noise" ]; then
        for k in 0 1 2 3; do
            frames reuse $((1000 + k)) $((reference / 4)) | "$bin/ptaccum" -last -ff > "$dir/part$k.hdr"
        done
        "$bin/ptaccum" -last -ff "$dir"/part?.hdr > "$kept.hdr"
        "$bin/ptaccum" -last -ff "$dir"/part[01].hdr > "$dir/half0.hdr"
        "$bin/ptaccum" -last -ff "$dir"/part[23].hdr > "$dir/half1.hdr"
        "$bin/picture_error" "$dir/half0.hdr" "$dir/half1.hdr" |
            awk -v OFS='\t' '{ print $1 / 2, $2 / 2, $3 / 2, $4 / 2 }' > "$kept.noise"
    fi
}
# lines of: number of frames, seconds, four errors
curve() {  # way seed
    frames "$1" "$2" 0 > "$dir/stream"
    start=$(< "$dir/seconds")
    frames "$1" "$2" 4 > "$dir/stream"
    fourth=$(< "$dir/seconds")
    frames "$1" "$2" "$frames" | "$bin/ptaccum" -every x2 -ff | "$bin/picture_error" "$kept.hdr" - > "$dir/errors"
    awk -v OFS='\t' -v n="$frames" -v start="$start" -v fourth="$fourth" -v end="$(< "$dir/seconds")" '
        { at = NR == 1 ? 0 : 2 ^ (NR - 2); if (at > n) at = n
          print at, at < 4 ? start + (fourth - start) * at / 4 : fourth + (end - fourth) * (at - 4) / (n - 4), $0 }' \
        "$dir/errors"
}
# one line as those of a curve: options of rpict
rpict_line() {
    local view
    view=$(words "$scene" 3 | grep -oE '[^ ]+\.vf')
    oconv $(words "$scene" 3 | grep -oE '[^ ]+\.rad') > "$dir/scene.oct"
    { time rpict -vf "$view" -x "$size" -y "$size" -ps 1 -ab 5 "$@" "$dir/scene.oct" 2> "$dir/log" \
        > "$dir/picture.hdr"; } 2> "$dir/seconds"
    printf '1\t%s\t%s\n' "$(< "$dir/seconds")" "$("$bin/picture_error" "$kept.hdr" "$dir/picture.hdr")"
}

echo "# $size x $size, $seeds seeds, reference $reference frames: frames, seconds, median, trimmed rms, rms, blocks"
for scene; do
    cd "$top/$(words "$scene" 2)"
    make_reference
    rm -f "$out/$scene".*.tsv
    for way in $ways; do
        for ((seed = 1; seed <= seeds; seed++)); do curve "$way" "$seed"; done > "$dir/runs"
        awk -f "$bench/sampling_mean.awk" "$kept.noise" "$dir/runs" > "$out/$scene.$way.tsv"
    done
    if command -v rpict oconv > /dev/null; then
        rpict_line -aa 0 -ad 10 > "$dir/runs"
        awk -f "$bench/sampling_mean.awk" "$kept.noise" "$dir/runs" > "$out/$scene.rpict.tsv"
        rpict_line -aa .15 -ad 1024 -as 256 -ar 128 > "$dir/runs"
        awk -f "$bench/sampling_mean.awk" "$kept.noise" "$dir/runs" > "$out/$scene.cached.tsv"
    fi
    printf '%s reference\t%d\t\t%s\n' "$scene" "$reference" "$(< "$kept.noise")"
    (cd "$out" && awk -f "$bench/sampling.awk" $(printf '%s\n' rpict cached plain portals reuse |
        sed "s/.*/$scene.&.tsv/" | while read -r f; do [ ! -s "$f" ] || echo "$f"; done))
done
if command -v gnuplot > /dev/null; then (cd "$out" && bash "$bench/sampling_plot.sh" "$@"); fi
