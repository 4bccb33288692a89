# SPDX-License-Identifier: BSD-3-Clause
# A file that a scene names lies beside the scene, whatever of this name lies in the working folder (decision 41): every
# kind of name that there is, in a scene of another folder, with a decoy here.
. "${TOP:?}/tests/lib.sh"
needs ptrace
mkdir model model/parts
p='void plastic p 0 0 5 .5 .5 .5 0 0'
vectors=$TOP/tests/golden/vectors
printf 'void glow g 0 0 4 1 1 1 0\ng source sky 0 0 4 0 0 1 360\n' > model/sky.rad
ball() { printf '%s\np sphere s 0 0 4 0 0 0 %s\n' "$p" "$1"; }
picture() { printf '#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n%b' "$1"; }

# kind NAME SCENE: the scene names NAME, which `mine` writes into its folder and `other` here
looks() { ptrace -vp 0 -5 0 -vd 0 1 0 -x 8 -y 8 -frames 2 -ab 1 "$@" 2> said | tail -c 768; }
kind() {
    name=$1; printf '%b\n' "$2" > model/s.rad
    check "$name: the scene's own, and a warning names both" '
        mine > "model/$name"; rm -f "$name"
        looks model/s.rad model/sky.rad > alone; [ ! -s said ]; test "$(wc -c < alone)" = 768
        mkdir -p "$(dirname "$name")"; other > "$name"
        looks model/s.rad model/sky.rad > here; cmp alone here
        grep -q "s.rad:[0-9]*: \"$name\" is model/$name beside the file that names it" said
        grep -q " $name by RADIANCE.s rules, which differs" said; test "$(wc -l < said)" = 1
        cp "model/$name" "$name"; looks model/s.rad model/sky.rad > here; cmp alone here; [ ! -s said ]
        other > "$name"; printf "%s\n" "!xform model/s.rad" > s.rad   # named by a file of this folder
        looks s.rad model/sky.rad > here; cmp alone here
        mv "model/$name" kept; not cmp <(looks model/s.rad model/sky.rad) alone; [ ! -s said ]; mv kept "model/$name"
        rm "$name"'
}

mine() { ball 1; }; other() { ball 2; }
kind part.rad '!xform part.rad'
kind parts/part.rad '!cat parts/part.rad | xform -t .1 0 0'
kind ./part.rad '!xform ./part.rad'
kind inner.rad 'void instance i 1 inner.rad 0 0'
mine() { printf '0 0 0 1 1 1 1 0\n'; }; other() { printf '0 0 0 2 2 2 2 0\n'; }
kind outline.dat "$p\n!genprism p b outline.dat"
mine() { echo 0 0 0 0; }; other() { echo 3 3 3 3; }
kind grid.dat "$p\n!gensurf p b s grid.dat t 1 1"
mine() { echo 'f = .5;'; }; other() { echo 'f = .2;'; }
patterned="0 0\nb plastic q 0 0 5 .5 .5 .5 0 0\nq sphere s 0 0 4 0 0 0 1"
kind f.cal "void brightfunc b 2 f f.cal $patterned"
mine() { printf '1\n0 1 2\n.5 .6\n'; }; other() { printf '1\n0 1 2\n.1 .2\n'; }
kind d.dat "void brightdata b 4 noop d.dat . frac(Px) $patterned"
mine() { picture '\x80\x80\x80\x81'; }; other() { picture '\x40\x80\x80\x80'; }
kind p.hdr "void colorpict b 7 red green blue p.hdr . frac(Px) frac(Pz) $patterned"
mine() { printf 'v -1 0 -1\nv 1 0 -1\nv 1 0 1\nf 1 2 3\n'; }
other() { printf 'v -1 0 -1\nv 1 0 -1\nv 0 0 1\nf 1 2 3\n'; }
kind m.obj "$p\np mesh m 1 m.obj 0 0"
mine() { cat "$vectors/klemsq.xml"; }; other() { cat "$vectors/tt3.xml"; }
kind b.xml 'void BSDF b 6 0 b.xml 0 0 1 . 0 0\nb polygon f 0 0 12 -1 0 -1 1 0 -1 1 0 1 -1 0 1'

check 'two folders have function files of one name, and data' '
    mkdir a b; echo "f = .5;" > a/f.cal; echo "f = .2;" > b/f.cal
    for x in a b; do
        printf "void brightfunc $x 2 f f.cal 0 0\n$x glow g$x 0 0 4 1 1 1 0\ng$x sphere s 0 0 4 0 0 0 1\n" \
            > $x/s.rad; done
    printf "!xform -t 9 0 0 a/s.rad\n!xform b/s.rad\n" > both.rad; cmp <(looks both.rad) <(looks b/s.rad)
    printf "!xform a/s.rad\n!xform -t 9 0 0 b/s.rad\n" > both.rad; cmp <(looks both.rad) <(looks a/s.rad)
    ! cmp <(looks a/s.rad) <(looks b/s.rad)'
check 'a rad input file names what lies beside it: scene, view file, options' '
    ball 1 > model/part.rad; ball 2 > part.rad; echo "rvu -vp 0 -5 0 -vd 0 1 0" > model/eye.vf
    echo "rvu -vp 0 -9 0 -vd 0 1 0" > eye.vf; echo "-ab 1" > model/opts; echo "-ab 0" > opts
    printf "scene= part.rad sky.rad\nview= -vf eye.vf\nrender= @opts -x 8 -y 8\n" > model/r.rif
    ptrace -rif model/r.rif -frames 2 2> said | tail -c 768 > here; test "$(grep -c "which differs" said)" = 3
    (cd model; ptrace -rif r.rif -frames 2 | tail -c 768) | cmp - here'
check 'a name on the command line is none of these' '
    ball 1 > model/part.rad; ball 2 > part.rad; looks part.rad model/sky.rad > here; (cd model; ptrace -vp 0 -5 0 \
        -vd 0 1 0 -x 8 -y 8 -frames 2 -ab 1 ../part.rad sky.rad | tail -c 768) | cmp - here'
check 'the fingerprint is that of what was read' '
    printf "!xform part.rad\n" > model/s.rad; print() { ptrace -x 8 -y 8 -frames 1 "$1" model/sky.rad 2> /dev/null |
        grep -a ^FINGERPRINT=; }
    a=$(print model/s.rad); cp model/part.rad part.rad; b=$(print model/s.rad); test "$a" = "$b"
    ball 2 > model/part.rad; c=$(print model/s.rad); test "$a" != "$c"'
