# SPDX-License-Identifier: BSD-3-Clause
# vcregion as a program: what it writes, and that every wrong word is told in one line.
. "${TOP:?}/tests/lib.sh"
needs vcregion
office=$TOP/examples/scenes/office view="-vf $TOP/examples/scenes/office/view.vf"
cp "$TOP/examples/office.regions" .

check 'the office regions lie in the office view' "
    vcregion $view -list office.regions > list
    test \$(wc -l < list) -eq 4
    awk -F'\t' 'NR > 1 && !(\$2 > 1000 && \$3 > .1 && \$6 < 0) { bad = 1 } END { exit bad }' list"
check 'the two halves of the screen mirror each other' "
    awk -F'\t' '\$1 == \"screen_high\" { a = \$3; x = \$5 } \$1 == \"screen_low\" { b = \$3; y = \$5 }
                END { exit !(a > 0 && (a - b)^2 < 1e-12 && x < 0 && (x + y)^2 < 1e-8) }' list"
check_error 'a file that cannot be read is a failure of the system, as everywhere' 2 \
    '^vcregion: none.regions: cannot be read: No such file' "vcregion $view -list none.regions"
for mask in none.png none.exr 'none.exr channel a'; do
    check_error "and so is that of a mask: $mask" 2 '^vcregion: m.regions:1: mask none[.].*: No such file' "
        echo 'm mask $mask' > m.regions; vcregion $view -list m.regions"
done
check_error 'one that is too long is wrong input' 1 '^vcregion: long.regions: is longer than' "
    head -c 68000000 /dev/zero | tr '\\0' '#' > long.regions; vcregion $view -list long.regions; status=\$?
    rm long.regions; exit \$status"
check 'the same bytes on every run' "
    vcregion $view -o a.exr office.regions
    mkdir again; cd again; cp ../office.regions .; vcregion $view -o a.exr office.regions; cmp a.exr ../a.exr"
check 'a region file on stdin' "vcregion $view -list - < office.regions | cmp - list"
check '-single goes to stdout as one RADIANCE picture of zeros and ones' "
    vcregion $view -x 64 -y 64 -single desk office.regions > desk.hdr
    head -c 10 desk.hdr | grep -q RADIANCE; test \$(grep -ac '^-Y 64 +X 64$' desk.hdr) -eq 1"
check '-single to a file holds the same picture' "
    vcregion $view -x 64 -y 64 -single desk -o file.hdr office.regions
    tail -c 400 file.hdr > a; tail -c 400 desk.hdr > b; cmp a b"
check 'a mask is a shape again: all of it, and nothing else' "
    echo 'm mask desk.hdr' > m.regions; vcregion $view -x 64 -y 64 -centre -list m.regions | tail -n 1 | cut -f 2 > a
    echo 'm mask a.exr channel desk' > n.regions; vcregion $view -list n.regions | tail -n 1 | cut -f 2 > c
    vcregion $view -x 64 -y 64 -centre -list office.regions | awk '\$1 == \"desk\" { print \$2 }' | cmp - a
    awk '\$1 == \"desk\" { print \$2 }' list | cmp - c"
check 'a preview over a picture takes its size and view' "
    vcregion -over desk.hdr -o p.png office.regions; head -c 4 p.png | grep -q PNG"
check 'the size follows the aspect of the view' "
    vcregion -vtv -vp 2 2.7 1.2 -vd 0 -1 0 -vh 60 -vv 30 -x 100 -y 100 -single screen_high office.regions |
        grep -aq '^-Y 46 +X 100$'"
if command -v vcmetrics > /dev/null; then
    check 'vcmetrics takes the region file as it takes the masks' "
        vcregion $view -x 64 -y 64 -o m64.exr office.regions
        vcmetrics -regions m64.exr desk.hdr > a; vcmetrics -regions office.regions desk.hdr > b; cmp a b;
        grep -q desk.TAL a"
    check_error 'but not one that asks the scene' 1 '^vcmetrics: q:1: ' "
        echo 'd surface top.*' > q; vcmetrics -regions q desk.hdr"
fi
check 'a closed stdout is a quiet end' "vcregion $view -list office.regions | true"
check '-version and -help go to stdout' 'vcregion -version | grep -q luxpipe; vcregion -help | grep -q -- -centre'
check '-defaults shows what the options before it have set' '
    vcregion -x 77 -vtv -defaults | grep -q -- "^-x 77  *# Horizontal resolution"'

