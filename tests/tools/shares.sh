# SPDX-License-Identifier: BSD-3-Clause
# Fingerprints: shares of one rendering merge, those of another scene, view, size or set of options are refused.  What
# does not decide the pixels - paths, dates, comments, threads, the range of frames - does not count.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum mkstream
cp "$TOP"/examples/scenes/office/* .
size='-x 24 -y 24' files='materials.rad layout.rad sky_1400.rad'
print() { ptrace -w- -frames 1 $size "$@" | strings | sed -n 's/^FINGERPRINT=//p'; }
share() { ptrace -w- $size -frames "$1" "${@:3}" | ptaccum -last -o "$2"; }
first=$(print -vf view.vf $files)

check 'a fingerprint names its parts' '
    echo "$first" | grep -qE "^scene:[0-9a-f]{16} view:[0-9a-f]{16} options:[0-9a-f]{16} estimator:[0-9]+$"'
check 'the same again' '[ "$(print -vf view.vf $files)" = "$first" ]'
check 'one thread' '
    [ "$(taskset -c 0 ptrace -w- -frames 1 $size -vf view.vf $files | strings |
        sed -n "s/^FINGERPRINT=//p")" = "$first" ]'
check 'seed and range of frames' '
    [ "$(ptrace -w- -seed 9 -frames 3:3 $size -vf view.vf $files | strings | sed -n "s/^FINGERPRINT=//p")" = "$first" ]'
check 'other paths' '
    mkdir -p a/b; cp *.rad *.vf a/b; cd a;
    [ "$(print -vf b/view.vf b/materials.rad b/layout.rad b/sky_1400.rad)" = "$first" ]'
check 'comments and dates' '
    cp materials.rad m.rad; echo "# more" >> m.rad; [ "$(print -vf view.vf m.rad layout.rad sky_1400.rad)" = "$first" ]'
check 'the same options spelt out' '[ "$(print -vf view.vf -ab unlimited -dp 1024 -u- $files)" = "$first" ]'

differs() {
    local now; now=$(print "$@")
    [ -n "$now" ] && diff <(echo "$first" | tr ' ' '\n') <(echo "$now" | tr ' ' '\n') |
        sed -n 's/^> \([a-z]*\):.*/\1/p' | tr '\n' ' '
}
check 'another sky is another scene' '[ "$(differs -vf view.vf materials.rad layout.rad sky_overcast.rad)" = "scene " ]'
check 'so is a colour' '
    sed "s/^5 *[.0-9]*/5 .123/" materials.rad > m.rad;
    [ "$(differs -vf view.vf m.rad layout.rad sky_1400.rad)" = "scene " ]'
check 'so is a data or function file' '
    printf "void brightfunc p 2 v f.cal 0 0\np plastic w 0 0 5 .5 .5 .5 0 0\nw sphere s 0 0 4 0 5 0 1\n" > f.rad
    echo "v = .5;" > f.cal; one=$(print f.rad); echo "v = .6;" > f.cal; two=$(print f.rad);
    [ -n "$two" ] && [ "$one" != "$two" ]'
check 'another option' '
    [ "$(differs -vf view.vf -ab 4 $files)" = "options " ] && [ "$(differs -vf view.vf -st .1 $files)" = "options " ]'
check 'another view' '[ "$(differs -vf view.vf -vp 2 2.6 1.2 $files)" = "view " ]'
check 'another size' '[ "$(size="-x 25 -y 25"; differs -vf view.vf $files)" = "view " ]'

share 0:3 a.exr -vf view.vf $files
share 4:7 b.exr -vf view.vf $files
share 4:7 sky.exr -vf view.vf materials.rad layout.rad sky_overcast.rad
share 4:7 ab.exr -vf view.vf -ab 2 $files
check 'shares merge' 'ptaccum a.exr b.exr -o ab8.exr && strings ab8.exr | grep -qx "FINGERPRINT=$first"'
check_error 'another scene is refused' 1 '^ptaccum: sky.exr: has another scene than a.exr' '
    ptaccum a.exr sky.exr -o x.exr'
check_error 'other options are refused' 1 '^ptaccum: ab.exr: has other options than a.exr' '
    ptaccum a.exr ab.exr -o x.exr'
check_error 'also of another seed' 1 '^ptaccum: seed.exr: has another scene than a.exr' '
    share 0:3 seed.exr -seed 2 -vf view.vf materials.rad layout.rad sky_overcast.rad; ptaccum a.exr seed.exr -o x.exr'
check_error 'inside a stream, too' 1 'frame 2: has another scene than the frames before it' '
    { ptrace -w- $size -frames 2 -vf view.vf $files;
    ptrace -w- $size -frames 2:3 -vf view.vf materials.rad layout.rad sky_0900.rad; } | ptaccum -last > x.hdr'
check_error 'and when a run goes on' 1 'frame 4: has other options than a.exr' '
    ptrace -w- $size -ab 1 -frames 4:5 -vf view.vf $files | ptaccum a.exr - -o a.exr'
check 'which goes on otherwise' '
    ptrace -w- $size -frames 4:7 -vf view.vf $files | ptaccum a.exr - -o a.exr && mkstream differ a.exr ab8.exr |
        awk "{ exit !(\$1 <= 3e-7) }"'
check 'a sum without one is taken, with a warning' '
    ptaccum b.exr -ff | sed "/^FINGERPRINT/d" > old.hdr; ptaccum ab8.exr -o w.exr; share 0:3 c.exr -vf view.vf $files;
    ptaccum c.exr old.hdr -o w.exr 2> said
    [ "$(wc -l < said)" = 1 ] && grep -q "warning: old.hdr: cannot tell whether" said'
check 'no refused merge left a file' '[ ! -e x.exr ]'
