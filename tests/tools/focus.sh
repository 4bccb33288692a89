# SPDX-License-Identifier: BSD-3-Clause
# ptrace -focus: more samples for regions.  Its laws are in tests/physics/focus_test.cpp; here is what users give it.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcregion mkstream
cp "$TOP"/examples/scenes/office/* "$TOP"/examples/office.regions .
scene='materials.rad layout.rad sky_1400.rad' size='-x 40 -y 40'
back='-vta -vp 2 5.5 1.6 -vd 0 -1 0 -vu 0 0 1 -vh 180 -vv 180'
render() { ptrace -w- $size -vf view.vf -frames "$@" $scene; }
print() { render 1 "$@" | strings | sed -n 's/^FINGERPRINT=//p'; }
vcregion -w- -vf view.vf $size -o masks.exr office.regions

check 'masks and the file they were made from are the same focus' '
    render 3 -focus masks.exr | ptaccum -last -o a.exr; render 3 -focus office.regions | ptaccum -last -o b.exr
    [ "$(mkstream differ a.exr b.exr)" = 0 ]'
check 'and not what there is without' '
    render 3 | ptaccum -last -o c.exr; moved=$(mkstream differ a.exr c.exr); [ $moved != 0 ]'
check 'each view has its own' '
    { echo "VIEW= desk $(sed "s/^[a-z]* //" view.vf)"; echo "VIEW= back $back"; } > views.vf
    ptrace -w- $size -views views.vf -frames 2 -focus office.regions $scene | ptaccum -o "view_%s.exr"
    render 2 $back -focus office.regions | ptaccum -last -o back.exr
    [ "$(mkstream differ back.exr view_back.exr)" = 0 ]'
check 'frames with and without are told apart' '
    print | cut -d " " -f 1,2,4 > a; print -focus masks.exr | cut -d " " -f 1,2,4 | diff a - &&
    [ "$(print | cut -d " " -f 3)" != "$(print -focus masks.exr | cut -d " " -f 3)" ]'
check_error 'so they do not merge' 1 '^ptaccum: b.exr: has other options than a.exr' '
    render 0:1 | ptaccum -last -o a.exr; render 2:3 -focus masks.exr | ptaccum -last -o b.exr
    ptaccum a.exr b.exr -o x.exr'
check 'one that is too large is none, with a warning' '
    echo "all rect 0 0 40 40" > all.regions
    ptrace $size -vf view.vf -frames 1 -focus all.regions $scene 2> said > frame
    grep -q "^ptrace: warning: all.regions: its regions are so large" said
    [ "$(strings frame | sed -n "s/^FINGERPRINT=//p")" = "$(print)" ]'
check 'unless it is to have more time' '
    more=$(print -focus all.regions -focus-share 2); [ "$more" != "$(print)" ]'
check 'make is told of it' 'render 1 -focus office.regions -M x | grep -q "office.regions"'

check_error 'masks of another size' 1 '^ptrace: small.exr: the picture has 40 x 40 pixels, the regions 30 x 30$' '
    vcregion -w- -vf view.vf -x 30 -y 30 -o small.exr office.regions; render 1 -focus small.exr'
check_error 'a region that is not in the picture' 1 '^ptrace: out.regions:1: region "a" is empty' '
    echo "a rect -20 -20 -10 -10" > out.regions; render 1 -focus out.regions'
check_error 'no regions' 1 '^ptrace: picture.hdr: holds no region' '
    printf "#?RADIANCE\n" > picture.hdr; render 1 -focus picture.hdr'
check_error 'a picture that is no mask' 1 '^ptrace: c.exr: ' 'render 1 -focus c.exr'
check_error 'what only the scene knows' 1 '^ptrace: glass.regions:1: asks the scene' '
    echo "glass modifier pane" > glass.regions; render 1 -focus glass.regions'
check_error 'no file' 2 '^ptrace: none.exr: cannot be read: No such file' 'render 1 -focus none.exr'
# The noisiest pixels have several samples without being asked for (-noisy-share).
check 'a share of noisy pixels moves frames' '
    render 3 -noisy-share 0 | ptaccum -last -o even.exr; render 3 | ptaccum -last -o noisy.exr
    moved=$(mkstream differ even.exr noisy.exr); [ $moved != 0 ]'
check 'another share is another fingerprint' 'even=$(print -noisy-share 0); [ "$(print)" != "$even" ]'
check 'but not where paths share nothing' '
    even=$(print -sampling portals -noisy-share 0); [ "$(print -sampling portals)" = "$even" ]'
check_error 'a share of noisy pixels below 0' 1 '^ptrace: -noisy-share' 'render 1 -noisy-share -1'
check_error 'a share below 0' 1 '^ptrace: -focus-share' 'render 1 -focus masks.exr -focus-share -1'
