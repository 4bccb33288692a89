# SPDX-License-Identifier: BSD-3-Clause
# CONTRIBUTING's recipe "Add an option", followed in a copy of the tree: `-made-up f`, a part of the fingerprint.
# Builds ptrace of the copy (with ccache what add_material.sh built serves again); label slow.
. "${TOP:?}/tests/lib.sh"
needs cmake mandoc
mkdir tree
tar -C "$TOP" --exclude='./build*' --exclude=./.git --exclude=./out --exclude=./.ispc -cf - . | tar -C tree -xf -
cp -r tree before
cd tree || exit 2

# 1. the variable
sed -i 's|^    uint64_t seed = 1;|&\n    double made_up = .5;  // -made-up|' lib/render/options.h
# 2. its declaration
sed -i '/^    t.add("-me r g b"/i\
    t.add("-made-up f", "Made up", r.made_up).within(0, 1).unit("metres").from_scene().moves_pixels();' \
    lib/render/options.cpp
# 3. the page
sed -i 's|^\.BI \\-me " r g b"|.BI \\-made\\-up " f"\nMade up in metres (0.5).\n.TP\n&|' man/ptrace.1
# 4. what it does
cat >> tests/tools/ptrace_options.sh << 'END'
check '-made-up is read' 'ptrace -made-up .2 -defaults | grep -q "^-made-up 0.2 "'
END

recipe() { sed -n '/^## Add an option/,/^For other/s/^[0-9]\. `\([a-z]*\/[^`]*\)`.*/\1/p' "$TOP/CONTRIBUTING.md"; }
cd ..
check 'the files that were touched are those of the recipe, and no others' '
    { diff -rq before tree || true; } | sed -E "s|^Files before/(.*) and .*|\1|" | sort > touched
    recipe | sort | diff - touched'

launcher=
command -v ccache > /dev/null && launcher=-DCMAKE_CXX_COMPILER_LAUNCHER=ccache
export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1
build() {
    cmake --build build -j 2 --target ptrace ptrace_options_test > log 2>&1 || { grep -m 5 error log; false; }
}
check 'the program builds with it' '
    cmake -S tree -B build $launcher -DLUXPIPE_ISPC= -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS=-O0 > log 2>&1 ||
        { tail -20 log; false; }
    build'

check 'its value is read, shown and kept in range' '
    build/bin/ptrace -made-up 1 -defaults | grep -q "^-made-up 1 .*# Made up in metres (0.5)."
    build/bin/ptrace -help | grep -q "^  -made-up f  *Made up in metres (0.5).$"'
check_error 'a wrong one is refused' 1 '^ptrace: -made-up: 2 is outside 0 to 1' 'build/bin/ptrace -made-up 2 x.rad'
check 'the page says what -help says' '
    mkdir bin; cp build/bin/ptrace "$BIN"/{ptaccum,vcmetrics,vcregion} bin
    BIN=$PWD/bin TOP=$PWD/tree bash tree/tests/docs/options.sh'

echo 'void light l 0 0 3 1 1 1 l sphere s 0 0 4 0 5 0 1' > scene.rad
fingerprint() { build/bin/ptrace -w- -device cpu -x 4 -y 4 -frames 1 "$@" scene.rad | strings | grep ^FINGERPRINT=; }
check 'another value is another fingerprint' '
    one=$(fingerprint -made-up 0); two=$(fingerprint -made-up 1); [ -n "$one" ] && [ "$one" != "$two" ]'
check 'the test of options passes' 'build/bin/ptrace_options_test'
check 'it fails where .moves_pixels() is forgotten, and names the option' '
    sed -i "/-made-up/s/\.moves_pixels()//" tree/lib/render/options.cpp; build
    ! build/bin/ptrace_options_test > said && grep -q -- "-made-up" said'
