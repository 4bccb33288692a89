# SPDX-License-Identifier: BSD-3-Clause
# Files that other files name: special ones are refused, outputs replace no inputs (docs/security.md).
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics vcregion mkstream
view='-vtv -vp 0 0 2 -vd 0 .1 -1 -vu 0 1 0 -vh 40 -vv 40 -x 8 -y 8'
printf 'void plastic mat 0 0 5 .5 .5 .5 0 0\nmat polygon floor 0 0 12 -5 -5 0 5 -5 0 5 5 0 -5 5 0\n' > good.rad
printf 'VIEW= -vtv -vp 0 0 2 -vd 0 .1 -1 -vu 0 1 0 -vh 40 -vv 40\n' > down.vf
mkfifo fifo
ln -s /proc/self/environ link
: > empty
cp "$TOP/tests/golden/glare/images/office256.hdr" office.hdr
export SECRET=word123
shown='p plastic m 0 0 5 .5 .5 .5 0 0\nm sphere s 0 0 4 0 0 0 1\n'  # a surface with the pattern p
special='fifo /dev/stdin /dev/zero /dev/null /proc/kmsg /proc/self/environ /proc/self/fd/0 /sys/kernel/vmcoreinfo link'

# 1. Region files.
for file in $special; do
    printf 'r mask %s\n' "$file" > m.regions
    for tool in "vcregion $view -o m.exr m.regions" 'vcmetrics -regions m.regions office.hdr' \
            "ptrace $view -focus m.regions -frames 2 good.rad"; do
        check_error "${tool%% *}: mask $file is refused" 1 'm.regions:1: mask .*: ".*" is not an ordinary file$' \
            "timeout 20 $tool < empty > x"
    done
done
for ending in png PNG 'exr channel r'; do
    mkfifo "f.${ending%% *}"
    printf 'r mask f.%s\n' "$ending" > m.regions
    check_error "so is a FIFO with the ending ${ending%% *}" 1 'm.regions:1: .* is not an ordinary file$' \
        'timeout 20 vcmetrics -regions m.regions office.hdr'
done
printf 'r mask -\n' > m.regions
check_error 'mask - is a file of that name' 2 'm.regions:1: mask -: cannot open "-": No such file' \
    'timeout 20 vcmetrics -regions m.regions office.hdr'

# 2. Scenes and rad input files.
for file in $special; do
    printf '!cat %s good.rad\n' "$file" > cat.rad
    printf '!xform -rz 90 %s\n' "$file" > xform.rad
    printf '!xform -f %s good.rad\n' "$file" > xform_f.rad
    printf '!genprism m p %s -l 0 0 1\n' "$file" > prism.rad
    printf '!genprism m p - -l 0 0 1 < %s\n' "$file" > prism_in.rad
    printf 'void instance i 1 %s 0 0\n' "$file" > instance.rad
    printf 'void mesh i 1 %s 0 0\n' "$file" > mesh.rad
    for scene in cat xform xform_f prism prism_in instance mesh; do
        check_error "a scene may not name $file ($scene)" 1 "^ptrace: $scene.rad:1: .*not an ordinary file" \
            "timeout 20 ptrace $view -frames 1 good.rad $scene.rad > x"
    done
    printf "void brightfunc p 2 a %s 0 0\n$shown" "$file" > func.rad
    printf "void brightdata p 4 noop %s . Px 0 0\n$shown" "$file" > data.rad
    printf "void colorpict p 7 red green blue %s . Px Py 0 0\n$shown" "$file" > pict.rad
    printf 'void BSDF m 6 0 %s 0 0 1 . 0 0\nm sphere s 0 0 4 0 0 0 1\n' "$file" > bsdf.rad
    for scene in func data pict bsdf; do
        check_error "nor as $scene" 1 "^ptrace: $scene.rad:1: .*(not an ordinary file|cannot find f)" \
            "timeout 20 ptrace $view -frames 1 good.rad $scene.rad > x"
    done
    for line in "scene= $file" "render= @$file" "render= -vf $file" "view= b -vf $file"; do
        printf 'RESOLUTION= 8\nscene= good.rad\nview= a -vf down.vf\n%s\n' "$line" > t.rif
        check_error "nor a rad input file: $line" 1 '^ptrace: t.rif: .*not an ordinary file' \
            'timeout 20 ptrace -rif t.rif -frames 1 > x'
    done
done
check 'nothing of the environment is shown' '
    for scene in xform mesh func; do ptrace $view -frames 1 good.rad $scene.rad > x 2>> said || true; done
    test -s said; ! grep -q word123 said'
printf 'void plastic mat 0 0 5 .5 .5 .5 0 0\n!xform -t 0 0 0 good.rad\n' > sub.rad
check 'ordinary files are read, in /dev/shm as well' '
    test -w /dev/shm || exit 0
    folder=$(mktemp -d /dev/shm/luxpipe-named.XXXXXX); trap "rm -r $folder" EXIT
    cp good.rad sub.rad $folder; ptrace $view -frames 1 $folder/sub.rad > x'

