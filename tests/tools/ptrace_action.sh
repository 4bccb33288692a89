# SPDX-License-Identifier: BSD-3-Clause
# Light by an action (ptrace -action): pictures behind the ordinary ones, and what is said about them.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum mkstream
printf 'void glow sky_glow 0 0 4 5 5 5 0\nsky_glow source s 0 0 4 0 0 1 180\n' > sky.rad
printf 'void plastic red 0 0 5 .7 .2 .1 0 0\nred ring floor 0 0 8 0 0 0 0 0 1 0 9\n' > room.rad
printf 'void light lamp 0 0 3 9 9 9\nlamp sphere bulb 0 0 4 0 3 3 .2\n' > lamp.rad
printf '0 0 1 0 0 1\n0 0 1 0 0 -1\n' > desk.pts
printf '400 0\n500 1\n600 0\n' > hat.csv
echo 'VIEW= eye -vta -vp 0 0 1 -vd 0 1 0 -vu 0 0 1 -vv 180 -vh 180' > eye.vf
view='-views eye.vf -x 8 -y 8'

check 'pictures of each action follow the ordinary ones' '
    ptrace -w- $view -frames 3 -action mel -action hat.csv -bands 6 sky.rad room.rad > all.str
    [ "$(strings all.str | sed -n "s/^ACTION=//p" | uniq | tr "\n" "/")" = "mel 6 lx/hat 6 W/m2/" ]
    [ "$(strings all.str | grep -c "^FRAME=")" = 9 ]
    [ "$(strings all.str | grep "^FINGERPRINT=" | sort -u | wc -l)" = 3 ]'
check 'which leave these as they are' '
    ptrace -w- $view -frames 3 sky.rad room.rad | ptaccum -last -o "alone_%s.exr"
    ptaccum -last -o "%s.exr" < all.str
    [ "$(mkstream differ alone_eye.exr eye.exr)" = 0 ]; moved=$(mkstream differ eye.exr eye_mel.exr); [ $moved != 0 ]'
check 'an action is the same beside others and alone, on other threads, in parts' '
    ptrace -w- $view -n 1 -frames 0:1 -action mel -bands 6 sky.rad room.rad | ptaccum -last -o "a_%s.exr"
    ptrace -w- $view -n 2 -frames 2:2 -action mel -bands 6 sky.rad room.rad | ptaccum -last -o "b_%s.exr"
    ptaccum a_eye_mel.exr b_eye_mel.exr -o both.exr
    [ "$(mkstream differ both_mel.exr eye_mel.exr)" = 0 ]'
check_error 'nothing merges an action with another picture' 1 '^ptaccum: .*ACTION' \
    'ptaccum eye.exr eye_mel.exr -o x.exr'
check 'files have the names of the ordinary ones and the action' '
    ptrace -w- -vtl -x 4 -y 4 -picture -frames 2 -o p.hdr -action mel sky.rad; ls p.hdr p_mel.hdr
    ptrace -w- -vtl -x 4 -y 4 -frames 2 -o f%02d.hdr -action mel sky.rad && ls f01.hdr f00_mel.hdr'
check 'hours of a weather file have them, too, the dark ones black' '
    printf "place x\nlatitude 42\nlongitude 71\ntime_zone 75\nsite_elevation 0\nweather_data_file_units 1\n" > w.wea
    printf "6 21 1.5 0 0\n6 21 12.5 500 100\n" >> w.wea
    ptrace -w- $view -frames 2 -wea w.wea -action mel room.rad 2> said > hours.str
    [ "$(strings hours.str | grep -c "^ACTION=mel 9 lx")" = 3 ]
    ptrace -w- $view -frames 2 -wea w.wea -hours-apart -action mel room.rad 2> said > hours.str
    [ "$(strings hours.str | grep -c "^ACTION=mel 9 lx")" = 3 ]'
check 'ordinary frames of hours are those without an action' '
    ptrace -w- $view -frames 2 -wea w.wea room.rad 2> said | ptaccum -last -o "w_%s.exr"
    ptrace -w- $view -frames 2 -wea w.wea -action mel room.rad 2> said | ptaccum -last -o "a_%s.exr"
    [ "$(mkstream differ w_eye_0621_1230.exr a_eye_0621_1230.exr)" = 0 ]
    moved=$(mkstream differ a_eye_0621_1230.exr a_eye_0621_1230_mel.exr); [ $moved != 0 ]'
check 'and so have sensors' '
    ptrace -w- -points desk.pts -frames 2 -action mel sky.rad room.rad | strings | grep -c "^ACTION=mel 9 lx" |
        grep -qx 2'
check 'what has no spectrum is named' '
    ptrace $view -frames 1 -action mel -action V -lamp lamp=F11 sky.rad room.rad lamp.rad 2> said | cat > x.str
    grep -qx "ptrace: warning: -action: no spectrum, so daylight D65: sky_glow" said
    grep -qx "ptrace: warning: -action: no spectrum, so a smooth one of the RGB: red" said'
check 'a lamp that is not there is named' '
    ptrace $view -frames 1 -action mel -lamp lmp=F11 sky.rad 2> said | cat > x.str
    grep -qx "ptrace: warning: -lamp: \"lmp\" is no light of the scene, or has a spectrum" said'
printf '400 1\n500 -1\n' > neg.csv
refused() {  # what it says, options
    local says=$1; shift
    check_error "$*" 1 "^ptrace: $says" "ptrace $view -frames 1 $* sky.rad > x.str"
}
refused '-action: "blue" is neither mel, rh, sc, mc, lc or V nor a file$' -action blue
refused 'neg.csv: a spectrum is not negative: -1 at 500 nm$' -action neg.csv
refused '-action: two actions are called "mel"$' -action mel -action mel
refused '-bands: are rendered three by three, not 8$' -action mel -bands 8
refused '-lamp: two illuminants for "a"$' -action mel -lamp a=hat.csv -lamp a=hat.csv
refused '-lamp: needs a light and an illuminant, as lamp=F11, not "a"$' -action mel -lamp a
refused '-lamp: "F99" is neither a file nor one of A E D50' -action mel -lamp a=F99
refused '-daylight: daylight has 4000 to 25000 K, not 3000$' -action mel -daylight 3000
refused '-lamp: is for -action$' -lamp a=A
refused '-pixel: is of one picture, but there are several$' -action mel -action V -pixel 1,1