echo 'tiny circle 0 -1 0 .8' > tiny
check 'a region below 32 pixels is warned of, with its price' "
    vcregion $view -list tiny 2> err; test \$(wc -l < err) -eq 1;
    grep -q '^vcregion: warning: tiny:1: region \"tiny\" covers .* frames' err"
check '-w- keeps quiet' "vcregion $view -list -w- tiny 2> err; test ! -s err"
printf 'a circle 0 -1 0 9\nback circle 0 1 0 9\n' > back
check_error 'an empty region is an error at its line' 1 '^vcregion: back:2: region "back" is empty' "
    vcregion $view -o b.exr back"
check 'and leaves no file' 'test ! -e b.exr'
check_error 'a missing region file' 2 '^vcregion: nothere: ' "vcregion $view -list nothere"
check_error 'a folder is not a region file' 2 '^vcregion: [.]: ' "vcregion $view -list ."
check_error 'a mistake in the file names its line' 1 '^vcregion: bad:2: ' "
    printf 'a rect 0 0 1 1\nb rekt 0 0 1 1\n' > bad; vcregion -list bad"
check_error 'a name that is not there, and one that is near' 1 'no region is called "dsk" .did you mean "desk"' "
    vcregion $view -single dsk office.regions"
check_error 'no region file' 1 '^vcregion: no region file' 'vcregion -list'
check_error 'nothing to do' 1 '^vcregion: nothing to write' 'vcregion office.regions'
check_error 'an unknown option' 1 '^vcregion: -foo: unknown option' 'vcregion -foo office.regions'
check_error 'the nearest one is named' 1 '^vcregion: -center: unknown option; did you mean -centre[?]$' '
    vcregion -center office.regions'
check_error 'an option after the file' 1 '^vcregion: -list: ' 'vcregion office.regions -list'
check_error 'an ending that means nothing' 1 '^vcregion: x.tif: ' 'vcregion -o x.tif office.regions'
check_error '.hdr needs -single' 1 '^vcregion: x.hdr: ' 'vcregion -o x.hdr office.regions'
check_error '.png needs -over' 1 '^vcregion: x.png: ' 'vcregion -o x.png office.regions'
check_error 'an impossible size' 1 '^vcregion: -x: ' 'vcregion -x 0 -list office.regions'
check_error 'an impossible view' 1 '^vcregion: -vh' 'vcregion -vtv -vh 200 -list office.regions'
check_error 'a picture without a view' 1 'nv.hdr: ' "
    printf '#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n1234' > nv.hdr;
    vcregion -over nv.hdr -o x.png office.regions"
check_error 'a folder that is not there' 2 '^vcregion: ' "vcregion $view -o no/such/x.exr office.regions"
check_error 'surfaces need a scene' 1 '^vcregion: s:1: asks for a surface' "
    echo 's surface top.*' > s; vcregion $view -list s"
check_error 'a full disk' 2 '^vcregion: stdout: ' "vcregion $view -list office.regions > /dev/full"

# The examples of vcregion(5), with a mask in place of the painted one.
awk '/^[.]SH/ { on = /EXAMPLES/ } on && /^[.]EX/ { inside = 1; next } /^[.]EE/ { inside = 0 } inside' \
        "$TOP/man/vcregion.5" |
    sed 's/\\-/-/g; s/painted.png/desk.hdr/' > page
check 'the page has examples' 'test $(wc -l < page) -gt 5'

# With a scene.
scene="$office/materials.rad $office/layout.rad"
echo 'a surface top.6457' > s
if vcregion -w- $view -x 32 -y 32 -list s $scene 2>&1 | grep -q 'built without the tracer'; then
    check_error 'without the tracer scenes are refused in one line' 1 'built without the tracer' "
        vcregion $view -list s $scene"
    exit 0
