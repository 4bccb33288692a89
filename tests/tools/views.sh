# SPDX-License-Identifier: BSD-3-Clause
# Several views and skies in one run: each picture's frames are those of a run of its own, under its own name.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics mkstream
office=$TOP/examples/scenes/office
scene="$office/materials.rad $office/layout.rad"
desk='-vta -vp 2 2.7 1.2 -vd 0 -1 -.08 -vu 0 0 1 -vh 180 -vv 180'
door='-vta -vp 3.2 5 1.6 -vd -.4 -1 -.1 -vu 0 0 1 -vh 180 -vv 180'
up='-vtv -vp 2 2 1 -vd 0 -1 .4 -vu 0 0 1 -vh 60 -vv 40'  # another size: 20 x 12
printf 'VIEW= desk %s\nrvu %s\nview= up %s\n' "$desk" "$door" "$up" > all.vf
render() { ptrace -w- -x 20 -y 20 -frames 20 "$@"; }

render -views all.vf -sky $office/sky_0900.rad -sky $office/sky_overcast.rad $scene > all.str
ptaccum -o '%s.exr' < all.str
alone() {
    render $2 $scene $office/$3.rad | ptaccum -last -o alone.exr
    [ "$(mkstream differ alone.exr $1_$3.exr)" = 0 ]
}
for sky in sky_0900 sky_overcast; do
    check "frames of desk, $sky, as in a run of its own" 'alone desk "$desk" $sky'
    check "frames of a view without a name, $sky" 'alone 2 "$door" $sky'
    check "frames of another size, $sky" 'alone up "$up" $sky'
done
check 'so it is with light that is learned from where the eye is' '
    render -sampling portals -views all.vf $scene $office/sky_0900.rad | ptaccum -o "portals_%s.exr"
    render -sampling portals $door $scene $office/sky_0900.rad | ptaccum -last -o alone.exr
    [ "$(mkstream differ alone.exr portals_2.exr)" = 0 ]'
check 'and with ranges of frames' '
    render -frames 5:9 -views all.vf $scene $office/sky_0900.rad | ptaccum -o "part_%s.exr"
    render -frames 5:9 $door $scene $office/sky_0900.rad | ptaccum -last -o alone.exr
    [ "$(mkstream differ alone.exr part_2.exr)" = 0 ]'
check 'vcmetrics has columns for view and sky' '
    ptaccum -last < all.str | vcmetrics -metrics Ev | cut -f 3,4 | sort -u | tr "\t\n" ", " > is
    [ "$(cat is)" = "2,sky_0900 2,sky_overcast desk,sky_0900 desk,sky_overcast up,sky_0900 up,sky_overcast view,sky " ]'
check 'also of files, and a recorded table of them compares' '
    vcmetrics -metrics Ev desk_sky_0900.exr up_sky_0900.exr > table.tsv
    [ "$(cut -f 1-3 table.tsv | sed -n 2p | tr "\t" ,)" = desk_sky_0900.exr,desk,sky_0900 ]
    vcmetrics -difference table.tsv table.tsv -tolerance "Ev 1%"'
check '-S numbers the views of the standard input, each a change of the one before' '
    printf "VIEW= -vp 2 2.7 1.2\nVIEW= -vd 1 0 0\n" |
        render -frames 2 -vta -vd 0 -1 0 -vh 180 -vv 180 -S 7 $scene $office/sky_0900.rad > s.str
    strings s.str | grep "^VIEWNAME=" | tr "\n" " " | grep -qx "VIEWNAME=7 VIEWNAME=7 VIEWNAME=8 VIEWNAME=8 "
    [ "$(strings s.str | grep "^VIEW=" | sed -n 3p | cut -d " " -f 2-10)" = "-vta -vp 2 2.7 1.2 -vd 1 0 0" ]'
names_of() { strings "$@" | sed -n "s/^VIEWNAME=//p" | tr "\n" " "; }
check 'several -views: all of all files, each file from the view of the command line' '
    printf "VIEW= -vp 2 2.7 1.2\nVIEW= -vp 1 1 1\n" > a.vf; printf "VIEW= b -vp 3 3 1\nVIEW= -vd 1 0 0\n" > b.vf
    render -frames 1 -vta -vd 0 -1 0 -vh 180 -vv 180 -views a.vf -views b.vf $scene $office/sky_0900.rad > s.str
    [ "$(names_of s.str)" = "1 2 b 4 " ]
    [ "$(strings s.str | sed -n "s/^VIEW= \(-vta.*\) -vu.*/\1/p" | tail -n 1)" = "-vta -vp 3 3 1 -vd 1 0 0" ]'
