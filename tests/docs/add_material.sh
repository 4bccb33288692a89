# SPDX-License-Identifier: BSD-3-Clause
# CONTRIBUTING's recipe "Add a material", followed in a copy of the tree: `matte R G B`, which scatters as plastic
# without gloss.  Builds ptrace of the copy; label slow.
. "${TOP:?}/tests/lib.sh"
needs cmake
mkdir tree
tar -C "$TOP" --exclude='./build*' --exclude=./.git --exclude=./out --exclude=./.ispc -cf - . | tar -C tree -xf -
cp -r tree before
cd tree || exit 2

# 1. the row, after the last one
sed -i -E '/^  (ROW |SAME)\(.*\)$/ {
    s/$/ \\/
    a\  ROW (MATTE, matte, 0, only(3), none, 0, 0, no, no, no, turns, MT_EVEN)
}' lib/kernels/material/materials.h

# 2. its lobes
cat > lib/kernels/material/mat_matte.h << 'END'
// SPDX-License-Identifier: BSD-3-Clause
// matte: Lambert's law alone.  args: R G B
#ifndef LUX_MAT_MATTE_H
#define LUX_MAT_MATTE_H

FN void mat_matte(PRIVATE(const Surface) g, GLOBAL const float* arg, PRIVATE(Lobes) lobes) {
    lobes->diffuse_r = mul3(f3_at(arg), g->color);
    lobes->ambient_r = lobes->diffuse_r;
}
#endif
END

# 3. its case
sed -i -e 's|^#include "kernels/material/mat_glass.h"|&\n#include "kernels/material/mat_matte.h"|' \
    -e 's|^    case M_GLASS:.*|&\n    case M_MATTE: mat_matte(g, arg, lobes); break;|' lib/kernels/material/material.h

recipe() { sed -n '/^## Add a material/,/^Only where/s/^[0-9]\. `\(lib[^`]*\)`.*/\1/p' "$TOP/CONTRIBUTING.md"; }
cd ..
check 'the files that were touched are those of the recipe, and no others' '
    { diff -rq before tree || true; } | sed -E "s|^Only in tree/(.*): |\1/|; s|^Files before/(.*) and .*|\1|" |
        sort > touched
    recipe | sed "s/NAME/matte/" | sort | diff - touched'

launcher=
command -v ccache > /dev/null && launcher=-DCMAKE_CXX_COMPILER_LAUNCHER=ccache
export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1
check 'the program builds with it' '
    cmake -S tree -B build $launcher -DLUXPIPE_ISPC= -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS=-O0 > log 2>&1 ||
        { tail -20 log; false; }
    cmake --build build -j 2 --target ptrace > log 2>&1 || { grep -m 5 error log; false; }'

cat > room.rad << 'END'
void light lamp 0 0 3 20 20 20
lamp sphere bulb 0 0 4 0 0 2 .3
wall bubble room 0 0 4 0 0 0 4
wall sphere thing 0 0 4 1 1 0 .7
END
view='-vtv -vp -3 0 0 -vd 1 0 0 -vh 90 -vv 90 -x 24 -y 24'
picture() { # line of the wall's material
    { echo "$1"; cat room.rad; } > scene.rad
    build/bin/ptrace -w- -device cpu $view -frames 4 -ab 2 scene.rad > frames
    tail -c $((24 * 24 * 12)) frames
}
check 'it looks as plastic without gloss, to the last bit' '
    picture "void plastic wall 0 0 5 .7 .5 .3 0 0" > plastic; picture "void matte wall 0 0 3 .7 .5 .3" > matte
    test -s matte; cmp plastic matte'
check 'and not as darker plastic' '
    picture "void plastic wall 0 0 5 .6 .5 .3 0 0" > plastic; ! cmp -s plastic matte'
check_error 'its arguments are counted' 1 "scene.rad:1: .*needs 3 real arguments, has 2" '
    picture "void matte wall 0 0 2 .7 .5"'
