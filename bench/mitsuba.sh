#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# One core beside Mitsuba 3 on a plain room (bench/plain_room.py): bench/mitsuba.sh build/bin
# A line a renderer: millions of samples a second of processor time, seconds for SAMPLES samples a pixel, errors as in
# bench/picture_error.cpp against a long run of the same renderer, rms over SEEDS runs; then squared error times
# seconds, Mitsuba's over that of `portals`.  PYTHON names a Python that has Mitsuba; without one nothing is measured.
set -eu
bin=$(cd "$1" && pwd)
bench=$(cd "$(dirname "$0")" && pwd)
python=${PYTHON:-python3}
if ! "$python" -c 'import mitsuba' 2> /dev/null; then
    echo "# mitsuba.sh: no Mitsuba 3 for $python: not measured"
    exit 0
fi
cmake --build "$bin/.." --target picture_error > /dev/null
size=${SIZE:-128} samples=${SAMPLES:-64} reference=${REFERENCE:-2048} seeds=${SEEDS:-5}
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
export LUXPIPE_THREADS=1
TIMEFORMAT=%U
"$python" "$bench/plain_room.py" write "$dir"
view=$("$python" "$bench/plain_room.py" view)

ours() {  # sampling seed samples output; prints seconds
    { time "$bin/ptrace" -w- -device cpu -x "$size" -y "$size" -ab 5 -sampling "$1" -seed "$2" -frames 0:"$3" $view \
        "$dir/office.rad" > "$dir/stream" 2> "$dir/log"; } 2>&1
    "$bin/ptaccum" -last -ff < "$dir/stream" > "$4"
}
theirs() {  # variant seed samples output; prints seconds
    timeout 600 "$python" "$bench/plain_room.py" render "$dir" "$1" "$size" "$3" "$2"
    mv "$dir/$1.$2.exr" "$4"
}
measure() {  # ours or theirs, its way, file of the reference
    for ((seed = 1; seed <= seeds; seed++)); do
        took=$("$1" "$2" "$seed" "$samples" "$dir/picture.exr")
        printf '%s\t%s\n' "$took" "$("$bin/picture_error" "$3" "$dir/picture.exr")"
    done | awk -v OFS='\t' -v known="$dir/first" -v all=$((size * size * samples)) -v name="$2" '
        { time += $1; for (i = 2; i <= 5; i++) square[i] += $i * $i }
        END { line = sprintf("%s\t%.2f\t%.2f", name, all * NR / time / 1e6, time / NR)
              for (i = 2; i <= 5; i++) line = line sprintf("\t%.4f", sqrt(square[i] / NR))
              if ((getline base < known) > 0) split(base, first, " ")
              else for (i = 2; i <= 5; i++) {
                  first[i] = square[i] * time
                  printf "%s%g", i == 2 ? "0 " : " ", first[i] > known
              }
              for (i = 2; i <= 5; i++) line = line sprintf("\t%.2f", square[i] * time / first[i])
              print line }'
}

echo "# plain room, $size x $size, $samples samples, $seeds seeds: Msamples/s, s, four errors; over portals"
ours reuse 1001 "$reference" "$dir/ours.hdr" > "$dir/seconds"
theirs llvm_ad_rgb 1001 "$reference" "$dir/theirs.exr" > "$dir/seconds"
measure ours portals "$dir/ours.hdr"
measure ours reuse "$dir/ours.hdr"
measure theirs scalar_rgb "$dir/theirs.exr"
measure theirs llvm_ad_rgb "$dir/theirs.exr"
