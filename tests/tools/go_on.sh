# SPDX-License-Identifier: BSD-3-Clause
# Runs that were cut off are known from whole ones, and go on (ptrace -after): years from their tables, sums from files.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics vcyear
office=$TOP/examples/scenes/office
{
    printf 'place Here\nlatitude 39.74\nlongitude 105.18\ntime_zone 105\n'
    printf 'site_elevation 1829\nweather_data_file_units 1\n'
    for month in 1 2 3; do for hour in 5.5 9.5 12.5 15.5; do echo "$month 21 $hour 700 90"; done; done
} > y.wea
printf 'VIEW= a -vta -vp 2 2.7 1.2 -vd 0 -1 0 -vu 0 0 1 -vh 180 -vv 180\n' > two.vf
sed 's/ a / b /; s/-vd 0/-vd 1/' two.vf > b.vf; cat b.vf >> two.vf
frames() { ptrace -w- -x 16 -y 16 -wea y.wea -frames 9 "$@" $office/materials.rad $office/layout.rad 2> said; }
table() { ptaccum -every x2/8 | vcmetrics -W- -metrics Ev,DGPf,DGP.px,DGPf.px,pixels -ci 95 -last; }
frames -views two.vf > whole.str; table < whole.str > whole.tsv; vcyear whole.tsv > whole
cut_off() { { head -c $(($(wc -c < whole.str) * 7 / 10)) whole.str | ptaccum -every x2/8 2> said || true; } |
    { vcmetrics -W- -metrics Ev,DGPf,DGP.px,DGPf.px,pixels -ci 95 -last || true; } > cut.tsv; }

check 'rows say which of how many hours they are, also in parts, and named ones do not' '
    [ "$(awk "{ print \$NF }" whole.tsv | sed 1d | tr "\n" " ")" = "$(for v in a b; do printf "%s/12 " {1..12}; done)" ]
    frames -views two.vf -hours 2/3 | table | awk "{ print \$NF }" | sed 1d | sort -u | tr "\n" " " > part
    [ "$(cat part)" = "5/12 6/12 7/12 8/12 " ]
    frames -views two.vf -hours "0121_0930 0221_1230" | table > named.tsv
    [ "$(awk "{ print \$NF }" named.tsv | sort -u | tr "\n" " ")" = "- hour " ]
    vcyear named.tsv | not grep -q " of 12"'
check 'a year that was cut off says so, and goes on to what the whole one is' '
    cut_off; vcyear cut.tsv > cut
    grep -qx "hours     12, 3 dark.*" cut; grep -q "^hours     [4-9] of 12, " cut
    grep -q "EN 17037 .*, of these hours alone$" cut
    [ "$(tail -n 1 cut)" = "the rest  ptrace ... -after cut.tsv" ]
    vcyear -command "ptrace -vf a.vf" cut.tsv | tail -n 1 | grep -qx "the rest  ptrace -after cut.tsv -vf a.vf"
    vcyear -format tsv cut.tsv | awk -F "\t" "NR == 1 { exit \$NF != \"to_come\" }"
    frames -views two.vf -after cut.tsv > rest; grep -q "^ptrace: 1[6-9] of 24 hours are there$" said
    table < rest >> cut.tsv; vcyear cut.tsv | cmp - whole'
check 'likewise hours apart, where the dark ones come in their turn' '
    frames -hours-apart -vf b.vf | table > whole_apart.tsv
    sed 5q whole_apart.tsv > five.tsv; cp five.tsv apart.tsv
    frames -hours-apart -vf b.vf -after five.tsv | table | sed 1d >> apart.tsv
    cut -f 3- whole_apart.tsv | cmp - <(cut -f 3- apart.tsv)'
check_error 'nothing is left' 1 '^ptrace: -after: all 24 hours are there$' '
    frames -views two.vf -after whole.tsv > x || { tail -n 1 said >&2; exit 1; }'
check_error 'a table that ends within a line is not gone on with' 1 '^ptrace: t.tsv:13: has fewer columns' '
    head -c $(($(sed 12q whole.tsv | wc -c) + 20)) whole.tsv > t.tsv
    frames -views two.vf -after t.tsv > x || { tail -n 1 said >&2; exit 1; }'
check 'a part alone is told, not refused; sensors likewise' '
    frames -views two.vf -hours 2/3 | table | vcyear - | grep -q "^hours     4 of 12, "
    echo "2 2 .8 0 0 1" > desk.pts
    frames -points desk.pts | ptaccum -every x2 | vcmetrics -W- -each > all.tsv; sed 6q all.tsv > some.tsv
    vcyear some.tsv > some; grep -qx "hours     5 of 12, 2 dark, 1 sensors" some
    [ "$(tail -n 1 some)" = "the rest  ptrace ... -after some.tsv" ]
    frames -points desk.pts -after some.tsv | ptaccum -every x2 | vcmetrics -W- -each >> some.tsv
    vcyear some.tsv | cmp - <(vcyear all.tsv)'

one() { ptrace -w- -x 16 -y 16 -vf b.vf "$@" $office/materials.rad $office/layout.rad $office/sky_1400.rad; }
check 'a sum goes on with its next frame, to the picture of one run' '
    one -seed 7 -frames 9 | ptaccum -o run.exr; one -seed 7 -frames 17 | ptaccum -o whole.exr
    one -after run.exr -frames 17 | ptaccum run.exr - -o run.exr
    vcmetrics run.exr | tail -n 1 | cut -f 2- > a; vcmetrics whole.exr | tail -n 1 | cut -f 2- | cmp - a'
check_error 'not with frames that it has' 1 '^ptrace: -frames: run.exr has frames up to 16 already, and no more are' '
    one -after run.exr -frames 17 > x'
check_error 'nor with those of another seed' 1 '^ptrace: run.exr: has the seed 7, not that of -seed$' '
    one -seed 8 -after run.exr > x'
check_error 'a picture is no sum' 1 '^ptrace: p.exr: is no sum of frames' '
    ptaccum <(rm -f x; one -frames 1 -picture) -o p.exr; one -after p.exr -frames 9 > x'
check_error 'a table is of hours' 1 '^ptrace: -after: whole.tsv is a table of hours: -wea' '
    one -after whole.tsv -frames 9 > x'
check 'a kept picture keeps its error, in fewer bytes than parts that were asked for, or none' '
    one -frames 33 > frames; for o in "" "-batches 16" "-batches 0"; do
        ptaccum -last $o -o x.exr < frames
        vcmetrics -W- -metrics Ev -ci 95 x.exr | tail -n 1 | cut -f 2-4 | tr "\n" "\t"; wc -c < x.exr
    done > sizes
    awk "NR == 1 { e = \$1; half = \$3 - \$1; bytes = \$4 }
         NR == 2 && !(\$1 == e && (half / (\$3 - \$1) - 1) ^ 2 < .05 ^ 2 && bytes < .75 * \$4) { exit 1 }
         NR == 3 && !(\$1 == e && \$2 == \"nan\" && \$4 < bytes) { exit 1 }" sizes'
