# SPDX-License-Identifier: BSD-3-Clause
# docs/promise.md: the names in promise.txt are all there, in the programs and in their pages.  A name is added there
# when it is released; none is taken out before 1.0.
. "${TOP:?}/tests/lib.sh"
needs mandoc ptrace ptaccum vcmetrics vcregion vcyear vcview luxpipe-live

promised() {  # KIND PROGRAM: the names, one a line
    awk -v kind="$1" -v program="$2" '$1 == kind && $2 == program { for (i = 3; i <= NF; i++) print $i }' \
        "$TOP/tests/docs/promise.txt"
}
none_lost() {  # KIND PROGRAM FILE: each promised name is a word of the file
    promised "$1" "$2" > names; [ -s names ]
    tr -s ' ,\t\n' '\n' < "$3" | sort -u > words
    sort -u names | comm -23 - words > lost
    sed "s/^/$1 of $2 is lost: /" lost >&2; [ ! -s lost ]
}
page() { mandoc -T ascii -O width=1000 "$TOP/man/$1" | sed 's/.\x08//g'; }

for tool in ptrace ptaccum vcmetrics vcregion vcyear vcview luxpipe-live; do
    $tool -help all | sed -nE 's/^  (-[A-Za-z0-9].*)/\1/p' | sed -E 's/  .*//; s/, ?-/\n-/g' |
        sed -E 's/[^A-Za-z0-9_-].*//; s/-$//' > $tool.options
    check "$tool: every promised option is in -help" "none_lost option $tool $tool.options"
done
check 'vcmetrics: every promised metric is in -help' '
    vcmetrics -help | sed -n "/^  -metrics/,/^  -each/p" | tr -d . > help; none_lost metric vcmetrics help'

# a view, two hours of a state; one picture that is edited; sensors; sources; a comparison
cp "$TOP"/examples/scenes/office/*.{rad,wea,vf} .
room='materials.rad layout.rad'
echo "VIEW= desk $(sed 's/^rvu //' view.vf)" > desk.vf
tables() {
    ptrace -w- -views desk.vf -wea days.wea -hours 'Mo-Fr 12-13' -state open -state shut=blind.rad -x 8 -y 8 \
        -frames 17 $room | tee hours.stream | ptaccum -every x2/8 |
        vcmetrics -W- -metrics Ev,DGPf,DGP.px,DGPf.px,pixels -ci 95 -halves -last > hours.tsv
    ptrace -w- -vf view.vf -x 8 -y 8 -frames 17 $room sky_1400.rad |
        sed '1,/#?RADIANCE/s/#?RADIANCE/&\nEDIT=0 start/' | ptaccum -every x2/8 -o sum.exr -o sum.hdr -o - |
        vcmetrics -W- -metrics Ev -ci 95 -until 'Ev 1%' -go-on -against previous > edits.tsv
    echo '2 2 .8 0 0 1' > desk.pts
    ptrace -w- -points desk.pts -frames 17 $room sky_1400.rad | tee points.stream | ptaccum -every x2/8 |
        vcmetrics -W- -each -ci 95 > sensors.tsv
    vcmetrics -W- -sources sum.exr > sources.tsv
    vcmetrics -W- -metrics Ev -difference sum.exr sum.exr > difference.tsv
    vcyear -state open -next hours.tsv > next.tsv
    vcyear -shades 'glare .4' -moves moves.tsv hours.tsv > shades.txt
}
tables 2> said || cat said
for table in hours edits sensors sources difference next moves; do
    head -n 1 $table.tsv > $table.header
    check "$table: every promised column is in the table" "none_lost column $table $table.header"
done

page luxpipe-stream.5 | grep -oE '[A-Z_0-9]+=' > page_lines
check 'every promised line of a stream is in luxpipe-stream(5)' 'none_lost line page page_lines'
cat hours.stream points.stream sum.exr | strings | grep -oE '^[A-Z_0-9]+=' > stream_lines
check 'and those of a stream are in streams' 'none_lost line stream stream_lines'

for case in 'fine       vcmetrics -metrics Ev sum.exr' 'input      vcmetrics -metrics none sum.exr' \
    'system     vcmetrics no_such.hdr' 'rule       vcmetrics -until "Ev 0.001%" sum.exr' \
    'difference vcmetrics -difference -metrics Ev -tolerance "Ev 0.0001%" sum.exr sum.hdr'; do
    read -r what command <<< "$case"
    check_exit "the promised status: $what" "$(promised status "$what")" "$command"
done

check 'a name that is lost is seen' '
    grep -v -e "^-next$" vcyear.options > fewer
    not none_lost option vcyear fewer 2> said; grep -qx "option of vcyear is lost: -next" said'
