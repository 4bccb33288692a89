#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# Is a build slower at equal error than another?  bench/before_after.sh build/bin old/bin [scene ...]
# A scene is a name from tests/golden/bits.tsv or `folder: words of ptrace`, so that scenes from elsewhere can be asked,
# too; without one five of ours and those that bench/foreign.sh can have, in FOREIGN (out/foreign).  A line each:
# seconds of one core, before and now, for FRAMES frames with the defaults of each; errors as in bench/sampling.sh of
# both; then squared error times seconds, before over now: above 1 the new build is faster.
# The last column is the difference of the mean pictures of the two in percent of the mean, with its standard error.
set -eu
new=$(cd "$1" && pwd) old=$(cd "$2" && pwd)
shift 2
cmake --build "$new/.." --target picture_error picture_means > /dev/null
size=${SIZE:-96} frames=${FRAMES:-64} reference=${REFERENCE:-1024} seeds=${SEEDS:-4}
top=$(cd "$(dirname "$0")/.." && pwd)
if [ $# = 0 ]; then
    mapfile -t foreign < <("$top/bench/foreign.sh" "${FOREIGN:-$top/out/foreign}")
    set -- office_clear_1400 office_blinds_1100 office_clear_overcast classroom_back_row gallery_east "${foreign[@]}"
fi
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
export LUXPIPE_THREADS=1
TIMEFORMAT=%U

words() { awk -F '\t' -v id="$1" -v column="$2" '$1 == id { print $column }' "$top/tests/golden/bits.tsv"; }
frames() {  # folder of programs, seed, frames, more options; the seconds go to a file
    { time "$1/ptrace" -w- -device cpu -x "$size" -y "$size" -seed "$2" -frames "$3" ${4:+$4} $arguments \
        2> "$dir/log"; } 2> "$dir/seconds"
}

echo "# $size x $size, $frames frames, $seeds seeds, reference $reference: s, errors, s and errors now; before over now"
for scene; do
    case $scene in
        *:*) folder=${scene%%:*} arguments=${scene#*: } ;;
        *) folder=$top/$(words "$scene" 2) arguments=$(words "$scene" 3) ;;
    esac
    cd "$folder"
    for ((k = 0; k < 4; k++)); do
        frames "$new" $((1000 + k)) $((reference / 4)) "-sampling reuse" | "$new/ptaccum" -last -ff > "$dir/part$k.hdr"
    done
    "$new/ptaccum" -last -ff "$dir"/part?.hdr > "$dir/reference.hdr"
    rm -f "$dir"/*.runs
    for ((seed = 1; seed <= seeds; seed++)); do
        for age in old new; do
            frames "${!age}" "$seed$([ $age = old ] || echo 9)" "$frames" > "$dir/stream"
            "$new/ptaccum" -last -ff < "$dir/stream" > "$dir/$age.$seed.hdr"
            printf '%s\t%s\n' "$(< "$dir/seconds")" \
                "$("$new/picture_error" "$dir/reference.hdr" "$dir/$age.$seed.hdr")" >> "$dir/$age.runs"
        done
    done
    folder=${scene%%:*}
    printf '%s' "${folder##*/}"
    awk '{ age = FILENAME ~ /old.runs$/; n[age]++; time[age] += $1
           for (i = 2; i <= 5; i++) square[age, i] += $i * $i }
         END { for (age = 1; age >= 0; age--) {
                   printf "\t%.2f", time[age] / n[age]
                   for (i = 2; i <= 5; i++) printf "\t%.4f", sqrt(square[age, i] / n[age])
               }
               for (i = 2; i <= 5; i++) printf "\t%.2f", square[1, i] * time[1] / (square[0, i] * time[0]) }' \
        "$dir/old.runs" "$dir/new.runs"
    printf '\t%s\n' "$("$new/picture_means" 16 "$dir"/old.?.hdr -- "$dir"/new.?.hdr | cut -f 1-2 | tr '\t' ' ')"
done
