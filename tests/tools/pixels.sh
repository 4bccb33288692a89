# SPDX-License-Identifier: BSD-3-Clause
# Glare that does not depend on the size of the picture: the sun by its closed form, wherever it is in a pixel, and what
# pixels do to evalglare's DGP.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics
view="-vta -vp 0 0 0 -vd 0 1 0 -vu 0 0 1 -vh 180 -vv 180"

# A uniform surround of 1000 cd/m2 and a sun of 1e6 cd/m2 and .533 degrees; sigma and tau in degrees.
sun() {
    awk -v s="$1" -v t="$2" 'BEGIN {
        r = 3.14159265358979 / 180
        print "void glow sky_light 0 0 4 5.58659 5.58659 5.58659 0\nsky_light source sky 0 0 4 0 1 0 360"
        print "void light sun_light 0 0 3 5586.59 5586.59 5586.59"
        printf "sun_light source sun 0 0 4 %.9f %.9f %.9f .533\n", sin(s*r)*sin(t*r), cos(s*r), sin(s*r)*cos(t*r) }'
}
# Its DGP: that of the formula page, with the position index above the line of sight.
closed_form() {
    awk -v s="$1" -v t="$2" 'BEGIN {
        pi = 3.14159265358979; r = pi / 180; L = 1e6; w = 2 * pi * (1 - cos(.2665 * r)); t = t < 0 ? -t : t
        P = exp((35.2 - .31889*t - 1.22*exp(-2*t/9))*s/1000 + (21 + .26667*t - .002963*t*t)*s*s/100000)
        Ev = pi * 1000 + (L - 1000) * w * cos(s*r)
        print 5.87e-5 * Ev + .159 + .092 * log(1 + L*L*w / (Ev^1.87 * P*P)) / log(10) }'
}
# Columns of frame 0, and more frames: measured SIZE FRAMES COLUMNS SCENE...
measured() {
    local size=$1 frames=$2 columns=$3; shift 3
    ptrace -w- -ab 0 $view -x "$size" -y "$size" -frames "$frames" "$@" | ptaccum -last -ff |
        vcmetrics -W- -metrics "$columns" | tail -n 1 | cut -f 3-
}
# within A B TOLERANCE
within() { awk -v a="$1" -v b="$2" -v t="$3" 'BEGIN { exit !((a - b)^2 < t^2) }'; }

check 'the sun in a uniform surround, on corners of pixels and between them, within .001 of its closed form' '
    for place in 25.3125 25 26.1 24.5; do
        for tau in 0 3 -1.7; do
            sun $place $tau > sun.rad; want=$(closed_form $place $tau)
            for size in 64 128; do
                got=$(measured $size 1 DGPf sun.rad); echo "$place $tau $size: $got, want $want"
                within $got $want .001
            done
        done
    done'
check 'evalglare'"'"'s DGP of the same pictures rises with their size, and DGP.px tells by how much' '
    sun 25 3 > sun.rad; want=$(closed_form 25 3)
    small=$(measured 64 1 DGP sun.rad); large=$(measured 256 1 DGP sun.rad)
    awk -v s=$small -v l=$large -v w=$want "BEGIN { exit !(s < l - .005 && l < w - .005) }"
    within $(measured 64 1 DGP.px sun.rad) $(awk -v s=$small -v w=$want "BEGIN { print w - s }") .001'
check 'a uniform surround keeps its DGP' '
    grep -v sun_light sun.rad > sky.rad
    plain=$(measured 64 1 DGP,UGR,n_sources sky.rad)
    [ "$(measured 64 1 DGPf,UGRf,n_sourcesf sky.rad)" = "$plain" ]'
# Seen through two panes, half behind a bar, and in a mirror.
cat > panes.rad << 'END'
void glass pane 0 0 3 .96 .96 .96
pane polygon near 0 0 12 -9 1 -9 9 1 -9 9 1 9 -9 1 9
pane polygon far 0 0 12 -9 1.1 -9 9 1.1 -9 9 1.1 9 -9 1.1 9
END
awk 'BEGIN { z = 2 * sin(25.3 / 57.29578) / cos(25.3 / 57.29578)
             print "void plastic dark 0 0 5 .05 .05 .05 0 0"
             print "dark polygon bar 0 0 12 -5 2 " z " 5 2 " z " 5 2 " z + .3 " -5 2 " z + .3 }' > bar.rad
check 'through two panes and half behind a bar it is the same at 64 and at 256 pixels, to .004' '
    sun 25.3 3 > sun.rad
    for more in panes bar; do
        a=$(measured 64 1 DGPf sun.rad $more.rad); b=$(measured 256 1 DGPf sun.rad $more.rad)
        echo "$more: $a $b"; within $a $b .004
    done'
cat > mirror.rad << 'END'
void mirror silver 0 0 3 1 1 1
silver polygon wall 0 0 12 -9 3 -9 9 3 -9 9 3 9 -9 3 9
END
check 'in a flat mirror it is within .002 of its closed form with any seed' '
    sun 25.3125 3 | awk "/^sun_light source/ { \$8 = -\$8 } { print }" > behind.rad; want=$(closed_form 25.3125 3)
    for size in 64 128; do
        for seed in 1 2 3 4 5 6; do
            got=$(measured $size 17 DGPf -seed $seed behind.rad mirror.rad); echo "$size: $got, want $want"
            within $got $want .002
        done
    done'