# 3. The command line is free.
check 'scenes, views, regions and function files by FIFO' '
    bash -c "ptrace -vf <(cat down.vf) -x 8 -y 8 -frames 1 <(cat good.rad)" > x; test -s x
    bash -c "vcmetrics -regions <(echo r circle 0 1 0 20) -metrics TAL,Ev office.hdr" > table
    (cat good.rad > fifo &); timeout 20 ptrace $view -frames 1 fifo > x'
check 'a scene from a FIFO names ordinary files' '
    bash -c "ptrace $view -frames 1 <(echo \!xform -t 0 0 0 good.rad)" > x; test -s x'
check_error 'OpenEXR from a pipe is refused, not waited for' 1 'holds a picture in the format OpenEXR: give the file' '
    mkstream frames 0 1 | ptaccum -last -o p.exr; timeout 20 bash -c "vcmetrics <(cat p.exr)"'
ends_by_one_signal() {  # COMMAND: waits for a FIFO; one SIGTERM ends it
    "$@" > x 2> said & pid=$!
    sleep 1; kill -TERM $pid
    for i in $(seq 60); do kill -0 $pid 2> /dev/null || break; sleep .1; done
    if kill -KILL $pid 2> /dev/null; then return 1; fi
    wait $pid || return $(($? != 3))
    return 1
}
check 'the first SIGTERM ends vcmetrics where it waits for a FIFO' 'ends_by_one_signal vcmetrics office.hdr fifo'
check 'also one of -A' 'ends_by_one_signal vcmetrics -A fifo office.hdr'
check 'and ptrace' 'ends_by_one_signal ptrace $view -frames 1 fifo'

# 4. Outputs replace no inputs.
mkstream frames 0 3 > frames.hdr
ptaccum -last frames.hdr -o sum.exr
ptaccum sum.exr -o sum.hdr
ptaccum sum.exr -o preview.png
ln -s office.hdr other.hdr
kept() {  # NAME FILES... COMMAND: refused with status 1, and the files stay as they were
    local name=$1 command=${*: -1}
    shift; set -- "${@:1:$#-1}"
    cat "$@" > before
    check_error "$name" 1 ': .*is an input as well' "$command"
    check 'which stays as it was' "cat $* | cmp - before"
}
kept 'vcmetrics -c' office.hdr 'vcmetrics -c office.hdr office.hdr'
kept 'by another name' office.hdr 'vcmetrics -c ./other.hdr office.hdr'
kept 'that is read later' office.hdr 'cp office.hdr first.hdr; vcmetrics -c office.hdr first.hdr office.hdr'
kept 'on the standard input' office.hdr 'vcmetrics -c office.hdr < office.hdr'
kept 'as evalglare' office.hdr 'vcmetrics -like evalglare -c office.hdr office.hdr'
kept 'ptaccum: frames' frames.hdr 'ptaccum -last frames.hdr -o frames.hdr'
kept 'frames that come later' frames.hdr 'ptaccum -last sum.exr frames.hdr -o frames.hdr'
kept 'a picture that is no sum' office.hdr 'ptaccum office.hdr -o office.hdr'
printf 'r mask office.hdr\n' > m.regions
kept 'vcregion: a mask that the regions name' office.hdr "vcregion $view -single r -o office.hdr m.regions"
cp m.regions regions.exr
kept 'the region file' regions.exr "vcregion $view -o regions.exr regions.exr"
kept 'the picture under the preview' office.hdr 'vcregion -single r -o office.hdr -o p.png -over office.hdr m.regions'
printf "void colorpict p 7 red green blue office.hdr . Px Py 0 0\n$shown\nvoid light lamp 0 0 3 1 1 1\n" > pict.rad
kept 'ptrace: a picture that the scene names' office.hdr "ptrace $view -frames 1 -o office.hdr pict.rad"
kept 'the rule of make' good.rad "ptrace $view -frames 1 -M x -MF good.rad good.rad > y"
check 'a sum may be replaced by one that contains it' '
    mkstream frames 0 1 16 16 7 2> /dev/null | ptaccum -last -o second.exr
    ptaccum sum.exr second.exr -o sum.exr; strings sum.exr | grep -q "^FRAMES=4$"
    ptaccum sum.hdr -o sum.hdr'
check_error 'nor does the standard output' 1 '^vcmetrics: office.hdr: is the file that the standard output goes to' '
    cp office.hdr grows.hdr; cp office.hdr before; vcmetrics grows.hdr >> grows.hdr || { s=$?; cmp grows.hdr before;
    sed -i s/grows/office/ .stderr; exit $s; }'

# 5. Descriptors that have run out are a failure of the system.
few() { bash -c "exec 3>&- 4>&- 5>&- 6>&- 7>&- 8>&- 9>&-; ulimit -n 4; exec $1"; }
check_exit 'OpenEXR' 2 'few "vcmetrics p.exr"'
printf 'r mask p.exr channel R\n' > m.regions
check_exit 'a mask of OpenEXR' 2 'few "vcmetrics -regions m.regions office.hdr"'
