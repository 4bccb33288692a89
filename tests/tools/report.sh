# SPDX-License-Identifier: BSD-3-Clause
# vcmetrics -report: every number is that of vcmetrics' lines, sources have their objects, files their hashes; names
# from files are text; written whole or not at all.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics python3 sha256sum

cp "$TOP"/examples/scenes/office/*.rad "$TOP/examples/scenes/office/view.vf" "$TOP/examples/office.regions" .
ptrace -vf view.vf -x 96 -y 96 -frames 0:8 materials.rad layout.rad sky_1400.rad | ptaccum -every 1 > sums.str
measure='vcmetrics -regions office.regions -cr screen=screen_low/screen_high'
scene='-scene materials.rad -scene layout.rad -scene sky_1400.rad'
$measure -report report.html $scene < sums.str > lines
ptaccum -last -o last.exr sums.str
$measure -sources < sums.str | awk 'NR == 1 || $1 == 8' > sources

# The values of a part of the page, one a line.
data() { sed -n "/<h2>$1/,/<h2>/p" "$2" | grep -oE '<data value="[^"]*"' | cut -d '"' -f 2; }
# Those of the table $1 that are under the names that follow, row by row, but for nan.
cells() {
    awk -v names="$*" 'BEGIN { split(names, want) } NR == 1 { for (k = 1; k <= NF; k++) at[$k] = k; next }
        { last = $0 } END { $0 = last
            for (k = 2; k in want; k++) if ($(at[want[k]]) != "nan") print $(at[want[k]]) }' "$1"
}
columns=$(head -1 lines | tr '\t' '\n' | grep -vE '^(frame|seconds|tails|errors)$|[.](lo|hi)$')
with_ends=$(for c in $columns; do echo "$c $c.lo $c.hi"; done)
check 'the numbers of the page are those of the last line' "
    data Numbers report.html > page; cells lines $(echo $with_ends) > want
    test \$(wc -l < want) -ge 15; diff want page >&2"
check 'so are those of the sources' '
    data "Glare sources" report.html | sort > page; test -s page
    awk "NR > 1 && \$NF >= .005 { print \$16; print \$8; print \$7; print \$9; print \$14 }" sources | sort > want
    awk "NR == 1" sources >&2; diff want page >&2'
check 'the verdict is the class of DGPf' '
    dgp=$(cells lines DGPf); words=$(awk -v d="$dgp" "BEGIN { print d < .35 ? \"imperceptible\" : \"perceptible\" }")
    grep -q "Glare is.* $words<" report.html'
check 'objects and materials are those that the scene has there' '
    grep -q "sky (sky_glow) through pane (glazing)" report.html; grep -q "east_wall (wall_paint)" report.html'
check 'the sun stands where the sky says' '
    grep -q "sun: 16.8° above the horizon, 213.0° from north" report.html
    grep -q "sky_1400.rad: gensky 12 21 14" report.html'
check 'an hour of a weather file has its irradiances, and the illuminances that its light has' '
    printf "place P\nlatitude 39.74\nlongitude 105.18\ntime_zone 105\nsite_elevation 0\n" > hour.wea
    printf "weather_data_file_units 1\n12 21 12.5 700 90\n" >> hour.wea
    ptrace -vf view.vf -x 32 -y 32 -frames 3 -wea hour.wea materials.rad layout.rad | ptaccum |
        vcmetrics -metrics Ev -report hour.html > lines.tsv
    grep -q "21 Dec 12:30 UTC-7" hour.html; grep -q "weather file: 700 90 W/m2" hour.html
    grep -q "sun and sky: 66[0-9]* 1[0-9]* lx" hour.html'
check 'files have the hashes of sha256sum' '
    for f in office.regions materials.rad layout.rad room.rad sky_1400.rad; do
        grep -q "<td>$f</td><td>$(sha256sum < $f | cut -c 1-64)</td>" report.html
    done'
check 'it says how it was made' 'grep -q "ptrace -vf view.vf -x 96 -y 96" report.html; grep -q "seed 1" report.html'
check 'nothing comes from outside, and it is small' '
    test $(wc -c < report.html) -lt 2000000
    ! grep -oE "(src|href|url)[=(][^ >]*" report.html | grep -vE "data:|#scale"'
check 'the picture of a file has a report, without a scene, without objects' '
    vcmetrics -report file.html last.exr > lines; grep -q last.exr file.html; not grep -q "<th>What" file.html
    cells lines Ev DGPf > want; data Numbers file.html | grep -xFf want | wc -l | grep -qx 2'
check 'without moments of pixels it says DGP, and why' '
    ptaccum -last -o last.hdr sums.str; vcmetrics -W- -report plain.html last.hdr > lines
    grep -q "<p>DGP <data" plain.html; grep -q "no moments of its pixels" plain.html; not grep -q "<p>DGPf" plain.html
    [ "$(vcmetrics -W- -metrics DGP last.hdr | tail -n 1 | cut -f 2)" = "$(
        grep -o "<p>DGP <data value=\"[0-9.]*" plain.html | cut -d \" -f 2)" ]
    not grep -q "no moments" file.html; vcmetrics -W- -G 1 -report cut.html last.exr > lines
    grep -q "<p>DGP <data" cut.html'
check 'of a picture without light it says so' '
    ptrace -vf view.vf -x 32 -y 32 -frames 2 materials.rad room.rad | ptaccum -last -o black.exr
    vcmetrics -W- -report black.html black.exr > lines
    grep -q "The picture is black: it is night, the eye is in a solid" black.html; ! grep -q "Glare is" black.html'
check 'a picture of many pixels stays small' '
    ptrace -vf view.vf -x 1100 -y 1100 -frames 0:0 materials.rad layout.rad sky_1400.rad | ptaccum -last > large.hdr
    vcmetrics -W- -report large.html large.hdr > /dev/null; test $(wc -c < large.html) -lt 2000000'
check 'hostile names are text' '
    name="<script>alert(1)<"; cp last.exr "$name.exr"; vcmetrics -report hostile.html "$name.exr" > /dev/null
    grep -qF "&lt;script&gt;alert(1)&lt;.exr" hostile.html; ! grep -q "<script" hostile.html'
check 'recorded numbers stand in place of measured ones' '
    printf "frame\tEv\tEv.lo\tEv.hi\n8\t1234.5\t1200\t1300\n" > recorded
    vcmetrics -report again.html -numbers recorded last.exr > /dev/null
    data Numbers again.html | tr "\n" " " | grep -qx "1234.5 1200 1300 "'

printf '1 1 .8 0 0 1\n2 1 .8 0 0 1\n' > desk.pts
ptrace -points desk.pts -frames 0:16 materials.rad layout.rad sky_1400.rad | ptaccum -last -batches 16 -o sum.exr
vcmetrics -ci 95 -points desk.pts -metrics mean,min,median,U0,share300 -over map.svg sum.exr > plan
check 'maps of points stand in it, without their words, with the numbers of their table' '
    vcmetrics -report plan.html -plan map.svg plan last.exr > /dev/null
    cells plan $(for n in mean min median U0 share300; do echo desk.$n desk.$n.lo desk.$n.hi; done) > want
    data Plan plan.html > page; test $(wc -l < page) = 15; tail -n 15 want | diff - page >&2
    grep -q "<td>Mean illuminance of desk</td>" plan.html
    grep -q "<td>Share of the points of desk at 300 lx or more</td>" plan.html
    sed -n "s/.*data:image.svg+xml;base64,\([^\"]*\).*/\1/p" plan.html | base64 -d > inside
    { sed "/^<g id=.points/,\$d" map.svg; echo "</svg>"; } | cmp - inside
    ! grep -oE "(src|href|url)[=(][^ >]*" plan.html | grep -vE "data:|#scale"'
check_error 'a plan is a map of points' 1 '^vcmetrics: -plan: takes a map' '
    vcmetrics -report plan.html -plan report.html plan last.exr'
check_error 'a report has its ending' 1 '^vcmetrics: -report: writes an .html file' 'vcmetrics -report a.txt last.exr'
check_error 'it is of vcmetrics own columns' 1 '^vcmetrics: -report: ' '
    vcmetrics -like evalglare -report a.html last.exr'
check_error 'a scene belongs to a report' 1 '^vcmetrics: -scene, -numbers, -overlay, -plan: belong to -report' '
    vcmetrics -scene room.rad last.exr'
check_error 'a folder that is not there is an error before the work' '[12]' 'nowhere' '
    vcmetrics -report nowhere/a.html last.exr'
check_error 'a scene that cannot be read leaves the file as it was' 2 'absent.rad' '
    echo before > kept.html; vcmetrics -W- -report kept.html -scene absent.rad last.exr > /dev/null'
check 'which holds what it held' 'grep -qx before kept.html; test $(ls | grep -c kept) = 1'