check 'without moments there are none of these columns, and a warning says so' '
    ptrace -w- -ab 0 $view -x 64 -y 64 -frames 1 -moments- sun.rad | ptaccum -last -ff > plain.hdr
    vcmetrics -metrics DGPf,UGRf,classf,DGP.px,DGPf.px plain.hdr 2> said | tail -n 1 |
        grep -qxP "plain.hdr\tnan\tnan\tnan\tnan\tnan"
    grep -q "^vcmetrics: warning: .*no moments of its pixels" said
    vcmetrics -W- -metrics DGP,classf -format jsonl plain.hdr | grep -q "\"classf\": null}"'
check_exit 'a rule on them ends at once, as no number of frames meets it' 4 '
    ptrace -w- -ab 0 $view -x 64 -y 64 -moments- sun.rad | ptaccum |
        vcmetrics -metrics DGPf -until "DGPf 0.01" > lines 2> said'
check 'which it says' 'grep -q "stopped after 0 frames: there is no DGPf without moments" said'
check_error 'nor are there any where the picture is changed first' 1 '^vcmetrics: -metrics: DGPf needs the whole' '
    vcmetrics -G 1 -metrics DGPf plain.hdr'
check_exit 'a rule that no number of frames can meet ends the run with status 4' 4 '
    ptrace -w- -ab 0 $view -x 64 -y 64 sun.rad bar.rad | ptaccum | vcmetrics -until "DGP 0.01" > lines 2> said'
check 'it says what the size does, and what would do' '
    grep -q "pixels DGP reads 0[.]0[0-9]* low, more than the 0.01 of the rule; about [0-9]* x .* DGPf does not" said'
# The sun at any angle: what the moments have told of its place in the pixel is lost with them.
rim() {  # SIZE ANGLE FORMAT...
    sun "$2" 3 | sed 's/5586[.]59/5586590/g' > sun.rad
    ptrace -w- -ab 0 $view -x "$1" -y "$1" -frames 1 sun.rad | ptaccum -last "${@:3}"
}
check 'a sun at the rim whose place went with the moments is told, with the most that Ev is off' '
    for angle in 70 75 80 84 88; do
        rim 64 $angle -o a.exr; rim 64 $angle -o a.hdr
        true=$(vcmetrics -W- -metrics Ev a.exr | tail -n 1 | cut -f 2)
        told=$(vcmetrics -metrics Ev a.hdr 2>&1 > t | sed -n "s/.*Ev is up to \([0-9]*\) % off.*/\1/p")
        awk -v a="$(tail -n 1 t | cut -f 2)" -v b="$true" -v told="${told:-1}" -v s="$angle" "BEGIN {
            off = 100 * (a - b) / b; print s, off, told; exit !(off * off <= (1.2 * told + 1) ^ 2) }" || exit 1
        [ "$told" ] || [ $angle -lt 80 ] || exit 1
    done'
check 'in front, in a fine picture, with moments and in another program'"'"'s picture nothing is said' '
    rim 64 5 > a.hdr; rim 512 60 > b.hdr; rim 64 88 -o c.exr; rim 64 88 > d.hdr; sed '/^FRAMES=/d' d.hdr > foreign.hdr
    for f in a.hdr b.hdr c.exr foreign.hdr; do vcmetrics -metrics Ev $f 2>> said > t; done; ! grep "line of sight" said'
# The sun behind the eye, mirrored by a rough metal wall to SIGMA degrees right of the line of sight.
highlight() {
    awk -v s="$1" -v rough="$2" 'BEGIN {
        r = 3.14159265358979 / 180; vx = sin(s*r); vy = cos(s*r); nx = -cos(20*r); ny = -sin(20*r)
        k = vx * nx + vy * ny; x = 3 * vx; y = 3 * vy; tx = -2 * ny; ty = 2 * nx
        print "void glow sky_light 0 0 4 2 2 2 0\nsky_light source sky 0 0 4 0 1 0 360"
        printf "void light sun_light 0 0 3 8e5 8e5 8e5\nsun_light source sun 0 0 4 %g %g 0 .533\n", vx-2*k*nx, vy-2*k*ny
        print "void metal steel 0 0 5 .7 .7 .7 .8 " rough "\nsteel polygon wall 0 0 12"
        print x - tx, y - ty, -2, x + tx, y + ty, -2, x + tx, y + ty, 2, x - tx, y - ty, 2 }'
}
check 'a highlight that is narrower than its pixel: DGPf.px says how much lower a larger picture may be' '
    for angle in 72 79 85 88; do
        for rough in .005 .008 .03; do
            highlight $angle $rough > steel.rad
            for size in 64 400; do
                ptrace -w- $view -x $size -y $size -frames 9 steel.rad | ptaccum |
                    vcmetrics -W- -metrics DGPf,DGPf.px -ci 95 -last | tail -n 1 | cut -f 3-6 > at$size
            done
            paste at64 at400; paste at64 at400 | awk -v rough=$rough "{
                low = (\$4 < 0 ? \$4 : 0) - (\$3 - \$2) - .005; off = \$5 - \$1
                exit !(off > low && off < .005 + (\$3 - \$2) && (rough < .02 || \$4 ^ 2 < 1e-5)) }" || exit 1
        done
    done'
check 'the last row of each picture has the intervals of a run with all rows' '
    office=$TOP/examples/scenes/office
    for seed in 3 4; do
        ptrace -w- -vf $office/view.vf -x 32 -y 32 -frames 10 -seed $seed $office/{materials,layout,sky_day}.rad
    done | ptaccum -every x2/8 > sums.str
    table() { vcmetrics -metrics Ev,DGPf,DGP.px -ci 95 "$@" < sums.str; }
    table | grep "^9" | cut -f 3- > all; not grep nan all
    table -last > last; [ "$(wc -l < last)" = 3 ]; tail -n 2 last | cut -f 3- | cmp - all'