fi
cat > named <<'END'
desk         polygon3d  1.1 1.7 .75  2.9 1.7 .75  2.9 2.5 .75  1.1 2.5 .75
screen_high  polygon3d  2 1.871 .9  1.71 1.871 .9  1.71 1.871 1.24  2 1.871 1.24
screen_low   polygon3d  2.29 1.871 .9  2 1.871 .9  2 1.871 1.24  2.29 1.871 1.24
desk_named   surface top.6457
high_named   surface screen_high
low_named    surface screen_low
desk_within  modifier desk_laminate within box3d 1 1.6 .749 3 2.6 .751
END
check 'by polygon and by name, through the glass cover, regions agree within 1 %' "
    vcregion $view -x 256 -y 256 -list named $scene > by_scene
    awk -F'\t' 'NR > 1 { sr[\$1] = \$3 }
        function near(a, b) { return a > 0 && (a / b - 1)^2 < 1e-4 }
        END { exit !(near(sr[\"desk\"], sr[\"desk_named\"]) && near(sr[\"desk\"], sr[\"desk_within\"]) &&
                     near(sr[\"screen_high\"], sr[\"high_named\"]) &&
                         near(sr[\"screen_low\"], sr[\"low_named\"])) }' by_scene"
check 'the monitor hides a part of the desk' "
    awk '\$1 == \"desk\" { print \$3 }' list by_scene > both
    awk 'NR == 1 { a = \$1 } NR == 2 { exit !(\$1 < .97 * a && \$1 > .8 * a) }' both"
check 'with a scene, too, the same bytes on every run' "
    for k in 1 2; do mkdir t\$k; (cd t\$k; cp ../named .; vcregion $view -x 100 -y 100 -o m.exr named $scene); done;
    cmp t1/m.exr t2/m.exr"
check_error 'a surface that is not there, and one that is near' 1 '^vcregion: t:1: no surface.*"screen_low"' "
    echo 'a surface scren_low' > t; vcregion $view -list t $scene"
check_error 'a modifier that is not there, and one that is near' 1 '^vcregion: t:1: no surface.s modifier .*"glazing"' "
    echo 'a modifier glasing' > t; vcregion $view -list t $scene"
check_error 'what is wholly hidden is empty' 1 '^vcregion: t:1: region "a" is empty' "
    echo 'a polygon3d 1.8 1.8 .9  2.2 1.8 .9  2.2 1.8 1.2  1.8 1.8 1.2' > t; vcregion $view -list t $scene"
check_error 'a broken scene names its line' 1 '^vcregion: broken.rad:1: ' "
    echo 'nothing polygon p 0 0 9 0 0 0 1 0 0 0 1 0' > broken.rad; vcregion $view -list named broken.rad"
check 'the examples of the page work in the office with blinds' "
    vcregion $view -x 256 -y 256 -list page $office/materials.rad $office/blinds.rad $office/layout.rad"
check 'the sun is a surface far away' "
    printf 'void light suns 0 0 3 1e6 1e6 1e6\nsuns source sun 0 0 4 0 1 1 2\n' > sun.rad
    printf 'void plastic p 0 0 5 .5 .5 .5 0 0\np sphere ball 0 0 4 0 5 -3 .5\n' >> sun.rad
    echo 'sun surface sun' > sun.regions; echo 'disc circle 0 1 1 2' >> sun.regions
    vcregion -vta -vh 120 -vv 120 -x 400 -y 400 -w- -list sun.regions sun.rad |
        awk -F'\t' '\$1 == \"sun\" { a = \$3 } \$1 == \"disc\" { b = \$3 }
            END { exit !(a > 0 && (a / b - 1)^2 < 1e-4) }'"

cat > work.regions <<'END'
desk   polygon3d 1.1 2.5 .75  2.9 2.5 .75  2.9 1.7 .75  1.1 1.7 .75
floor  surface floor
rest   floor - desk
west   surface west_wall within box3d -1 0 0 1 3 3
lamp   disc3d 1 1 2 0 0 -1 .5
END
points() { vcregion -spacing "$1" -height "$2" -single "$3" work.regions "$office/materials.rad" "$office/layout.rad"; }
check '-spacing lays points on a polygon, in rows, centred, facing up whatever the order of its corners' '
    points .4 .01 desk > desk.pts
    test "$(grep -c . desk.pts)" = 9; sed -n 2p desk.pts | grep -x "1.4 1.9 0.76 0 0 1"
    tail -1 desk.pts | grep -x "2.6 2.3 0.76 0 0 1"'
check 'on surfaces of the scene, without what is taken away, on a wall along its normal' '
    test "$(points .5 .76 floor | grep -c "0.76 0 0 1$")" = 96; test "$(points .5 .76 rest | grep -c "0 0 1$")" = 88
    points .5 .1 west | sed 1d | awk "\$1 != .1 || \$2 > 3 || \$4 != 1 { exit 1 } { n++ } END { exit n != 30 }"'
check 'a height below 0 is the other side; a floor whose corners are seen from outside looks up all the same' '
    points .5 -.1 west | sed 1d | awk "\$1 != -.1 || \$4 != -1 { exit 1 }"
    echo "f surface Studio_Bottom" > f.regions
    vcregion -spacing 1 -height .76 f.regions "$TOP"/examples/exports/honeybee/scene/envelope.* > floor.pts
    test "$(grep -c "0.76 0 0 1$" floor.pts)" = 24'
check 'and on a disc' 'points .5 0 lamp | sed 1d | cut -d " " -f 1-3 | sort | paste -sd, |
    grep -x "0.75 0.75 2,0.75 1.25 2,1.25 0.75 2,1.25 1.25 2"'
check 'a desk that is a box has them on its top, with a warning; walls and floors keep theirs' '
    { printf "void plastic wood 0 0 5 .5 .5 .5 0 0\n!genbox wood desk 1.6 .8 .05 | xform -t 1 1 .7\n"
      printf "void plastic carpet 0 0 5 .5 .5 .5 0 0\n"
      for z in 0 3; do echo "!genbox carpet floor 4 3 .001 | xform -t 0 0 $z"; done
      printf "wood polygon wall 0 0 12 0 0 0 0 0 3 0 4 3 0 4 0\n"; } > box.rad
    for q in "modifier wood" "surface desk.*"; do echo "d $q" | vcregion -spacing .2 - box.rad 2> said > box.pts
        test "$(grep -c " 0.75 0 0 1$" box.pts)" = 32; test "$(wc -l < box.pts)" = 33
        grep -q "has points on its upper faces alone; [56] of [67] faces" said; done
    echo "f modifier carpet" | vcregion -spacing 1 - box.rad 2> /dev/null | sed 1d | cut -d " " -f 3 | sort | uniq -c |
        tr -s " \n" " " | grep -x " 12 0.001 12 3.001 "
    echo "w surface wall" | vcregion -spacing 1 - box.rad 2> said | sed 1d | wc -l | grep -x 12; [ ! -s said ]'
check_error 'a material is a modifier, and the message says so' 1 \
    'called "carpet"; it is a modifier.s name: "modifier carpet"' '
    echo "f surface carpet" | vcregion -spacing 1 - box.rad'
check_error 'a surface is none' 1 'is called "wall"; it is a surface.s name: "surface wall"' '
    echo "f modifier wall" | vcregion -spacing 1 - box.rad'
check_error 'the nearest name is said, also of the other kind' 1 'of the modifiers .did you mean "carpet"..' '
    echo "f surface carpt" | vcregion -spacing 1 - box.rad'
check '-o writes one file, or one for each region' '
    grep -v "surface\|floor" work.regions > two.regions; mkdir grids
    vcregion -spacing .4 -height .01 -o all.pts -o grids/ two.regions
    cmp grids/desk.pts desk.pts; cat grids/desk.pts grids/lamp.pts | cmp - all.pts'
check_error 'a shape that needs a view has no points' 1 '^vcregion: stdin:1: needs a view; points lie on' '
    echo "a circle view 30" | vcregion -spacing 1 -'
check_error 'a sphere neither' 1 '^vcregion: stdin:1: "globe" has no polygon and no ring for points' "
    echo 'a surface globe' | vcregion -spacing 1 - $office/materials.rad $office/layout.rad"
check_error 'surfaces need a scene' 1 '^vcregion: stdin:1: asks for surfaces of a scene' '
    echo "a surface floor" | vcregion -spacing 1 -'
check_error 'a region with no point says so' 1 'region "a" has no point at a spacing of 1' '
    echo "a polygon3d 0 0 0 1 0 0 1 1 0 & box3d 5 5 5 6 6 6" | vcregion -spacing 1 -'
check_error 'nor too many' 1 '^vcregion: -spacing: makes more than ' 'vcregion -spacing 1e-6 two.regions'
check_error 'points are no masks' 1 '^vcregion: x.exr: points are written to .pts' '
    vcregion -spacing 1 -o x.exr two.regions'
check_error 'and no list' 1 '^vcregion: -spacing: makes points, for which -list' 'vcregion -spacing 1 -list two.regions'
