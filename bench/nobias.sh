#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# Do aimed rays keep the mean?  bench/nobias.sh build/bin [scene ...]
# One line a scene and way of -sampling (WAYS): pictures of SEEDS seeds, FRAMES frames each, against as many of `plain`
# by other seeds: difference of the pictures' means and its standard error in percent; rms and largest of the
# differences of 16 x 16 pixels, each over its standard error, and how many blocks there are.  FIRST shifts the seeds.
# WITHOUT: a folder of other programs that render `plain`, such as those without a technique that this one has.
set -eu
bin=$(cd "$1" && pwd)
shift
[ $# -gt 0 ] || set -- office_clear_1400 office_blinds_1100 office_clear_overcast classroom_back_row gallery_east
cmake --build "$bin/.." --target picture_means > /dev/null
size=${SIZE:-64} frames=${FRAMES:-625} seeds=${SEEDS:-16} first=${FIRST:-501} ways=${WAYS:-reuse}
without=$(cd "${WITHOUT:-$bin}" && pwd) top=$(cd "$(dirname "$0")/.." && pwd)
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
export LUXPIPE_THREADS=1

words() { awk -F '\t' -v id="$1" -v column="$2" '$1 == id { print $column }' "$top/tests/golden/bits.tsv"; }
render() {  # programs sampling scene first-seed
    for ((k = 0; k < seeds; k++)); do
        "$1/ptrace" -w- -device cpu -x "$size" -y "$size" -sampling "$2" -seed $(($4 + k)) -frames "$frames" \
            $(words "$3" 3) | "$1/ptaccum" -last -ff > "$dir/$2.$k.hdr"
    done
}

echo "# $size x $size, $seeds seeds x $frames frames: mean over plain's %, its error %; blocks: rms z, largest z, count"
for scene; do
    cd "$top/$(words "$scene" 2)"
    render "$without" plain "$scene" $((first + 10000))
    for way in $ways; do
        render "$bin" "$way" "$scene" "$first"
        printf '%s %s\t' "$scene" "$way"
        "$bin/picture_means" 16 "$dir"/plain.*.hdr -- "$dir/$way".*.hdr
    done
done
