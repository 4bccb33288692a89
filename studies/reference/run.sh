#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# run.sh BIN OUT [name ...]: renders the scenes of the reference pictures and compares.  FRAMES (4000) and BATCHES (16)
# set the amount of work; GOLDEN is a folder with other pictures to compare with (uncorrelated.sh).  Pictures in
# OUT are not made again, so the study can be interrupted and continued.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd) top=$(cd "$(dirname "$0")/../.." && pwd)
bin=$(cd "$1" && pwd) && mkdir -p "$2" && out=$(cd "$2" && pwd) && shift 2
frames=${FRAMES:-4000} batches=${BATCHES:-16}
known=$top/tests/golden/reference golden=${GOLDEN:-$known}
PATH=$bin:$PATH
[ $# -gt 0 ] || set -- $(cut -f 1 "$known/ev.tsv") gallery_west

view() {   # name -> view file
    case $1 in office_*) echo view.vf ;; *) echo "${1#*_}.vf" ;; esac
}
files() {  # name -> scene files
    if [ "$1" = gallery_west ]; then files gallery_east
    else awk -F '\t' -v name="$1" '$1 == name { print $4 }' "$known/ev.tsv"; fi
}
column() {
    awk -F '\t' -v name="$2" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) c = i } NR == 2 { print $c }' "$1"
}

table=$out/table.tsv
printf 'name\tframes\tblocks\twithin3\trms\tmean%%\t+-%%\tEv\tEv.ref\tdiff%%\t+-%%\tDGP\tDGP.evalglare\n' > "$table"
for name; do
    cd "$top/examples/scenes/${name%%_*}"
    parts=()
    for ((b = 0; b < batches; b++)); do
        first=$((b * frames / batches + (b > 0))) last=$(((b + 1) * frames / batches))
        part=$out/$name.$frames.$first-$last.exr
        parts+=("$part")
        [ -f "$part" ] && continue
        echo "$name: frames $first to $last" >&2
        ptrace -w- -ss 4 -vf "$(view "$name")" -x 256 -y 256 -ab 6 ${DEVICE:+-device $DEVICE} \
            -frames "$first:$last" $(files "$name") |
            ptaccum -last -o "$part"
    done
    ptaccum "${parts[@]}" -o "$out/$name.exr"
    vcmetrics "$out/$name.exr" > "$out/$name.metrics.tsv" || true      # a perspective view has no Ev
    result=$("$bin/study_reference_compare" "$golden/$name.hdr" "$golden/$name.blocks.tsv" "$out/$name.exr" \
        "${parts[@]}" 2> "$out/$name.blocks.log")
    awk -F '\t' -v OFS='\t' -v name="$name" -v frames="$frames" -v result="$result" \
        -v ev="$(column "$out/$name.metrics.tsv" Ev)" \
        -v dgp="$(column "$out/$name.metrics.tsv" DGP)" '
        FILENAME ~ /evalglare/ { if ($1 == name) { split($2, w, " "); glare = w[2] } next }
        $1 == name { known = $2; error = $3 }
        END { print name, frames, result, ev, known, known ? sprintf("%+.3f", 100 * (ev / known - 1)) : "", \
                    known ? sprintf("%.3f", 100 * error / known) : "", dgp, glare }' \
        "$known/evalglare.tsv" "$known/ev.tsv" | tee -a "$table"
done
