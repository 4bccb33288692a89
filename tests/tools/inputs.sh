# SPDX-License-Identifier: BSD-3-Clause
# Scenes as other programs leave them: Wavefront files, text from Windows, rad's assignments after a rad input file.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics
lamp='void light l 0 0 3 9 9 9\nl source s 0 0 4 0 0 1 20\n'
printf "$lamp"'void plastic "Brick Wall" 0 0 5 .5 .5 .5 0 0\n' > wall.rad
printf "$lamp"'void plastic Brick 0 0 5 .5 .5 .5 0 0\n' > brick.rad
faces='v -9 -9 -1\nv 9 -9 -1\nv 9 9 -1\nv -9 9 -1\n'
printf '# made by hand\n'"$faces"'usemtl Brick Wall \r\nf 1 2 3 4\n' > wall.obj
printf "$faces"'f 1 2 3 4\n' > bare.obj
view='-w- -vtv -vd 0 0 -1 -vu 0 1 0 -x 16 -y 16 -frames 2'
brightness() { ptrace $view "$@" | ptaccum -last -ff | vcmetrics -metrics Lavg | tail -n 1 | cut -f 3 | cut -c 1-5; }

check 'a material of an .obj file may have a blank in its name' 'brightness wall.rad wall.obj | grep -x 24.28'
check 'or go by its first word, as obj2mesh takes it' '
    [ "$(brightness brick.rad wall.obj)" = "$(brightness wall.rad wall.obj)" ]'
check_error 'one that is not defined is reported where it is named' 1 \
    '^ptrace: ./wall.obj:6: modifier "Brick Wall" is not defined$' '
    printf "$lamp" > none.rad; ptrace $view none.rad wall.obj > x'
check_error 'faces without a material give a warning' 0 \
    '^ptrace: warning: ./bare.obj: faces without a material .usemtl. are left out$' '
    ptrace $view -w+ wall.rad bare.obj | cat > x'

printf '\357\273\277void plastic m 0 0 5 .5 .5 .5 0 0\r\nm polygon p 0 0 9 0 0 0 1 0 0 0 1 0\r\n' > marked.rad
check 'a byte order mark before a scene means nothing' 'ptrace $view marked.rad > x'
mkdir -p parts/deep && cp marked.rad parts/box.rad && cp marked.rad parts/deep/box.rad
check 'paths of Windows are paths' '
    printf "!xform -t 1 0 0 parts\\\\deep\\\\box.rad\n!xform parts\\\\box.rad\n!xform .\\\\parts\\\\box.rad\n" \
        > windows.rad
    grep -q "parts.deep" windows.rad; ptrace $view windows.rad > x'
mkdir -p lib/deep && printf 'half = .5;\n' > lib/deep/half.cal && cp wall.obj lib/deep
for file in ramp.dat small.hdr klemsq.xml; do cp "$TOP/tests/golden/vectors/$file" lib/deep; done
named() {  # PRIMITIVE: it gives the same picture whether it names its file with slashes or with backslashes
    printf "$lamp$1\n" 'lib/deep/' > slashes.rad; printf "$lamp$1\n" 'lib\deep\' > backslashes.rad
    ptrace $view slashes.rad > a; ptrace $view backslashes.rad > b
    same=$(brightness slashes.rad); [ "$same" != 0 ] && [ "$same" = "$(brightness backslashes.rad)" ]
}
floor='plastic m 0 0 5 .5 .5 .5 0 0\nm ring r 0 0 8 0 0 -1 0 0 1 0 9'
check 'also in primitives: function files' 'named "void brightfunc p 2 half %shalf.cal 0 0\np $floor"'
check 'data' 'named "void brightdata p 4 noop %sramp.dat . Px+5 0 0\np $floor"'
check 'pictures' 'named "void colorpict p 7 red green blue %ssmall.hdr . Px Py 0 0\np $floor"'
check 'BSDF files' 'named "void BSDF m 6 0 %sklemsq.xml 0 1 0 . 0 0\nm ring r 0 0 8 0 0 -1 0 0 1 0 9"'
check 'meshes' 'named "void plastic Brick 0 0 5 .5 .5 .5 0 0\nvoid mesh i 1 %swall.obj 0 0"'
check 'in quotes of a command' '
    printf "!xform -t 1 0 0 \"parts\\\\deep\\\\box.rad\"\n" > quoted.rad; ptrace $view quoted.rad > x'
check 'and in rad input files, whose lines may end as those of Windows do' '
    printf "RESOLUTION= 9\r\nview= a -vd 0 1 -1\r\nscene= parts\\\\deep\\\\box.rad \\\\\r\n  brick.rad\r\n" > w.rif
    ptrace -w- -rif w.rif -frames 1 > x'
check 'a file of the name with its backslash comes first' '
    printf "one = 1;\n" > lib/own.cal; printf "one = 2;\n" > "lib\\own.cal"
    printf "$lamp""void brightfunc p 2 one lib\\\\own.cal 0 0\np $floor\n" > own.rad; grep -q "lib.own" own.rad
    [ "$(brightness own.rad)" = 48.57 ]'
joined() { printf "$faces$1" > joined.obj; [ "$(brightness brick.rad joined.obj)" = 24.28 ]; }
check 'a backslash joins lines of an .obj file' 'joined "usemtl Brick\nf 1 2 \\\\\n3 4\n"'
check 'with a blank between' 'joined "usemtl Brick\nf 1 2\\\\\n3 4\n"'
check 'where lines end as those of Windows do' 'joined "usemtl Brick\r\nf 1 2 \\\\\r\n3 4\r\n"'
check 'but none to a comment' 'joined "# C:\\\\models\\\\\nusemtl Brick\nf 1 2 3 4\n"'
check "an octree may be a command's output" '
    pixels() { ptrace $view -vp 0 0 5 "$@" | ptaccum -last -ff | sed "1,/^$/d"; }
    cp "$TOP/tests/golden/vectors/in_a.oct" .; pixels -exec brick.rad "!dd if=in_a.oct status=none" > a
    pixels brick.rad in_a.oct | cmp - a; pixels brick.rad > b; not cmp -s a b'
