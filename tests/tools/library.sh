# SPDX-License-Identifier: BSD-3-Clause
# The library of materials: each is what the comment above it says, by its numbers and in a picture; it is found beside
# the programs.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics
library=$(ptrace -library)
check 'it lies beside the programs' 'diff -r "$TOP/library" "$library"'

# name, type, its numbers, and the words of the comment above
awk '/^# / { said = substr($0, 3) } /^void / { type = $2; name = $3 } /^[0-9]+ / { print name, type, $0, said }' \
    "$library"/*.rad > all
near='function near(a, b) { return a - b < .0006 && b - a < .0006 }'
check 'there are materials of each kind, under names of their own' '
    [ "$(cut -d " " -f 2 all | sort -u | tr "\n" " ")" = "glass plastic trans " ]
    [ "$(cut -d " " -f 1 all | sort | uniq -d | wc -l)" = 0 ]; [ "$(wc -l < all)" -gt 30 ]'
check 'a file says its sources' '[ "$(grep -l "^# .*Sources\{0,1\}: " "$library"/*.rad | wc -l)" = 4 ]'
check 'paint: the reflectance that is told' '
    ! awk "$near"" \$2 == \"plastic\" && !(\$9 == \"reflectance\" && near(\$4, \$10) && near(\$6, \$10))" all | grep .'
# Fresnel's losses at both sides of a pane of index 1.52, with all that goes to and fro inside
check 'glass: the transmittance that is told' '
    ! awk "$near"" \$2 == \"glass\" { r = (.52 / 2.52) ^ 2; t = (1 - r) ^ 2 * \$4 / (1 - (r * \$4) ^ 2)
        if (!(\$7 == \"transmittance\" && near(t, \$8))) print }" all | grep .'
check 'fabric: what passes, what passes straight, what comes back' '
    ! awk "$near"" \$2 == \"trans\" { t = \$4 * \$9; if (!(\$11 == \"Tv\" && near(t, \$12) && near(t * \$10, \$14) &&
        near(\$4 - t, \$16))) print }" all | grep .'

# A sensor that looks up under a roof of it, and a sky of 1 W/sr/m2 all around: pi times what passes, in 179 lm/W.
echo '0 0 0 0 0 1' > up.pts
lit() {  # MATERIAL FILE
    printf 'void glow sky 0 0 4 1 1 1 0\nsky source dome 0 0 4 0 0 1 180\n%s polygon roof 0 0 12 %s\n' "$1" \
        "-500 -500 1  500 -500 1  500 500 1  -500 500 1" > roof.rad
    ptrace -w- -frames 257 -points up.pts "$library/$2" roof.rad | ptaccum -last -o - |
        vcmetrics -metrics up.mean -last | tail -n 1 | cut -f 3
}
for fabric in fabric_white_5 fabric_charcoal_1; do
    told=$(awk -v n=$fabric '$1 == n { print $12 }' all)
    check "a picture has that of $fabric" 'awk -v e="$(lit $fabric fabrics.rad)" -v t="$told" "BEGIN {
        print e / 179 / 3.14159265; exit !(e / 179 / 3.14159265 > .97 * t && e / 179 / 3.14159265 < 1.03 * t) }"'
done
check 'a blind of the example in blinds.rad is rendered' '
    sed -n "s/^# *!genbox/!genbox/p" "$library/blinds.rad" > blind.rad; test -s blind.rad
    ptrace -vf "$TOP/examples/scenes/office/view.vf" -x 16 -y 16 -frames 2 "$library"/*.rad blind.rad roof.rad |
        ptaccum -last > x.hdr; test -s x.hdr'
