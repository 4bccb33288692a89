# SPDX-License-Identifier: BSD-3-Clause
# The programs for Windows under wine: the same bytes as this machine's, for frames, pictures, masks, tables and years.
. "${TOP:?}/tests/lib.sh"
needs wine ptrace ptaccum vcmetrics vcregion vcyear mkstream
exe=${WINDOWS:-$TOP/build-windows/bin}
[ -e "$exe/vcyear.exe" ] || skip 'no programs for Windows: make zip'
export WINEPREFIX=${WINEPREFIX:-$TMP/wine} WINEDEBUG=-all SOURCE_DATE_EPOCH=0 TZ=UTC
mkdir windows
for tool in ptrace ptaccum vcmetrics vcregion vcyear; do
    printf '#!/bin/sh\nLC_ALL=C.UTF-8 exec wine "%s" "$@"\n' "$exe/$tool.exe" > windows/$tool
done
chmod +x windows/*
[ "$(ptaccum -version)" = "$(windows/ptaccum -version)" ] || skip 'those programs are of another version'
images=$TOP/tests/golden/images scenes=$TOP/examples/scenes
mkstream frames 0 9 > frames.hdr
cp "$TOP/examples/office.regions" .
view="-vf $scenes/office/view.vf -x 32 -y 32" room="$scenes/office/materials.rad $scenes/office/layout.rad"
office="$view $room $scenes/office/sky_1400.rad"

# both COMMAND: by this machine's programs and by those for Windows, each in a folder of its own: the same files.
both() {
    rm -rf here there && mkdir here there
    (cd here && eval "$1" > stdout)
    (cd there && PATH=$TMP/windows:$PATH && eval "$1" > stdout)
    [ -n "$(find here -size +0)" ] && diff -r here there
}
for device in cpu cpu:baseline; do
    check "frames by $device" "both 'ptrace -device $device -frames 3 $office'"
done
check 'frames, their sum, and metrics that end them' "both '
    ptrace $office | ptaccum -every x2 | vcmetrics -W- -metrics Ev,DGPf -ci 95 -until \"DGPf .2\" | cut -f 1,3-'"
check 'files of frames, messages in a file' "both '
    ptrace -e said -o f%d.hdr -frames 2 none.rad || ptrace -o f%d.hdr -frames 2 $office'"
check 'the library of materials' '[ -e "$(windows/ptrace -library | sed s/^Z://)/paints.rad" ]'
check 'sums of a stream, from a pipe to a pipe' "both 'cat ../frames.hdr | ptaccum -every 3 | cat'"
check 'pictures of every format, a sum and its parts' "both '
    ptaccum -last -o sum.hdr -o sum.exr -o sum.png ../frames.hdr
    for range in 0:3 4:9; do mkstream frames \${range%:*} \${range#*:} | ptaccum -last -o part_\${range%:*}.exr; done
    ptaccum part_0.exr part_4.exr -o whole.exr -half -o whole.hdr'"
check 'files that are there already are replaced' "both 'for n in 1 2; do ptaccum -o sum.exr ../frames.hdr; done; ls'"
check 'metrics, their intervals, sources, a drawing' "both '
    ptaccum -every x2 ../frames.hdr | vcmetrics -W- -metrics Ev,DGPf,Lavg -ci 95 | cut -f 1,3-
    vcmetrics -W- -sources $images/office_dusk.hdr; vcmetrics -W- -over over.png $images/hem_office.hdr
    vcmetrics -W- -like evalglare -d $images/per_office.hdr'"
check 'regions: a mask, a list, a preview' "both '
    vcregion -vf $scenes/office/view.vf -x 64 -y 64 -o mask.exr ../office.regions
    vcregion -vf $scenes/office/view.vf -list ../office.regions'"
check 'regions that the scene hides in part' "both '
    vcregion $view -o mask.exr ../office.regions $room'"
python3 "$TOP/tests/tools/room_year.py" room > room.tsv
check 'a year: its lines, a row for each sensor, a folder of honeybee' "both '
    vcyear -en17037 ../site.wea ../room.tsv; vcyear -en17037 ../site.wea -each ../room.tsv > each
    vcyear -format csv ../room.tsv; vcyear -honeybee folder ../room.tsv'"
check 'lines that end with CR LF' "
    sed 's/\$/\r/' office.regions > dos.regions
    both 'vcregion -vf $scenes/office/view.vf -list ../dos.regions'; cp there/stdout dos
    vcregion -vf $scenes/office/view.vf -list office.regions | cmp - dos"
check 'paths with backslashes and with letters outside of ASCII' '
    mkdir -p "Büro Süd/日本"; cp frames.hdr "Büro Süd/日本/"
    windows/ptaccum -last -o "Büro Süd\\日本\\summe.hdr" "Büro Süd\\日本\\frames.hdr"
    ptaccum -last -o sum.hdr "Büro Süd/日本/frames.hdr"
    cmp <(sed -n "/^FORMAT/,\$p" sum.hdr) <(sed -n "/^FORMAT/,\$p" "Büro Süd/日本/summe.hdr")'
cat > scene.rad << 'END'
void glow sky 0 0 4 1 1 1 0
sky source all 0 0 4 0 0 1 360
void brightfunc w 2 wave patterns\w.cal 0 0
w plastic floor 0 0 5 .5 .5 .5 0 0
floor ring ground 0 0 8 0 0 -1 0 0 1 0 5
END
check 'a scene in such a folder, a function file with a backslash in its name' '
    mkdir "Büro Süd/日本/patterns"; cp scene.rad "Büro Süd/日本/"
    echo "wave = .5 + .4*sin(Px)*exp(-Py*Py)*atan2(Pz,Px);" > "Büro Süd/日本/patterns/w.cal"
    view="-x 32 -y 32 -frames 2 -vp 0 0 1 -vd 0 1 -.5 -vu 0 0 1"
    windows/ptrace $view "Büro Süd\日本\scene.rad" | sed "/^ptrace/d" > there.hdr
    ptrace $view "Büro Süd/日本/scene.rad" | sed "/^ptrace/d" | cmp - there.hdr'
check 'a pattern is expanded, as no shell of Windows does' '
    ptaccum -last < frames.hdr > sum1.hdr; cp sum1.hdr sum2.hdr
    windows/vcmetrics -W- "sum?.hdr" | cmp - <(vcmetrics -W- sum1.hdr sum2.hdr)'
check 'a reader that leaves ends the program quietly' '
    windows/ptaccum frames.hdr 2> said | head -c 100 > /dev/null; cat said >&2; [ ! -s said ]
    windows/ptrace '"$office"' 2> said | head -c 100 > /dev/null; cat said >&2; [ ! -s said ]'
check_error 'what is not there' 2 '^vcmetrics: none.hdr: cannot be read: No such file' 'windows/vcmetrics none.hdr'
check_error 'an output that is an input' 1 '^ptaccum: frames.hdr: is an input as well' '
    windows/ptaccum -o frames.hdr frames.hdr'
check 'what Windows lacks is told' '
    ptaccum frames.hdr | windows/vcmetrics -max-frames 3 -control c > /dev/null 2> said && exit 1
    grep -q "^vcmetrics: c: is not a FIFO: Windows" said'
check_error 'as by -control' 2 '^ptrace: c: is not a FIFO: Windows' "windows/ptrace -control c -frames 1 $office"
check_error 'as OpenCL is' 1 '^ptrace: -device: .*without OpenCL' "windows/ptrace -device opencl -frames 1 $office"
echo '!echo' > command.rad
check_error 'as a shell is' 2 '^ptrace: command.rad:1: cannot run "echo": Windows' "
    windows/ptrace -exec -frames 1 $office command.rad"