check 'names with a folder are found from elsewhere' '
    mkdir -p site/model/scene site/model/bsdf away; cp lib/deep/klemsq.xml site/model/bsdf/x.xml
    printf "void BSDF m 6 0 ./model/bsdf/x.xml 0 1 0 . 0 0\nm ring r 0 0 8 0 0 -1 0 0 1 0 9\n" > site/model/scene/e.rad
    cd away; ptrace $view ../site/model/scene/e.rad > x; cd ..; ptrace $view site/model/scene/e.rad > x'
check_error 'where the folder above the model is given, it is named' 1 \
    '^ptrace: site: is a folder, but no model of Honeybee: .*; site/model is one$' 'ptrace $view site > x'

printf '\357\273\277ZONE= I -1 1 -1 1 -1 1\nscene= wall.rad\nRESOLUTION= 16 16\nQUALITY= High\n' > t.rif
echo 'view= up -vtv -vp 0 0 0 -vd 0 0 1 -vu 0 1 0' >> t.rif
options_of() {
    ptrace -rif t.rif -w- -frames 1 "$@" | strings | sed -n "s/^FINGERPRINT=.*options:\([0-9a-f]*\).*/\1/p"
}
check 'words of rad after a rad input file stand for lines of it' '
    high=$(options_of QUALITY=High) low=$(options_of QUALITY=Low); [ -n "$high" ]; [ -n "$low" ]
    [ "$(options_of)" = "$high" ]; [ "$low" != "$high" ]; [ "$(options_of up QUAL=Low)" = "$low" ]
    ptrace -rif t.rif -w- -frames 1 RES=8 up | head -c 1000 | strings | grep -qx -e "-Y 8 +X 8"'
check 'options after -rif come later than they' '
    ptrace -rif t.rif -x 4 -y 4 -w- -frames 1 RES=8 up | head -c 1000 | strings | grep -qx -e "-Y 4 +X 4"'
check_error 'an unknown one is reported' 1 '^ptrace: QALITY=Low: "QALITY" is not a variable of rad' '
    ptrace -rif t.rif -frames 1 QALITY=Low > x'

# Numbers with a comma for the point, as some languages write them, are none: they were cut there.
picture() { printf '#?RADIANCE\n%s\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n\200\200\200\201' "$1" > p.hdr; }
for line in EXPOSURE=1,5 'EXPOSURE=1 5' COLORCORR=1,1,1 PIXASPECT=1,5 'VIEW= -vtv -vh 1,8e2' 'VIEW= -vp 1 2,5 3'; do
    check_error "a header line $line is reported" 1 "^vcmetrics: p.hdr: header line .$line" '
        picture "$line"; vcmetrics p.hdr'
done
check 'lines that end in blanks are read, and so are command lines of other programs' '
    picture "EXPOSURE=  1.5  "; vcmetrics -vtv -vh 60 -vv 60 p.hdr
    picture "rpict -vtv -vd 0 1 0 -vh 60 -vv oops x.oct"; vcmetrics -vtv -vh 60 -vv 60 p.hdr'
check 'an hour that no clock shows is told of' '
    for time in "gensky 3 21 25" "gensky 3 21 -1" "gensky 3 21 10:75" "gendaylit 3 21 25 -W 800 100" \
        "gendaylit 3 21 14:30 -W 800 100"; do
        printf "!$time\n" > sky.rad; ptrace $view -w+ sky.rad 2> said > x
        grep -q "^ptrace: warning: sky.rad:1: gen[a-z]*: .*\(hour\|minutes\)" said || { echo "$time"; exit 1; }
    done
    for time in "gensky 3 21 0" "gensky 3 21 +24" "gensky 3 21 10:59" "gendaylit 3 21 14.5 -W 800 100"; do
        printf "!$time\n" > sky.rad; echo "$time"
        ptrace $view -w+ sky.rad 2>&1 > x | not grep "hour\|minutes"
    done'

# cat joins files whose last lines do not end, and so does oconv.
floor='5 .5 .5 .5 0 0' wall='void plastic wall 0 0 5 .2 .2 .2 0 0\nwall polygon p 0 0 9 0 0 -1 1 0 -1 0 1 -1\n'
printf "!cat a.mat b.rad\n$lamp" > cat.rad
check_error '!cat of a file that ends in the middle of a line: the last word and the first are one' 1 \
    '^ptrace: cat.rad:1: plastic "floor": "0void" is not a number' '
    printf "void plastic floor 0 0 $floor" > a.mat; printf "$wall" > b.rad; ptrace $view cat.rad > x'
check_error 'a comment at its end goes on' 1 '^ptrace: cat.rad:1: modifier "wall" is not defined' '
    printf "void plastic floor 0 0 $floor # last" > a.mat; printf "$wall" > b.rad; ptrace $view cat.rad > x'
check 'a primitive in two files is one, a line end anywhere between them is enough' '
    printf "void plastic floor 0 0 5 .5 " > a.mat; printf ".5 .5 0 0\n$wall" > b.rad; ptrace $view cat.rad > x
    printf "void plastic floor 0 0 $floor" > a.mat; printf "\n$wall" > b.rad; ptrace $view cat.rad > x
    printf "void plastic floor 0 0 $floor\n" > a.mat; printf "$wall" > b.rad; ptrace $view cat.rad > x'
