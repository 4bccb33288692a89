# SPDX-License-Identifier: BSD-3-Clause
# ptrace -action to vcmetrics and vcyear: what numbers a scene has that can be told beforehand.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics vcyear
printf 'void glow g 0 0 4 1 1 1 0\ng source sky 0 0 4 0 0 1 180\n' > sky.rad
printf 'void plastic p 0 0 5 .5 .5 .5 0 0\np ring floor 0 0 8 0 0 0 0 0 1 0 9\n' > grey.rad
printf 'void plastic r 0 0 5 .6 .2 .1 0 0\nr polygon wall 0 0 12 -3 3 0 3 3 0 3 3 3 -3 3 3\n' > red.rad
printf '0 0 1 0 0 1\n0 0 1 0 1 0\n' > desk.pts
size='-x 32 -y 32 -frames 33'
view="-vta -vp 0 0 1 -vd 0 1 0 -vu 0 0 1 -vv 180 -vh 180 $size"
measured() { ptaccum -every x2/16 | vcmetrics -last -ci 95 "$@"; }
within() { awk -v column="$1" -v low="$2" -v high="$3" -F "\t" "
    NR == 1 { for (i = 1; i <= NF; ++i) at[\$i] = i }
    NR > 1 { ++n; v = \$at[column]; if (!(v >= low && v <= high)) { print column, v; bad = 1 } } END { exit !n || bad }"
}

within_row() { awk -v is="$1" -v by="$2" "{ ok = \$2 > is - by && \$2 < is + by } END { exit !ok }"; }

check 'grey under D65: melanopic EDI is the illuminance, and DER is 1' '
    ptrace -w- $view -action mel -action V sky.rad grey.rad | measured -metrics Ev,mEDI,mDER,EvV > rows 2> said
    within mDER .9999 1.0001 < rows; within mDER.lo .9999 1 < rows; not grep "by V" said
    awk "NR == 2 && !((\$6/\$3 - 1)^2 <= 1e-6 && (\$12/\$3 - 1)^2 <= 1e-6) { print; exit 1 }" rows'
check 'under A it is .4957, with a grey floor too' '
    ptrace -w- $view -action mel -action V -daylight A sky.rad grey.rad | measured -metrics mDER > rows
    within mDER .4935 .4979 < rows'
check 'a red wall takes melanopic light; the ratio is surer than its parts' '
    ptrace -w- $view -action mel -action V sky.rad grey.rad red.rad | measured -metrics mEDI,mDER > rows
    within mDER .9 .95 < rows
    awk "NR == 2 { exit !((\$8 - \$7)/\$6 < .5*(\$5 - \$4)/\$3) }" rows'
check 'the luminance of a region by V stands beside the ordinary one' '
    echo "task circle 0 1 -.5 40" > task.regions
    ptrace -w- $view -action V sky.rad grey.rad | measured -regions task.regions -metrics task.mean,task.meanV > rows
    awk "NR == 2 { exit !((\$6/\$3 - 1)^2 < 1e-8 && \$3 > 1) }" rows
    ptrace -w- $view -action V sky.rad grey.rad | measured -regions task.regions -metrics hall.meanV 2> said || :
    grep -q "^vcmetrics: -metrics: hall.mean: there is no region \"hall\"; there are task" said'
check 'sensors have it too' '
    ptrace -w- -points desk.pts -frames 17 -action mel sky.rad grey.rad | ptaccum -every x2/16 |
        vcmetrics -last -ci 95 -metrics mean,mEDI.mean > rows
    awk "NR == 2 { exit !((\$6/\$3 - 1)^2 <= 1e-6) }" rows'
