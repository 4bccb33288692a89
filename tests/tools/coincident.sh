# SPDX-License-Identifier: BSD-3-Clause
# Large faces of different modifiers in one place are told of in one line; faces that touch or have one modifier are
# not.
. "${TOP:?}/tests/lib.sh"
needs ptrace
cat > head.rad << 'end'
void glow sky 0 0 4 1 1 1 0
sky source dome 0 0 4 0 0 1 360
void plastic floor 0 0 5 .2 .2 .2 0 0
void plastic ground 0 0 5 .5 .5 .5 0 0
end
square() { # modifier x y half z, corners from below or (5 = down) from above
    if [ "$6" = down ]; then order='1 4 3 2'; else order='1 2 3 4'; fi
    for k in $order; do
        case $k in
        1) echo "$(($2 - $4)) $(($3 - $4)) $5" ;;
        2) echo "$(($2 + $4)) $(($3 - $4)) $5" ;;
        3) echo "$(($2 + $4)) $(($3 + $4)) $5" ;;
        4) echo "$(($2 - $4)) $(($3 + $4)) $5" ;;
        esac
    done | tr '\n' ' ' | sed "s/^/$1 polygon p$1$2$3 0 0 12 /"
    echo
}
render() { cat head.rad - > s.rad; ptrace -frames 1 -x 4 -y 4 -vp 0 0 9 -vd 0 .1 -1 s.rad 2>&1 > /dev/null; }
silent() { render > said; test ! -s said || { cat said; false; }; }
pair='lies in the same place, first "floor" and "ground" about'

check 'a ground in the plane of a floor' '
    { square floor 0 0 3 0; square ground 0 0 20 0; } | render > said
    test $(wc -l < said) = 1
    grep -q "^ptrace: warning: s.rad:6: one pair of large faces with different modifiers $pair -*[0-2]" said'
check 'no word where each is seen from its own side, as of a house on its ground' '
    { square floor 0 0 3 0 down; square ground 0 0 20 0; } | silent'
check 'which of two of one name' '
    { square floor 0 0 3 0; echo "void plastic floor 0 0 5 .5 .5 .5 0 0"; square floor 0 0 20 0; } | render > said
    grep -q "first \"floor\" (s.rad:3) and \"floor\" (s.rad:6) about" said'
check 'three of them' '
    { square floor 0 0 3 0; square floor 8 0 3 0; square floor 0 8 3 0; square ground 0 0 20 0; } | render > said
    test $(wc -l < said) = 1
    grep -q "3 pairs of large faces with different modifiers lie in the same place" said'
check 'a disc on a tilted plane' '
    { echo "floor ring r 0 0 8 0 0 1 0 1 1 0 1"; echo "ground polygon p 0 0 12 -4 -3 4 4 -3 4 4 5 -4 -4 5 -4"; } |
        render > said
    grep -q "one pair" said'
check 'no word where faces touch, lie apart or have one modifier' '
    { square floor 0 0 3 0; square ground 6 0 3 0; } | silent
    { square floor 0 0 3 1; square ground 0 0 20 0; } | silent
    { square floor 0 0 3 0; square floor 0 0 20 0; } | silent'
check 'nor of a hole that the other fills' '
    { square floor 0 0 1 0; echo "ground polygon p 0 0 30 -9 -9 0 9 -9 0 9 9 0 -9 9 0 -9 -9 0
      -1 -1 0 -1 1 0 1 1 0 1 -1 0 -1 -1 0"; } | silent'
