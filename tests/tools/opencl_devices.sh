# SPDX-License-Identifier: BSD-3-Clause
# Each OpenCL device of this machine gives the bits of the processor in five rooms, or says that it gives others.
# Where besides PoCL there is Intel's runtime for processors (Python's packages intel-opencl-rt and intel-cmplr-lib-rt),
# Mesa's rusticl or Oclgrind, name their libraries in *.icd files of a folder OCL_ICD_VENDORS.
. "${TOP:?}/tests/lib.sh"
needs ptrace
ptrace -devices | grep -o '^opencl:[0-9]*' > devices || skip 'no OpenCL device here'
office='office -vf view.vf materials.rad layout.rad'
classroom='-vf back_row.vf materials.rad room.rad furniture.rad ceiling_lights.rad outside.rad sky_afternoon.rad'
# frames NAME DEVICE FOLDER ARGUMENTS: four frames but for their headers: pixels, and the moments behind frame 0
frames() {
    (cd "$TOP/examples/scenes/$3" &&
        ptrace -device "$2" -x 48 -y 48 -frames 4 -o "$TMP/f%d.hdr" "${@:4}" 2> "$TMP/said") || return
    for f in "$TMP"/f[0-3]*.hdr; do sed '1,/^-Y/d' "$f"; done > "$TMP/$1"
    rm "$TMP"/f[0-3]*.hdr
}
for device in $(cat "$TMP/devices"); do
    while read -r room; do
        check "$device: ${room% *}" "
            frames here cpu $room; frames there $device $room
            cmp \$TMP/here \$TMP/there || grep -q '^ptrace: warning: opencl.* gives other bits' \$TMP/said"
    done << END
$office sky_1400.rad
office -action mel -action V -lamp solar=5000 ${office#office} sky_1400.rad
$office blinds.rad sky_1100.rad
$office sky_overcast.rad
classroom $classroom
gallery -vf east.vf materials.rad room.rad objects.rad sky_noon.rad
END
done
