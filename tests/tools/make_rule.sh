# SPDX-License-Identifier: BSD-3-Clause
# ptrace -M: a rule of make with every file that a rendering reads, and no other.
. "${TOP:?}/tests/lib.sh"
needs ptrace
vectors=$TOP/tests/golden/vectors
mkdir parts pictures 'a folder'
printf 'void plastic m 0 0 5 .5 .5 .5 0 0\nm sphere s 0 0 4 5 0 0 1\n' | tee parts/ball.rad parts/more.rad > unused.rad
cp "$vectors"/tri.obj 'a folder/t $1#.obj'
cp "$TOP"/tests/golden/glare/images/office256.hdr pictures/p.hdr
echo 'half = .5;' > half.cal; echo 'v = half;' > f.cal; printf '1 0 1 2 1 1\n' > d.dat
echo '-ab 2' > render.opt; echo 'rvu -vtv -vp 0 0 0 -vd 1 0 0' > view.vf
cat > scene.rad << 'SCENE'
!xform -t 1 0 0 parts/ball.rad
!cat parts/more.rad | xform -rz 10
void brightfunc f 2 v f.cal 0 0
f brightdata d 4 noop d.dat . Px 0 0
d colorpict c 7 red green blue pictures/p.hdr . Px Py 0 0
c plastic mat 0 0 5 .5 .5 .5 0 0
void mesh t 1 "./a folder/t $1#.obj" 0 0
SCENE
files() {
    ptrace -w- "$@" -M out.hdr scene.rad > rule
    sed -n '/^out.hdr:/,/^$/p' rule | sed 's/ \\$//; s/^ *//; 1d; /^$/d' | sort
}

check 'all files are there: text, functions, data, pictures, meshes, options, views' '
    files -f half.cal -vf view.vf @render.opt > said
    printf "%s\n" "a\\ folder/t\\ \$\$1\\#.obj" d.dat f.cal half.cal parts/ball.rad parts/more.rad \
        pictures/p.hdr render.opt scene.rad view.vf | sort > want
    diff want said'
check 'make takes it, names with blanks, too' '
    printf "all: out.hdr\n\nout.hdr:\n\techo made > out.hdr\n" > Makefile; cat rule >> Makefile
    make -s; test -s out.hdr; : > out.hdr; make -s; test ! -s out.hdr
    touch -d "+1 hour" "a folder/t \$1#.obj"; make -s; test -s out.hdr'
check 'and goes on when a file has been removed' ': > out.hdr; rm parts/more.rad; make -s; test -s out.hdr'
check 'an octree stands for its files' '
    command -v oconv > /dev/null || exit 0
    cp parts/ball.rad parts/more.rad; oconv parts/ball.rad > o.oct; ptrace -w- -M x o.oct | grep -q "^parts/ball.rad:"'
check_error 'a missing file is an error, not a rule' '[12]' '^ptrace: .*half.cal' '
    cp parts/ball.rad parts/more.rad; rm half.cal; ptrace -f half.cal -M x scene.rad'
