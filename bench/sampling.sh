#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# Error against processor time of each way to aim diffuse rays: bench/sampling.sh build/bin [scene ...]
# One line a scene and way: seconds of one core, learning included, then the errors of bench/picture_error.cpp against
# REFERENCE frames of other seeds, then four efficiencies: squared error times seconds, of -sampling portals over this.
# Errors are rms over SEEDS runs of FRAMES frames.  With RADIANCE on PATH a line of rpict without its cache.
set -eu
bin=$(cd "$1" && pwd)
shift
[ $# -gt 0 ] || set -- office_clear_1400 office_blinds_1100 office_clear_overcast classroom_back_row gallery_east
cmake --build "$bin/.." --target picture_error > /dev/null
size=${SIZE:-128} frames=${FRAMES:-100} reference=${REFERENCE:-2000} seeds=${SEEDS:-3}
top=$(cd "$(dirname "$0")/.." && pwd)
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
export LUXPIPE_THREADS=1
TIMEFORMAT=%U

words() { awk -F '\t' -v id="$1" -v column="$2" '$1 == id { print $column }' "$top/tests/golden/bits.tsv"; }
# seconds of one core of a command whose output goes to a file
seconds() { local out=$1; shift; { time "$@" > "$out" 2> "$dir/log"; } 2>&1; }
render() {  # output sampling seed frames scene
    seconds "$dir/stream" "$bin/ptrace" -w- -device cpu -x "$size" -y "$size" -sampling "$2" -seed "$3" -frames "$4" \
        $(words "$5" 3)
    "$bin/ptaccum" -last -ff < "$dir/stream" > "$1"
}

echo "# $size x $size, $frames frames: seconds, median, trimmed rms, rms, blocks; efficiencies"
for scene; do
    cd "$top/$(words "$scene" 2)"
    : > "$dir/parts"
    for ((k = 0; k < 4; k++)); do
        render "$dir/part$k.hdr" guided $((1000 + k)) $((reference / 4)) "$scene" > "$dir/time"
    done
    "$bin/ptaccum" -last -ff "$dir"/part?.hdr > "$dir/reference.hdr"
    for way in portals plain guided; do
        for ((seed = 1; seed <= seeds; seed++)); do
            printf '%s\t' "$(render "$dir/picture.hdr" $way $seed "$frames" "$scene")"
            "$bin/picture_error" "$dir/reference.hdr" "$dir/picture.hdr"
        done > "$dir/$way"
        awk -F '\t' -v way="$scene $way" -v first="$way" -v known="$dir/first" '
            { time += $1; for (i = 2; i <= 5; i++) square[i] += $i * $i }
            END { if (first == "portals") for (i = 2; i <= 5; i++) printf "%g ", square[i] * time > known
                  else { getline line < known; split(line, base, " ") }
                  printf "%s\t%.2f", way, time / NR
                  for (i = 2; i <= 5; i++) printf "\t%.4f", sqrt(square[i] / NR)
                  for (i = 2; i <= 5; i++) printf "\t%.2f", first == "portals" ? 1 : base[i - 1] / (square[i] * time)
                  print "" }' "$dir/$way"
    done
    if command -v rpict oconv > /dev/null; then
        files=$(words "$scene" 3 | grep -oE '[^ ]+\.rad' | tr '\n' ' ') view=$(words "$scene" 3 | grep -oE '[^ ]+\.vf')
        oconv $files > "$dir/scene.oct"
        printf '%s rpict\t%s\t' "$scene" "$(seconds "$dir/picture.hdr" rpict -vf "$view" -x "$size" -y "$size" -ps 1 \
            -ab 5 -aa 0 -ad 10 "$dir/scene.oct")"
        "$bin/picture_error" "$dir/reference.hdr" "$dir/picture.hdr"
    fi
done