check 'a name may begin with a minus; an option does not become one' '
    printf "VIEW= -0.100 -vp 2 2.7 1.2\nVIEW= -v2 -vp 1 1 1\nVIEW= -vd 1 0 0\n" > a.vf
    render -frames 1 -vta -vd 0 -1 0 -vh 180 -vv 180 -views a.vf $scene $office/sky_0900.rad > s.str
    [ "$(names_of s.str)" = "-0.100 2 3 " ]'
check 'view files without line ends, joined by cat' '
    printf "rvu %s" "$desk" > a.vf; printf "VIEW= %s" "$door" > b.vf
    cat a.vf a.vf b.vf a.vf | render -frames 1 -S 1 $scene $office/sky_0900.rad > s.str
    [ "$(names_of s.str)" = "1 2 3 4 " ]
    strings s.str | sed -n "s/^VIEW= -vta -vp \(.*\) -vd.*/\1/p" | tr "\n" , |
        grep -qx "2 2.7 1.2,2 2.7 1.2,3.2 5 1.6,2 2.7 1.2,"'
check_error 'the standard input holds one list of views' 1 '^ptrace: -views: the standard input is read once' '
    render -views - -S 3 $scene > x < a.vf'
check 'a rad input file without a name of a view: all of them' '
    printf "scene= %s\nRESOLUTION= 8\nview= a %s\nview= %s\n" "$scene" "$desk" "$door" > t.rif
    ptrace -w- -frames 1 -rif t.rif | strings | grep "^VIEWNAME=" | tr "\n" " " | grep -qx "VIEWNAME=a VIEWNAME=2 "
    ptrace -w- -frames 1 -rif t.rif 2 | strings | not grep -q "^VIEWNAME="'
check 'frames go to files by name and number' '
    render -frames 2 -views all.vf -o "f_%s_%02d.hdr" $scene $office/sky_0900.rad
    ls f_desk_00.hdr f_desk_01.hdr f_2_01.hdr f_up_01.hdr'

check_error 'a stream of several pictures needs %s' 1 '^ptaccum: -o: "x.exr" needs a %s for the names' '
    ptaccum -o x.exr < all.str'
check_error '%s needs names' 1 '^ptaccum: -o: "x_%s.exr": the pictures have no names' '
    mkstream frames 0 2 | ptaccum -o x_%s.exr'
check_error 'a picture must have an end' 1 '^ptrace: -frames: say how many frames each picture gets' '
    ptrace -views all.vf $scene | cat > x'
check_error 'names are told apart' 1 '^ptrace: two views are called "a"' '
    printf "VIEW= a -vta\nVIEW= a -vth\n" > two.vf; render -views two.vf $scene > x'
check_error 'a name is no path' 1 '^ptrace: the view: "../a" cannot be part of a file' '
    printf "VIEW= ../a -vta\n" > two.vf; render -views two.vf $scene > x'
check_error 'nor is it one in a stream' 1 'cannot be part of a file' '
    sed "s/^VIEWNAME=desk/VIEWNAME=..\/x/" all.str | ptaccum -o %s.exr'
check_error 'a wrong view is told with its line' 1 '^ptrace: bad.vf:2: -vh: ' '
    printf "VIEW= a -vta\nVIEW= b -vtv -vh 200\n" > bad.vf; render -views bad.vf $scene > x'

# -M and -MF
check '-MF writes the rule of -M and renders' '
    ptrace -M p.exr $desk $scene $office/sky_0900.rad > only.d
    render -frames 1 -M p.exr -MF also.d $desk $scene $office/sky_0900.rad > x
    test -s x; diff only.d also.d'
check 'the rule names views and skies' '
    ptrace -M p.exr -views all.vf -sky $office/sky_0900.rad -sky $office/sky_1400.rad $scene |
        tr " " "\n" > words; grep -qx all.vf words; grep -q sky_0900 words; grep -q sky_1400 words'
check_error '-MF without -M' 1 '^ptrace: -MF: needs -M' 'render -MF x.d $scene > x'
