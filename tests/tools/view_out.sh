# SPDX-License-Identifier: BSD-3-Clause
# EN 17037's view out by vcregion (docs/en17037.md): sight angle, layers and distance of a window in closed form.
. "${TOP:?}/tests/lib.sh"
needs ptrace vcregion
# A wall at y = 0 with a window 1.2 m wide, .9 to 2.3 m above the floor; a house 25 m off, from -3 to 6 m.
cat > room.rad << 'END'
void plastic wall 0 0 5 .5 .5 .5 0 0
void plastic facade 0 0 5 .3 .3 .3 0 0
void glass pane 0 0 3 .9 .9 .9
void glow skyglow 0 0 4 1 1 1 0
void glow groundglow 0 0 4 .2 .2 .2 0
skyglow source sky 0 0 4 0 0 1 180
groundglow source ground 0 0 4 0 0 -1 180
wall polygon left 0 0 12 -3 0 0  -3 0 3  -.6 0 3  -.6 0 0
wall polygon right 0 0 12 .6 0 0  .6 0 3  3 0 3  3 0 0
wall polygon under 0 0 12 -.6 0 0  -.6 0 .9  .6 0 .9  .6 0 0
wall polygon over 0 0 12 -.6 0 2.3  -.6 0 3  .6 0 3  .6 0 2.3
pane polygon glazing 0 0 12 -.6 0 .9  -.6 0 2.3  .6 0 2.3  .6 0 .9
wall polygon west 0 0 12 -3 0 0  -3 0 3  -3 5 3  -3 5 0
wall polygon east 0 0 12 3 0 0  3 0 3  3 5 3  3 5 0
wall polygon north 0 0 12 -3 5 0  -3 5 3  3 5 3  3 5 0
wall polygon floor 0 0 12 -3 0 0  3 0 0  3 5 0  -3 5 0
wall polygon ceiling 0 0 12 -3 0 3  3 0 3  3 5 3  -3 5 3
facade polygon house 0 0 12 -50 -25 -3  50 -25 -3  50 -25 6  -50 -25 6
END
listed() { # REGION POINT HEIGHT-OF-THE-VIEW COLUMNS ROWS
    echo "$1" > out.regions
    vcregion -vtc -vp $2 -vd 0 -1 0 -vh 360 -vv "$3" -x "$4" -y "$5" -pa 0 -list out.regions room.rad 2> said |
        tail -n 1
}
seen() { listed "$1" "$2" 170 720 340 | grep -q .; }

check 'the sight angle of a window 3 m and 1.2 m away: 2 atan .2 and 2 atan .5' '
    for y in 3 1.2; do
        listed "opening surface glazing*" "0 $y 1.2" .1 3600 1 |
            awk -v y=$y "{ off = \$4 * 360 - 2 * atan2(.6, y) * 45 / atan2(1, 1); exit !(off * off < .01 ^ 2) }"
    done'
check 'layers: the house, the sky above it; the ground at its foot only near the window' '
    seen "landscape modifier facade" "0 3 1.2"; seen "sky modifier skyglow" "0 3 1.2"
    not seen "ground modifier groundglow" "0 3 1.2"; grep -q "\"ground\" is empty" said
    seen "ground modifier groundglow" "0 .5 1.2"'
check 'no sky from where the head of the window hides it: 2.3 m under 6 m' '
    not seen "sky modifier skyglow" "0 4.9 2"; grep -q "\"sky\" is empty" said'
check 'the house is more than 20 m away, and less than 50' '
    not seen "near surface house* within box3d -60 -20 -10 60 0 10" "0 3 1.2"; grep -q "\"near\" is empty" said
    seen "near surface house* within box3d -60 -50 -10 60 0 10" "0 3 1.2"'