check 'and hours of a year' '
    printf "place Here\nlatitude 39.74\nlongitude 105.18\ntime_zone 105\nsite_elevation 1829\n" > y.wea
    printf "weather_data_file_units 1\n6 21 5.5 0 0\n6 21 12.5 700 90\n12 21 12.5 0 10\n" >> y.wea
    small="-vta -vp 0 0 1 -vd 0 1 0 -vu 0 0 1 -vv 180 -vh 180 -x 16 -y 16 -wea y.wea -frames 9"
    ptrace -w- $small -action mel grey.rad 2> said | ptaccum -every x2/8 |
        vcmetrics -metrics Ev,DGP,mEDI -ci 95 -last > hours.tsv 2> said; not grep "there is none" said
    ptrace -w- $small grey.rad 2> said | ptaccum -every x2/8 | vcmetrics -metrics Ev,DGP -ci 95 -last > plain.tsv
    vcyear hours.tsv 2> said > five; grep -v mEDI five | diff - <(vcyear plain.tsv 2> said)
    grep -q "^mEDI      136 lx in 2, 250 lx in 2 of 3 hours" five'

check 'shades that close for glare leave the light that they let in, at the eye and at sensors' '
    { printf "frame\tsky\tstate\tDGP\tDGP.lo\tDGP.hi\tEv\tEv.lo\tEv.hi\tmEDI\tmEDI.lo\tmEDI.hi\n"
      row() { printf "9\t0621_%s\t%s\t%s\t%s\t%s\t900\t890\t910\t%s\t%s\t%s\n" $1 $2 $3 $3 $3 $4 $5 $6; }
      row 0930 open .30 400 395 405; row 1030 open .50 900 895 905; row 1130 open .50 900 895 905
      row 1230 open .30 140 130 150
      row 0930 shut .20 90 88 92; row 1030 shut .25 200 198 202; row 1130 shut .25 100 98 102
      row 1230 shut .20 80 78 82; } > shades.tsv
    vcyear -shades "glare .40" shades.tsv 2> said > lines
    grep -qx "mEDI      136 lx in 3 (2 to 3), 250 lx in 1 of 4 hours" lines
    vcyear -report y.html -shades "glare .40" shades.tsv > lines 2> said
    grep -q "clock.>Daylight for the body clock, .*: 136 lx in 3 (2 to 3), 250 lx in 1 of 4 hours\.<" y.html
    vcyear -state open shades.tsv 2> said | grep -q "^mEDI      136 lx in 4 (3 to 4), 250 lx in 3 of 4 hours"
    sed "s/\tEv\t/\tE\t/; s/Ev\.//g; s/^frame/grid\tpoint/; s/^9/desk\t0/" shades.tsv | cut -f 1-4,8- > sensors.tsv
    vcyear -by shades.tsv -shades "glare .40" sensors.tsv > lines 2> said
    grep -q "^mEDI      136 lx in 75.0 % .*; 250 lx in 25.0 % " lines'
check 'where a state has no melanopic light they may be either' '
    awk -F "\t" -v OFS="\t" "/shut/ { \$10 = \$11 = \$12 = \"nan\" } 1" shades.tsv > without
    vcyear -shades "glare .40" without 2> said | grep -q "^mEDI      136 lx in 2 (1 to 4), 250 lx in 1 (1 to 3)"'
check 'lights without a picture: the ratios of CIE S 026' '
    printf "nm,value\n380,1\n780,1\n" > equal.csv; vcmetrics -spectrum F12 -spectrum D65 -spectrum equal.csv > rows
    head -1 rows | grep -qx "light.mDER.rhDER.scDER.mcDER.lcDER"
    for n in 4 5 6; do awk -v n=$n -F "\t" "NR == 3 { exit !((\$(n - 2) - 1)^2 <= 1e-12) }" rows; done
    sed -n 2p rows | within_row .4028 .002; sed -n 4p rows | within_row .9058 .002'
check_error 'a light that is none' 1 '^vcmetrics: -spectrum: "F99" is neither a file nor one of A E' '
    vcmetrics -spectrum F99'
check_error 'or has no light' 1 '^vcmetrics: .*dark.csv: ' '
    printf "400 0\n500 0\n" > dark.csv; vcmetrics -spectrum dark.csv'
check_error 'a light beside a picture' 1 '^vcmetrics: -spectrum: is of lights' 'vcmetrics -spectrum A x.hdr'
